# raylab_flags: what every target of the project is compiled with.
#
# Bits are a feature: contraction is off and fast-math never on, so that g++ and clang, one thread
# or many, give the same image (docs/architecture.md, numeric policy).
# The hard cases must hold in other numerics too, which RAYLAB_NUMERICS chooses for a whole build:
# fused multiply-adds as nvcc makes them by default, and everything the processor at hand can do.
set(RAYLAB_NUMERICS reference CACHE STRING "reference, contract (-ffp-contract=fast -mfma) or native")
set_property(CACHE RAYLAB_NUMERICS PROPERTY STRINGS reference contract native)
include(CheckCXXCompilerFlag)
check_cxx_compiler_flag(-mfma RAYLAB_KNOWS_FMA) # of x86-64; aarch64 always has it
if(RAYLAB_KNOWS_FMA)
    set(fma -mfma)
endif()
# Also for tests that are compiled so in any build. Compilers for another processor know no native one.
check_cxx_compiler_flag(-march=native RAYLAB_KNOWS_NATIVE)
if(RAYLAB_KNOWS_NATIVE)
    set(RAYLAB_NATIVE_FLAGS -march=native)
endif()
set(RAYLAB_FUSED_FLAGS -ffp-contract=fast ${RAYLAB_NATIVE_FLAGS})
if(RAYLAB_NUMERICS STREQUAL "reference")
    set(numerics -ffp-contract=off)
elseif(RAYLAB_NUMERICS STREQUAL "contract")
    set(numerics -ffp-contract=fast ${fma})
elseif(RAYLAB_NUMERICS STREQUAL "native")
    set(numerics ${RAYLAB_FUSED_FLAGS})
else()
    message(FATAL_ERROR "RAYLAB_NUMERICS is '${RAYLAB_NUMERICS}': expected reference, contract or native")
endif()

# A tree laid over this one: labs found there take the place of those here. Proves the tests of the
# labs' tasks on stubs and variations (app/course/prove.cpp).
set(RAYLAB_OVERLAY "" CACHE PATH "Folder whose labs/NN_name replaces the one here, or empty")

# The compiler may use what the processor at hand has: with contraction off the bits stay, and
# sixteen floats fit into one instruction. A program built for machines of several kinds, say the
# nodes of a cluster, wants their common part instead, such as x86-64-v3.
set(RAYLAB_ARCH native CACHE STRING "the processor to compile for: an -march of g++ or clang")
check_cxx_compiler_flag(-march=${RAYLAB_ARCH} RAYLAB_ARCH_WORKS)
if(RAYLAB_ARCH_WORKS)
    list(PREPEND numerics -march=${RAYLAB_ARCH})
elseif(NOT RAYLAB_ARCH STREQUAL "native")
    message(FATAL_ERROR "RAYLAB_ARCH is '${RAYLAB_ARCH}': the compiler does not know this processor")
endif()

# Kernels specialised on what a scene uses, or one that does for all (common/scene/variants.h).
set(RAYLAB_VARIANTS all CACHE STRING "kernel variants: all, or one that compiles fast")
set_property(CACHE RAYLAB_VARIANTS PROPERTY STRINGS all one)

option(RAYLAB_STOPS "For gdb: paths call a function where the debugger stops (common/sampling/path_stop.h)" OFF)

add_library(raylab_flags INTERFACE)
if(RAYLAB_STOPS)
    target_compile_definitions(raylab_flags INTERFACE RAYLAB_STOPS)
endif()
if(RAYLAB_VARIANTS STREQUAL "one")
    target_compile_definitions(raylab_flags INTERFACE RAYLAB_ONE_VARIANT)
endif()
target_include_directories(raylab_flags INTERFACE ${RAYLAB_OVERLAY} ${CMAKE_SOURCE_DIR})
# Stubs leave parameters and variables unused, and a student's warning should not stop the build.
# Nor should one of a compiler that nobody has tried yet.
set(strict ON)
if(APPLE)
    set(strict OFF)
endif()
option(RAYLAB_STRICT "Warnings are errors" ${strict})
if(RAYLAB_STRICT)
    set(warnings -Wall -Wextra -Werror)
else()
    set(warnings -Wall -Wextra -Wno-unused)
endif()
target_compile_options(raylab_flags INTERFACE
    "$<$<COMPILE_LANGUAGE:CXX>:${warnings};-fno-math-errno;-fno-trapping-math;${numerics}>")
# g++ 12 forgets to round where two doubles become floats and doubles again side by side, as in
# DVec3(Vec3(p)): its vectoriser of straight-line code joins them, and a later pass takes the pair of
# conversions for none. That vectoriser stays off; the one of loops does not do it.
target_compile_options(raylab_flags INTERFACE
    $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-fno-tree-slp-vectorize>)
# g++ 12 sees overlapping copies in "text" + std::string() where there are none (GCC bug 105651).
target_compile_options(raylab_flags INTERFACE
    $<$<COMPILE_LANG_AND_ID:CXX,GNU>:-Wno-restrict>)
# Release keeps its checks: assert() stays on, O3 lets the compiler vectorise the intersection loops.
set(CMAKE_CXX_FLAGS_RELEASE "-O3")

if(RAYLAB_SANITIZE STREQUAL "address")
    target_compile_options(raylab_flags INTERFACE
        $<$<COMPILE_LANGUAGE:CXX>:-fsanitize=address,undefined;-fno-sanitize-recover=undefined;-fno-omit-frame-pointer;-g1>)
    target_link_options(raylab_flags INTERFACE -fsanitize=address,undefined)
elseif(RAYLAB_SANITIZE STREQUAL "thread")
    target_compile_options(raylab_flags INTERFACE
        $<$<COMPILE_LANGUAGE:CXX>:-fsanitize=thread;-fno-omit-frame-pointer;-g1>)
    target_link_options(raylab_flags INTERFACE -fsanitize=thread)
elseif(NOT RAYLAB_SANITIZE MATCHES "^(watch)?$") # watch: of kernels alone (common/simt/CMakeLists.txt)
    message(FATAL_ERROR "RAYLAB_SANITIZE is '${RAYLAB_SANITIZE}': expected empty, address, thread or watch")
endif()
if(RAYLAB_SANITIZE STREQUAL "watch" AND NOT CMAKE_SYSTEM_NAME STREQUAL "Linux")
    message(FATAL_ERROR "the watch finds a program's variables by Linux's linker (common/simt/watch/watcher.cpp): "
                        "here, use --machine bounds and --machine races")
endif()

find_package(Threads REQUIRED)
find_package(glm REQUIRED)
find_package(fmt REQUIRED)
target_link_libraries(raylab_flags INTERFACE Threads::Threads glm::glm)
