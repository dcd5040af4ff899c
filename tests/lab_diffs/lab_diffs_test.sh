#!/usr/bin/env bash
# lab_diffs_test.sh LABS: counts what `diff -rN` of each two neighbouring labs says of their sources (.h, .cpp, .cu;
# neither tests, variations nor mistakes) and compares it with the budget below and with what the handout promises its reader.
# What two labs have in common belongs in common/: raise a budget only for a new idea.
set -euo pipefail
labs=$1
failed=0

# near SAID COUNTED: whether the two differ by a tenth at most, or by 50
near() {
    local apart=$((${1:-0} - $2))
    apart=${apart#-}
    [ -n "$1" ] && { [ "$apart" -le 50 ] || [ $((apart * 10)) -le "$2" ]; }
}

# budget OLD NEW REMOVED ADDED: at most so many lines of OLD are not in NEW, and of NEW not in OLD. The first page of
# NEW's handout says how many there are, true to a tenth.
budget() {
    local old=$1 new=$2 most_removed=$3 most_added=$4 removed added said
    local out=(-x '*.md' -x '*.json' -x CMakeLists.txt -x figures -x tests -x variations -x mistakes)
    read -r removed added < <({ diff -rN "${out[@]}" "$labs/$old" "$labs/$new" || true; } |
        awk '/^</ { r++ } /^>/ { a++ } END { print r + 0, a + 0 }')
    printf '%s -> %s: %d lines go (at most %d), %d come (at most %d)\n' \
        "$old" "$new" "$removed" "$most_removed" "$added" "$most_added"
    if [ "$removed" -gt "$most_removed" ] || [ "$added" -gt "$most_added" ]; then
        echo "  over budget: move what both labs have to common/, or make room above for a new idea"
        failed=1
    fi
    # The first page: as far as a reader gets without scrolling.
    said=$(head -n 40 "$labs/$new/README.md" | tr -s '[:space:]' ' ' |
        sed -nE "s/.*Against lab ${old%%_*}, about ([0-9]+) lines of source go and ([0-9]+) come.*/\\1 \\2/p")
    if ! near "${said% *}" "$removed" || ! near "${said#* }" "$added"; then
        echo "  labs/$new/README.md: its first 40 lines should say \"Against lab ${old%%_*}, about" \
            "$(((removed + 50) / 100 * 100)) lines of source go and $(((added + 50) / 100 * 100)) come\""
        failed=1
    fi
}

budget 01_recursive 02_iterative 800 450
budget 02_iterative 03_wavefront 400 1900
budget 03_wavefront 04_accel 1600 5300
exit $failed
