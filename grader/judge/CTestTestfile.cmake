# CMake generated Testfile for 
# Source directory: /tmp/js/grader/judge
# Build directory: /tmp/js/grader/judge
# 
# This file includes the relevant testing commands required for 
# testing this directory and lists subdirectories to be tested as well.
add_test([=[judge_test]=] "/tmp/js/grader/judge/judge_test")
set_tests_properties([=[judge_test]=] PROPERTIES  LABELS "" SKIP_RETURN_CODE "77" TIMEOUT "300" WORKING_DIRECTORY "/tmp/js" _BACKTRACE_TRIPLES "/tmp/js/cmake/RaylabTargets.cmake;43;add_test;/tmp/js/grader/judge/CMakeLists.txt;11;raylab_test;/tmp/js/grader/judge/CMakeLists.txt;0;")
add_test([=[judge_calibration_test]=] "/tmp/js/grader/judge/judge_calibration_test")
set_tests_properties([=[judge_calibration_test]=] PROPERTIES  LABELS "" SKIP_RETURN_CODE "77" TIMEOUT "1800" WORKING_DIRECTORY "/tmp/js" _BACKTRACE_TRIPLES "/tmp/js/cmake/RaylabTargets.cmake;43;add_test;/tmp/js/grader/judge/CMakeLists.txt;14;raylab_test;/tmp/js/grader/judge/CMakeLists.txt;0;")
