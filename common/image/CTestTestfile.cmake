# CMake generated Testfile for 
# Source directory: /tmp/js/common/image
# Build directory: /tmp/js/common/image
# 
# This file includes the relevant testing commands required for 
# testing this directory and lists subdirectories to be tested as well.
add_test([=[image_test]=] "/tmp/js/common/image/image_test")
set_tests_properties([=[image_test]=] PROPERTIES  LABELS "" SKIP_RETURN_CODE "77" TIMEOUT "300" WORKING_DIRECTORY "/tmp/js" _BACKTRACE_TRIPLES "/tmp/js/cmake/RaylabTargets.cmake;43;add_test;/tmp/js/common/image/CMakeLists.txt;8;raylab_test;/tmp/js/common/image/CMakeLists.txt;0;")
