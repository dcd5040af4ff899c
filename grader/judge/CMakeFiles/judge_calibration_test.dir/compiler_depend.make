# Empty compiler generated dependencies file for judge_calibration_test.
# This may be replaced when dependencies are built.
