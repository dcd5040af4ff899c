# Empty compiler generated dependencies file for raylab_judge.
# This may be replaced when dependencies are built.
