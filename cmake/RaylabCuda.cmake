# Finds nvcc (also where it is not on PATH) and chooses the architectures.
#
# Never `native`: the machine that builds may have no GPU. The list runs from sm_75 to the newest
# the toolkit knows; the newest also gets PTX, for GPUs that come later.
if(NOT CMAKE_CUDA_COMPILER AND NOT DEFINED ENV{CUDACXX})
    find_program(RAYLAB_NVCC nvcc HINTS $ENV{CUDA_HOME}/bin $ENV{CUDA_PATH}/bin /usr/local/cuda/bin
                 /opt/cuda/bin)
    if(NOT RAYLAB_NVCC)
        message(FATAL_ERROR "RAYLAB_CUDA is on, but nvcc was not found on PATH, in CUDA_HOME or in "
                            "/usr/local/cuda: install the CUDA toolkit, or use the preset 'cpu'")
    endif()
    set(CMAKE_CUDA_COMPILER ${RAYLAB_NVCC} CACHE FILEPATH "nvcc")
endif()

if(NOT CMAKE_CUDA_ARCHITECTURES)
    execute_process(COMMAND ${CMAKE_CUDA_COMPILER} --list-gpu-code OUTPUT_VARIABLE codes
                    COMMAND_ERROR_IS_FATAL ANY)
    string(REGEX MATCHALL "sm_[0-9]+" codes "${codes}")
    list(TRANSFORM codes REPLACE "sm_" "")
    list(SORT codes COMPARE NATURAL)
    list(FILTER codes EXCLUDE REGEX "^[1-6][0-9]$|^7[0-4]$")
    # One machine code per generation is enough: code for sm_X0 runs on every sm_XY.
    list(FILTER codes INCLUDE REGEX "^75$|0$|^89$")
    list(GET codes -1 newest)
    list(TRANSFORM codes APPEND "-real")
    set(CMAKE_CUDA_ARCHITECTURES "${codes};${newest}-virtual" CACHE STRING "GPU architectures")
endif()

enable_language(CUDA)
find_package(CUDAToolkit REQUIRED)
# CMake before 3.26 does not know that nvcc has C++20: the option is passed as it is.
set(CMAKE_CUDA_STANDARD_REQUIRED OFF)
target_compile_options(raylab_flags INTERFACE $<$<COMPILE_LANGUAGE:CUDA>:-std=c++20>)
set(CMAKE_CUDA_FLAGS_RELEASE "-O3 -lineinfo")
# #20012: GLM marks its defaulted constructors __device__, which nvcc remarks on at every include.
target_compile_options(raylab_flags INTERFACE
    "$<$<COMPILE_LANGUAGE:CUDA>:--expt-relaxed-constexpr;-diag-suppress=20012;-Xcompiler=-Wall,-Wextra,-ffp-contract=off,-fno-tree-slp-vectorize>")
target_compile_definitions(raylab_flags INTERFACE RAYLAB_CUDA=1)

option(RAYLAB_CUDA_EXACT "Kernels aim at the CPU's bits: no fused multiply-add" OFF)
if(RAYLAB_CUDA_EXACT)
    target_compile_options(raylab_flags INTERFACE $<$<COMPILE_LANGUAGE:CUDA>:--fmad=false>)
endif()
