# Empty compiler generated dependencies file for judge_test.
# This may be replaced when dependencies are built.
