# Empty dependencies file for raylab_image.
# This may be replaced when dependencies are built.
