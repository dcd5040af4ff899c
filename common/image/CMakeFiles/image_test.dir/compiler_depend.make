# Empty compiler generated dependencies file for image_test.
# This may be replaced when dependencies are built.
