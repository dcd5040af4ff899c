# CMake generated Testfile for 
# Source directory: /tmp/js/grader/report
# Build directory: /tmp/js/grader/report
# 
# This file includes the relevant testing commands required for 
# testing this directory and lists subdirectories to be tested as well.
add_test([=[report_test]=] "/tmp/js/grader/report/report_test")
set_tests_properties([=[report_test]=] PROPERTIES  LABELS "" SKIP_RETURN_CODE "77" TIMEOUT "300" WORKING_DIRECTORY "/tmp/js" _BACKTRACE_TRIPLES "/tmp/js/cmake/RaylabTargets.cmake;43;add_test;/tmp/js/grader/report/CMakeLists.txt;14;raylab_test;/tmp/js/grader/report/CMakeLists.txt;0;")
