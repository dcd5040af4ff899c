# Third-party packages from third_party/, where `./raylab vendor` has collected them: then the system
# need have nothing but the toolchain (docs/vendor.md).
set(RAYLAB_VENDOR ${CMAKE_SOURCE_DIR}/third_party CACHE PATH "Folder that `raylab vendor` wrote; used if there")
if(NOT EXISTS ${RAYLAB_VENDOR}/packages.txt)
    return()
endif()
message(STATUS "Third-party packages: ${RAYLAB_VENDOR}")

file(GLOB libraries ${RAYLAB_VENDOR}/usr/lib/*-linux-gnu*)
get_filename_component(triplet "${libraries}" NAME)
if(NOT triplet MATCHES "^${CMAKE_SYSTEM_PROCESSOR}")
    message(FATAL_ERROR "${RAYLAB_VENDOR} was collected on another kind of processor (${triplet}) than this "
                        "machine's ${CMAKE_SYSTEM_PROCESSOR}: run ./raylab vendor on one like this")
endif()
file(READ ${RAYLAB_VENDOR}/packages.txt collected)
file(READ ${CMAKE_CURRENT_LIST_DIR}/../packages.txt wanted)
if(NOT collected STREQUAL wanted)
    message(WARNING "packages.txt has changed since ${RAYLAB_VENDOR} was collected: "
                    "run ./raylab vendor again where the packages are installed")
endif()

list(PREPEND CMAKE_PREFIX_PATH ${RAYLAB_VENDOR}/usr)
set(CMAKE_LIBRARY_ARCHITECTURE ${triplet}) # compilers other than Debian's do not set it
set(PKG_CONFIG_EXECUTABLE ${RAYLAB_VENDOR}/bin/pkg-config)
include_directories(SYSTEM ${RAYLAB_VENDOR}/usr/include)
# Found by programs, and (an RPATH, unlike a RUNPATH) by the libraries that they load.
list(APPEND CMAKE_BUILD_RPATH ${libraries})
add_link_options(-Wl,--disable-new-dtags)
