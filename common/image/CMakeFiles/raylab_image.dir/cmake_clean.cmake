file(REMOVE_RECURSE
  "CMakeFiles/raylab_image.dir/exr.cpp.o"
  "CMakeFiles/raylab_image.dir/exr.cpp.o.d"
  "CMakeFiles/raylab_image.dir/hdr.cpp.o"
  "CMakeFiles/raylab_image.dir/hdr.cpp.o.d"
  "CMakeFiles/raylab_image.dir/image_file.cpp.o"
  "CMakeFiles/raylab_image.dir/image_file.cpp.o.d"
  "CMakeFiles/raylab_image.dir/pfm.cpp.o"
  "CMakeFiles/raylab_image.dir/pfm.cpp.o.d"
  "CMakeFiles/raylab_image.dir/png.cpp.o"
  "CMakeFiles/raylab_image.dir/png.cpp.o.d"
  "libraylab_image.a"
  "libraylab_image.pdb"
)

# Per-language clean rules from dependency scanning.
foreach(lang CXX)
  include(CMakeFiles/raylab_image.dir/cmake_clean_${lang}.cmake OPTIONAL)
endforeach()
