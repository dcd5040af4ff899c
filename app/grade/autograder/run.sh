#!/usr/bin/env bash
# Grades one submission of lab @LAB@ where @PLATFORM@ has put it.
#     @RUN@ [ROOT [SOURCE [LIMIT]]]      ROOT: the platform's folder; SOURCE: where setup.sh has run;
#                                         LIMIT: seconds for the whole submission
# It ends with exit code 0 whatever happens: the file of results says what has happened.
set -u
root=${1:-@ROOT@}
source=${2:-@SOURCE@}
limit=${3:-@LIMIT@}
results=$root/results/results.json

# Until there are marks the file says INTERNAL. It appears complete or not at all, as the grader's files do.
mkdir -p "$root/results"
cp "$source/internal.json" "$results.part" && mv "$results.part" "$results"

# Where this machine has unpacked an image, each source has a new time of change, and the script would compile all
# of them again. It compares those times with this file's.
touch -c "$source/tree/build/cpu/.ninja_log"

work=$(mktemp -d) # for its owner alone: a submission must not read another one's report
status=0
timeout -k 10 "$limit" "$source/tree/raylab" grade @LAB@ "$root/@SUBMISSION@" -o "$work" --key "$source/key" \
    --write "@FORMAT@:$results" </dev/null || status=$?
case $status in
    0 | 1) ;;
    124 | 137) echo "raylab was ended after $limit s" >&2 ;;
    *) echo "raylab ended with exit code $status" >&2 ;;
esac
exit 0
