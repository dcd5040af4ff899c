file(REMOVE_RECURSE
  "libraylab_judge.a"
)
