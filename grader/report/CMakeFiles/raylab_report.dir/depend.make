# Empty dependencies file for raylab_report.
# This may be replaced when dependencies are built.
