
# Consider dependencies only in project.
set(CMAKE_DEPENDS_IN_PROJECT_ONLY OFF)

# The set of languages for which implicit dependencies are needed:
set(CMAKE_DEPENDS_LANGUAGES
  )

# The set of dependency files which are needed:
set(CMAKE_DEPENDS_DEPENDENCY_FILES
  "/tmp/js/common/image/exr.cpp" "common/image/CMakeFiles/raylab_image.dir/exr.cpp.o" "gcc" "common/image/CMakeFiles/raylab_image.dir/exr.cpp.o.d"
  "/tmp/js/common/image/hdr.cpp" "common/image/CMakeFiles/raylab_image.dir/hdr.cpp.o" "gcc" "common/image/CMakeFiles/raylab_image.dir/hdr.cpp.o.d"
  "/tmp/js/common/image/image_file.cpp" "common/image/CMakeFiles/raylab_image.dir/image_file.cpp.o" "gcc" "common/image/CMakeFiles/raylab_image.dir/image_file.cpp.o.d"
  "/tmp/js/common/image/pfm.cpp" "common/image/CMakeFiles/raylab_image.dir/pfm.cpp.o" "gcc" "common/image/CMakeFiles/raylab_image.dir/pfm.cpp.o.d"
  "/tmp/js/common/image/png.cpp" "common/image/CMakeFiles/raylab_image.dir/png.cpp.o" "gcc" "common/image/CMakeFiles/raylab_image.dir/png.cpp.o.d"
  )

# Targets to which this target links.
set(CMAKE_TARGET_LINKED_INFO_FILES
  "/tmp/js/common/cli/CMakeFiles/raylab_cli.dir/DependInfo.cmake"
  )

# Fortran module output directory.
set(CMAKE_Fortran_TARGET_MODULE_DIR "")
