#!/usr/bin/env bash
# tidy.sh BUILD PATTERN [CLANG-TIDY OPTIONS]: no finding of clang-tidy in what was built in the folder
# BUILD and whose object's name matches PATTERN. Files that were compiled together are read together.
set -euo pipefail
build=$1 pattern=$2
shift 2
command -v clang-tidy >/dev/null || { echo "skipped: there is no clang-tidy here"; exit 77; }

# Of the compile commands those that Ninja has: files compiled together are listed one by one as well.
mapfile -t sources < <(ninja -C "$build" -t targets all | sed -n 's/^\(.*\.o\): CXX_COMPILER.*/\1/p' |
    grep -E "$pattern" | grep -v third_party | while read -r object; do
        [ -f "$build/$object" ] || continue
        ninja -C "$build" -t query "$object" | sed -n 's/^    \(\/[^ ]*\.\(cpp\|cxx\|cu\)\)$/\1/p' | head -n 1
    done | sort -u)
[ ${#sources[@]} -gt 0 ] || { echo "no file matches '$pattern' in $build" >&2; exit 1; }

found=$(mktemp)
trap 'rm -f "$found"' EXIT
printf '%s\0' "${sources[@]}" |
    xargs -0 -n 1 -P "$(nproc)" clang-tidy -p "$build" --quiet "$@" >"$found" 2>/dev/null ||
    { sort -u "$found" | grep -E 'error:|warning:' >&2 || cat "$found" >&2; exit 1; }
echo "clang-tidy: nothing found in ${#sources[@]} files"
