# raylab_kernel_sources(<target> <file.cu>...): adds CUDA sources to a target, for the machine that
# is built for: as they are with RAYLAB_CUDA, else rewritten for the host compiler and linked with
# the CPU machine. Paths are relative to the current folder.
function(raylab_kernel_sources target)
    target_link_libraries(${target} PRIVATE raylab_simt)
    foreach(file IN LISTS ARGN)
        get_filename_component(source ${file} ABSOLUTE)
        if(RAYLAB_CUDA)
            target_sources(${target} PRIVATE ${source})
            set_source_files_properties(${source} PROPERTIES LANGUAGE CUDA)
            continue()
        endif()
        # Errors and reports name the file as seen from the root of the project.
        file(RELATIVE_PATH name ${CMAKE_SOURCE_DIR} ${source})
        if(name MATCHES "^\\.\\./")
            set(name ${source})
        endif()
        get_filename_component(folder ${source} DIRECTORY)
        string(MAKE_C_IDENTIFIER ${name} stem)
        set(out ${CMAKE_CURRENT_BINARY_DIR}/${target}_${stem}.cpp)
        add_custom_command(OUTPUT ${out} COMMAND simt_rewrite ${source} ${out} ${name}
                           DEPENDS ${source} simt_rewrite VERBATIM
                           COMMENT "Rewriting ${name} for the CPU machine")
        # Headers beside the .cu are found. #pragma unroll is for nvcc, comparing an int with
        # blockDim.x is everybody's habit, and g++ takes a file with #line for a header.
        set_source_files_properties(${out} PROPERTIES COMPILE_OPTIONS
            "-iquote;${folder};-Wno-unknown-pragmas;-Wno-sign-compare;$<$<CXX_COMPILER_ID:GNU>:-Wno-subobject-linkage>")
        target_sources(${target} PRIVATE ${out})
        raylab_show_editor(${target} ${source})
    endforeach()
endfunction()

# raylab_show_editor(<target> <file.cu>): a line of compile_commands.json for the file itself, by which clangd
# reads it as CUDA with the CPU machine's headers (editor.h). Nothing is ever built from it.
function(raylab_show_editor target source)
    set(editor ${target}_in_editor)
    if(NOT TARGET ${editor})
        add_library(${editor} OBJECT EXCLUDE_FROM_ALL)
        target_link_libraries(${editor} PRIVATE $<TARGET_PROPERTY:${target},LINK_LIBRARIES>)
        target_compile_options(${editor} PRIVATE
            "SHELL:-x cuda" --cuda-device-only -nocudainc -nocudalib
            "SHELL:-Xclang -fcuda-allow-variadic-functions" "SHELL:-include ${CMAKE_SOURCE_DIR}/common/simt/editor.h"
            -Wno-unknown-cuda-version -Wno-unknown-pragmas -Wno-sign-compare)
    endif()
    target_sources(${editor} PRIVATE ${source})
    set_source_files_properties(${source} PROPERTIES LANGUAGE CXX)
endfunction()
