file(REMOVE_RECURSE
  "CMakeFiles/report_test.dir/tests/report_test.cpp.o"
  "CMakeFiles/report_test.dir/tests/report_test.cpp.o.d"
  "report_test"
  "report_test.pdb"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/report_test.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
