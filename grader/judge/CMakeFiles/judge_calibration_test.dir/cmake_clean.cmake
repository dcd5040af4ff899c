file(REMOVE_RECURSE
  "CMakeFiles/judge_calibration_test.dir/tests/calibration_test.cpp.o"
  "CMakeFiles/judge_calibration_test.dir/tests/calibration_test.cpp.o.d"
  "judge_calibration_test"
  "judge_calibration_test.pdb"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/judge_calibration_test.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
