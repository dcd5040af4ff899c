file(REMOVE_RECURSE
  "CMakeFiles/raylab_report.dir/html.cpp.o"
  "CMakeFiles/raylab_report.dir/html.cpp.o.d"
  "CMakeFiles/raylab_report.dir/page.cpp.o"
  "CMakeFiles/raylab_report.dir/page.cpp.o.d"
  "CMakeFiles/raylab_report.dir/page_parts.cpp.o"
  "CMakeFiles/raylab_report.dir/page_parts.cpp.o.d"
  "CMakeFiles/raylab_report.dir/report.cpp.o"
  "CMakeFiles/raylab_report.dir/report.cpp.o.d"
  "libraylab_report.a"
  "libraylab_report.pdb"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/raylab_report.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
