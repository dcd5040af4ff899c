#!/usr/bin/env bash
# editor_test.sh CLANGD BUILD FILE...: clangd has no diagnostic for any of the files, when it reads
# BUILD/compile_commands.json. Without the flags for CUDA in there it has one, or the test is blind.
set -euo pipefail

clangd=$1 build=$2
shift 2
if [ ! -x "$clangd" ]; then
    echo "clangd is not installed"
    exit 77
fi
scratch=$(mktemp -d)
trap 'rm -rf "$scratch"' EXIT
failures=0

# diagnostics DATABASE FILE: the lines of clangd's report that say "[kind] Line 12: ...". Completion
# and go-to-definition at every place are not asked for: they take minutes.
diagnostics() {
    local report=$scratch/report
    "$clangd" --check="$2" --check-lines=1 --compile-commands-dir="$1" --log=info >"$report" 2>&1 || true
    grep -q 'All checks completed' "$report" || echo "clangd did not come to the end of the file"
    grep -E '\] Line [0-9]+:' "$report" || true
}

for file in "$@"; do
    found=$(diagnostics "$build" "$file")
    [ -z "$found" ] && continue
    printf '%s:\n%s\n' "$file" "$found"
    failures=$((failures + 1))
done

# What the test is for: the same file as plain C++.
sed 's/-x cuda//; s/-include [^ ]*editor\.h//; s/--cuda-device-only//' "$build/compile_commands.json" \
    >"$scratch/compile_commands.json"
if [ -z "$(diagnostics "$scratch" "$1")" ]; then
    echo "clangd has nothing against $1 without the flags for CUDA: this test sees nothing"
    failures=$((failures + 1))
fi

[ "$failures" = 0 ] || { echo "$failures failed"; exit 1; }
echo "editors: no diagnostic in $# files"
