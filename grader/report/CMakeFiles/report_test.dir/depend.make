# Empty dependencies file for report_test.
# This may be replaced when dependencies are built.
