file(REMOVE_RECURSE
  "CMakeFiles/judge_test.dir/tests/distributions_test.cpp.o"
  "CMakeFiles/judge_test.dir/tests/distributions_test.cpp.o.d"
  "CMakeFiles/judge_test.dir/tests/exactness_test.cpp.o"
  "CMakeFiles/judge_test.dir/tests/exactness_test.cpp.o.d"
  "CMakeFiles/judge_test.dir/tests/power_test.cpp.o"
  "CMakeFiles/judge_test.dir/tests/power_test.cpp.o.d"
  "judge_test"
  "judge_test.pdb"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/judge_test.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
