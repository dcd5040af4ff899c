#!/usr/bin/env bash
# references_test.sh RAYLAB SCENES: renders each scene that has a reference, and compares the two. A
# correct image is called different once in 1000; with the scenes' own seeds the answer is the same
# every time.
set -euo pipefail

raylab=$1 scenes=$2
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failures=0 count=0

for reference in "$scenes"/references/*.exr; do
    name=$(basename "$reference" .exr)
    count=$((count + 1))
    "$raylab" render 04 "$name" -q -o "$scratch/image.exr"
    "$raylab" compare "$scratch/image.exr" "$reference" >"$scratch/said" && continue
    echo "$name: $(head -n 1 "$scratch/said")"
    failures=$((failures + 1))
done

[ "$count" -ge 20 ] || { echo "only $count references in $scenes/references"; exit 1; }
[ "$failures" = 0 ] || { echo "$failures of $count scenes do not look as their references"; exit 1; }
echo "$count scenes look as their references"
