# The few helpers that the folders' CMakeLists.txt use.

# Adds every folder below the given ones that has a CMakeLists.txt: first the direct children, in
# alphabetical order, except that common/simt comes first because it defines raylab_kernel_sources.
function(raylab_add_folders)
    if(EXISTS ${CMAKE_SOURCE_DIR}/common/simt/CMakeLists.txt)
        add_subdirectory(common/simt)
    endif()
    foreach(folder IN LISTS ARGN)
        file(GLOB lists CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/${folder}/CMakeLists.txt
             ${CMAKE_SOURCE_DIR}/${folder}/*/CMakeLists.txt)
        foreach(list IN LISTS lists)
            get_filename_component(dir ${list} DIRECTORY)
            file(RELATIVE_PATH dir ${CMAKE_SOURCE_DIR} ${dir})
            if(RAYLAB_OVERLAY AND EXISTS ${RAYLAB_OVERLAY}/${dir}/CMakeLists.txt)
                add_subdirectory(${RAYLAB_OVERLAY}/${dir} ${dir})
            elseif(NOT dir STREQUAL "common/simt")
                add_subdirectory(${dir})
            endif()
        endforeach()
    endforeach()
endfunction()

# raylab_library(<name> SOURCES ... LIBS ...): a static library of the project.
function(raylab_library name)
    cmake_parse_arguments(arg "" "" "SOURCES;LIBS" ${ARGN})
    add_library(${name} STATIC ${arg_SOURCES})
    target_link_libraries(${name} PUBLIC raylab_flags ${arg_LIBS})
endfunction()

# raylab_header(<target> <header> <address>): lets the target include a library that is a header and nothing
# else. Debian has packages for those, Homebrew has none.
function(raylab_header target header address)
    string(MAKE_C_IDENTIFIER RAYLAB_FOLDER_OF_${header} folder)
    find_path(${folder} ${header})
    mark_as_advanced(${folder})
    if(NOT ${folder})
        message(FATAL_ERROR "The header ${header} was not found: install the packages of packages.txt; where there "
                            "is none for it, copy the header from ${address} to /usr/local/include")
    endif()
    target_include_directories(${target} SYSTEM PRIVATE ${${folder}})
endfunction()

# raylab_test(<name> SOURCES ... LIBS ... [LABELS ...] [OPTIONS ...]): a GoogleTest program, one ctest entry.
# OPTIONS are extra compiler flags, for tests that must hold in other builds (contraction, native).
function(raylab_test name)
    if(NOT RAYLAB_TESTS)
        return()
    endif()
    cmake_parse_arguments(arg "" "TIMEOUT" "SOURCES;LIBS;LABELS;OPTIONS" ${ARGN})
    find_package(GTest REQUIRED)
    add_executable(${name} ${arg_SOURCES})
    if(RAYLAB_WITNESS)
        # By itself: in a file with the tests it would share the macros of what they include.
        set_source_files_properties(${CMAKE_SOURCE_DIR}/grader/witness/witness.cpp
                                    PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
        target_sources(${name} PRIVATE ${CMAKE_SOURCE_DIR}/grader/witness/witness.cpp)
    endif()
    # Options of linked libraries come after a target's own: linked last, these have the last word.
    raylab_compile_together(${name})
    add_library(${name}_options INTERFACE)
    target_compile_options(${name}_options INTERFACE ${arg_OPTIONS})
    target_link_libraries(${name} PRIVATE raylab_flags ${arg_LIBS} GTest::gtest GTest::gtest_main
                          ${name}_options)
    add_test(NAME ${name} COMMAND ${name} WORKING_DIRECTORY ${CMAKE_SOURCE_DIR})
    if(NOT arg_TIMEOUT)
        set(arg_TIMEOUT 1800) # the long counts of `raylab test --long` take minutes
    endif()
    set_tests_properties(${name} PROPERTIES LABELS "${arg_LABELS}" TIMEOUT ${arg_TIMEOUT} SKIP_RETURN_CODE 77)
endfunction()

# raylab_task_tests(<name> SOURCES ... LIBS ...): the tests of a lab's tasks, as students get them:
# built also where the project's own tests are not.
function(raylab_task_tests name)
    set(RAYLAB_TESTS ON) # in this function
    raylab_test(${name} ${ARGN} LABELS tasks)
endfunction()

# raylab_compile_together(<target>...): eight files at a time are one to the compiler, which reads their
# headers once: for text, JSON and tests the headers cost more than the files. So the files of such a
# target share one anonymous namespace. What students edit is compiled file by file.
function(raylab_compile_together)
    foreach(target IN LISTS ARGN)
        if(TARGET ${target})
            set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_BATCH_SIZE 8)
        endif()
    endforeach()
endfunction()

# raylab_compile_fast(<target>...): where text is read and written and no ray is traced, -O1 runs as
# fast as -O3 and compiles in two thirds of its time.
function(raylab_compile_fast)
    foreach(target IN LISTS ARGN)
        if(TARGET ${target})
            target_compile_options(${target} PRIVATE $<$<CONFIG:Release>:-O1>)
        endif()
    endforeach()
endfunction()
