
# Consider dependencies only in project.
set(CMAKE_DEPENDS_IN_PROJECT_ONLY OFF)

# The set of languages for which implicit dependencies are needed:
set(CMAKE_DEPENDS_LANGUAGES
  )

# The set of dependency files which are needed:
set(CMAKE_DEPENDS_DEPENDENCY_FILES
  "/tmp/js/grader/report/html.cpp" "grader/report/CMakeFiles/raylab_report.dir/html.cpp.o" "gcc" "grader/report/CMakeFiles/raylab_report.dir/html.cpp.o.d"
  "/tmp/js/grader/report/page.cpp" "grader/report/CMakeFiles/raylab_report.dir/page.cpp.o" "gcc" "grader/report/CMakeFiles/raylab_report.dir/page.cpp.o.d"
  "/tmp/js/grader/report/page_parts.cpp" "grader/report/CMakeFiles/raylab_report.dir/page_parts.cpp.o" "gcc" "grader/report/CMakeFiles/raylab_report.dir/page_parts.cpp.o.d"
  "/tmp/js/grader/report/report.cpp" "grader/report/CMakeFiles/raylab_report.dir/report.cpp.o" "gcc" "grader/report/CMakeFiles/raylab_report.dir/report.cpp.o.d"
  )

# Targets to which this target links.
set(CMAKE_TARGET_LINKED_INFO_FILES
  "/tmp/js/common/cli/CMakeFiles/raylab_cli.dir/DependInfo.cmake"
  "/tmp/js/common/image/CMakeFiles/raylab_image.dir/DependInfo.cmake"
  "/tmp/js/grader/judge/CMakeFiles/raylab_judge.dir/DependInfo.cmake"
  )

# Fortran module output directory.
set(CMAKE_Fortran_TARGET_MODULE_DIR "")
