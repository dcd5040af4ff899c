file(REMOVE_RECURSE
  "libraylab_image.a"
)
