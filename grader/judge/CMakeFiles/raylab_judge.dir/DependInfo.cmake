
# Consider dependencies only in project.
set(CMAKE_DEPENDS_IN_PROJECT_ONLY OFF)

# The set of languages for which implicit dependencies are needed:
set(CMAKE_DEPENDS_LANGUAGES
  )

# The set of dependency files which are needed:
set(CMAKE_DEPENDS_DEPENDENCY_FILES
  "/tmp/js/grader/judge/compare.cpp" "grader/judge/CMakeFiles/raylab_judge.dir/compare.cpp.o" "gcc" "grader/judge/CMakeFiles/raylab_judge.dir/compare.cpp.o.d"
  "/tmp/js/grader/judge/distributions.cpp" "grader/judge/CMakeFiles/raylab_judge.dir/distributions.cpp.o" "gcc" "grader/judge/CMakeFiles/raylab_judge.dir/distributions.cpp.o.d"
  "/tmp/js/grader/judge/exact.cpp" "grader/judge/CMakeFiles/raylab_judge.dir/exact.cpp.o" "gcc" "grader/judge/CMakeFiles/raylab_judge.dir/exact.cpp.o.d"
  "/tmp/js/grader/judge/honesty.cpp" "grader/judge/CMakeFiles/raylab_judge.dir/honesty.cpp.o" "gcc" "grader/judge/CMakeFiles/raylab_judge.dir/honesty.cpp.o.d"
  "/tmp/js/grader/judge/independent.cpp" "grader/judge/CMakeFiles/raylab_judge.dir/independent.cpp.o" "gcc" "grader/judge/CMakeFiles/raylab_judge.dir/independent.cpp.o.d"
  "/tmp/js/grader/judge/json.cpp" "grader/judge/CMakeFiles/raylab_judge.dir/json.cpp.o" "gcc" "grader/judge/CMakeFiles/raylab_judge.dir/json.cpp.o.d"
  "/tmp/js/grader/judge/metrics.cpp" "grader/judge/CMakeFiles/raylab_judge.dir/metrics.cpp.o" "gcc" "grader/judge/CMakeFiles/raylab_judge.dir/metrics.cpp.o.d"
  "/tmp/js/grader/judge/moments.cpp" "grader/judge/CMakeFiles/raylab_judge.dir/moments.cpp.o" "gcc" "grader/judge/CMakeFiles/raylab_judge.dir/moments.cpp.o.d"
  "/tmp/js/grader/judge/same_paths.cpp" "grader/judge/CMakeFiles/raylab_judge.dir/same_paths.cpp.o" "gcc" "grader/judge/CMakeFiles/raylab_judge.dir/same_paths.cpp.o.d"
  "/tmp/js/grader/judge/screening.cpp" "grader/judge/CMakeFiles/raylab_judge.dir/screening.cpp.o" "gcc" "grader/judge/CMakeFiles/raylab_judge.dir/screening.cpp.o.d"
  "/tmp/js/grader/judge/soundness.cpp" "grader/judge/CMakeFiles/raylab_judge.dir/soundness.cpp.o" "gcc" "grader/judge/CMakeFiles/raylab_judge.dir/soundness.cpp.o.d"
  "/tmp/js/grader/judge/tiles.cpp" "grader/judge/CMakeFiles/raylab_judge.dir/tiles.cpp.o" "gcc" "grader/judge/CMakeFiles/raylab_judge.dir/tiles.cpp.o.d"
  "/tmp/js/grader/judge/welch.cpp" "grader/judge/CMakeFiles/raylab_judge.dir/welch.cpp.o" "gcc" "grader/judge/CMakeFiles/raylab_judge.dir/welch.cpp.o.d"
  )

# Targets to which this target links.
set(CMAKE_TARGET_LINKED_INFO_FILES
  )

# Fortran module output directory.
set(CMAKE_Fortran_TARGET_MODULE_DIR "")
