#!/usr/bin/env bash
# Collects the packages into a temporary folder and builds a small project with them, on a machine that
# has the system's copies too: not one header and not one library of the system's may be used.
set -euo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
root=$here/../..
command -v dpkg-query >/dev/null || exit 77
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
vendor() { "$root/cmake/vendor.sh" -o "$scratch/third_party" "$@" 2>"$scratch/said"; }
failed() { printf 'FAILED: %s\n' "$1"; [ $# -lt 2 ] || cat "$2"; exit 1; }

# A package that is not installed is named, with what to do.
mkdir "$scratch/bin"
cat >"$scratch/bin/dpkg-query" <<'FAKE'
#!/bin/sh
case "$*" in *db:Status*libfmt-dev) exit 1 ;; esac
exec /usr/bin/dpkg-query "$@"
FAKE
chmod +x "$scratch/bin/dpkg-query"
status=0
PATH=$scratch/bin:$PATH vendor || status=$?
[ $status -eq 2 ] || failed "a missing package gave exit code $status, not 2" "$scratch/said"
grep -q 'not installed:.*apt-get install.* libfmt-dev\|apt-get install libfmt-dev' "$scratch/said" ||
    failed "the missing package is not named" "$scratch/said"

# A folder that somebody else made stays.
mkdir "$scratch/third_party"
touch "$scratch/third_party/precious"
status=0
vendor || status=$?
[ $status -eq 2 ] && [ -e "$scratch/third_party/precious" ] || failed "somebody's folder was replaced"
rm -r "$scratch/third_party"

vendor >/dev/null || failed "collecting" "$scratch/said"
# And lies elsewhere than where it was collected.
mkdir "$scratch/other"
mv "$scratch/third_party" "$scratch/other/"
third_party=$scratch/other/third_party
[ "$(du -sm "$third_party" | cut -f 1)" -le 50 ] || failed "more than 50 MB"
[ -z "$(find "$third_party" -xtype l)" ] || failed "links that lead nowhere"

{ cmake -S "$here/project" -B "$scratch/build" -G Ninja -DRAYLAB_VENDOR="$third_party" \
    -DMODULES="$root/cmake" && cmake --build "$scratch/build"; } >"$scratch/log" 2>&1 ||
    failed "the small project" "$scratch/log"
"$scratch/build/uses_all" || failed "the small program"

# A package that CMake found in the system?
! grep '^[^ ]*_DIR:PATH=/usr' "$scratch/build/CMakeCache.txt" >"$scratch/packages" ||
    failed "packages of the system's:" "$scratch/packages"
# A header that was collected, and yet read from the system?
ninja -C "$scratch/build" -t deps | sed -n 's,^ */usr/include/,,p' | while read -r header; do
    [ ! -e "$third_party/usr/include/$header" ] || echo "/usr/include/$header"
done >"$scratch/headers"
[ ! -s "$scratch/headers" ] || failed "headers of the system's:" "$scratch/headers"
ldd "$scratch/build/uses_all" | sed -n 's,.* => \(/[^ ]*\) .*,\1,p' | grep -v "^$third_party/" |
    while read -r library; do
        [ ! -e "$third_party/usr/lib/$(c++ -print-multiarch)/${library##*/}" ] || echo "$library"
    done >"$scratch/libraries"
[ ! -s "$scratch/libraries" ] || failed "libraries of the system's:" "$scratch/libraries"
echo "collected packages: whole, and used"
