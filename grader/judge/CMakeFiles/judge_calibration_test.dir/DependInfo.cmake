
# Consider dependencies only in project.
set(CMAKE_DEPENDS_IN_PROJECT_ONLY OFF)

# The set of languages for which implicit dependencies are needed:
set(CMAKE_DEPENDS_LANGUAGES
  )

# The set of dependency files which are needed:
set(CMAKE_DEPENDS_DEPENDENCY_FILES
  "/tmp/js/grader/judge/tests/calibration_test.cpp" "grader/judge/CMakeFiles/judge_calibration_test.dir/tests/calibration_test.cpp.o" "gcc" "grader/judge/CMakeFiles/judge_calibration_test.dir/tests/calibration_test.cpp.o.d"
  )

# Targets to which this target links.
set(CMAKE_TARGET_LINKED_INFO_FILES
  "/tmp/js/grader/judge/CMakeFiles/raylab_judge.dir/DependInfo.cmake"
  )

# Fortran module output directory.
set(CMAKE_Fortran_TARGET_MODULE_DIR "")
