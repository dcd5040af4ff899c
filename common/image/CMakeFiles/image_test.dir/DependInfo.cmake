
# Consider dependencies only in project.
set(CMAKE_DEPENDS_IN_PROJECT_ONLY OFF)

# The set of languages for which implicit dependencies are needed:
set(CMAKE_DEPENDS_LANGUAGES
  )

# The set of dependency files which are needed:
set(CMAKE_DEPENDS_DEPENDENCY_FILES
  "/tmp/js/common/image/tests/image_file_test.cpp" "common/image/CMakeFiles/image_test.dir/tests/image_file_test.cpp.o" "gcc" "common/image/CMakeFiles/image_test.dir/tests/image_file_test.cpp.o.d"
  )

# Targets to which this target links.
set(CMAKE_TARGET_LINKED_INFO_FILES
  "/tmp/js/common/image/CMakeFiles/raylab_image.dir/DependInfo.cmake"
  "/tmp/js/common/cli/CMakeFiles/raylab_cli.dir/DependInfo.cmake"
  )

# Fortran module output directory.
set(CMAKE_Fortran_TARGET_MODULE_DIR "")
