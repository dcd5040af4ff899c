file(REMOVE_RECURSE
  "CMakeFiles/raylab_judge.dir/compare.cpp.o"
  "CMakeFiles/raylab_judge.dir/compare.cpp.o.d"
  "CMakeFiles/raylab_judge.dir/distributions.cpp.o"
  "CMakeFiles/raylab_judge.dir/distributions.cpp.o.d"
  "CMakeFiles/raylab_judge.dir/exact.cpp.o"
  "CMakeFiles/raylab_judge.dir/exact.cpp.o.d"
  "CMakeFiles/raylab_judge.dir/honesty.cpp.o"
  "CMakeFiles/raylab_judge.dir/honesty.cpp.o.d"
  "CMakeFiles/raylab_judge.dir/independent.cpp.o"
  "CMakeFiles/raylab_judge.dir/independent.cpp.o.d"
  "CMakeFiles/raylab_judge.dir/json.cpp.o"
  "CMakeFiles/raylab_judge.dir/json.cpp.o.d"
  "CMakeFiles/raylab_judge.dir/metrics.cpp.o"
  "CMakeFiles/raylab_judge.dir/metrics.cpp.o.d"
  "CMakeFiles/raylab_judge.dir/moments.cpp.o"
  "CMakeFiles/raylab_judge.dir/moments.cpp.o.d"
  "CMakeFiles/raylab_judge.dir/same_paths.cpp.o"
  "CMakeFiles/raylab_judge.dir/same_paths.cpp.o.d"
  "CMakeFiles/raylab_judge.dir/screening.cpp.o"
  "CMakeFiles/raylab_judge.dir/screening.cpp.o.d"
  "CMakeFiles/raylab_judge.dir/soundness.cpp.o"
  "CMakeFiles/raylab_judge.dir/soundness.cpp.o.d"
  "CMakeFiles/raylab_judge.dir/tiles.cpp.o"
  "CMakeFiles/raylab_judge.dir/tiles.cpp.o.d"
  "CMakeFiles/raylab_judge.dir/welch.cpp.o"
  "CMakeFiles/raylab_judge.dir/welch.cpp.o.d"
  "libraylab_judge.a"
  "libraylab_judge.pdb"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/raylab_judge.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
