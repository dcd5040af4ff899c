file(REMOVE_RECURSE
  "libraylab_report.a"
)
