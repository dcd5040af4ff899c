#!/usr/bin/env bash
# The script ./raylab with a small project, in trees that are copied, moved, linked, put back from copies or
# configured by halves: what it judges must be the tree it stands in, and what did not run has not passed.
set -uo pipefail
here=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd)
root=$(cd -- "$here/../.." && pwd)
scratch=$(mktemp -d)
scratch=$(cd -- "$scratch" && pwd -P)
trap 'rm -rf -- "$scratch"' EXIT
cd -- "$scratch" || exit 3 # called from within another tree, a link would be refused
unset RAYLAB_PRESET CMAKE_PREFIX_PATH CXX
failures=0

make_tree() {
    cp -r "$here/project" "$1"
    mkdir -p "$1/cmake" "$1/common" "$1/grader"
    cp "$root/raylab" "$root/CMakePresets.json" "$1/"
    cp "$root/cmake/configure.sh" "$1/cmake/" 2>/dev/null
    : >"$1/packages.txt"
}
answer() { echo "constexpr int answer = $2;" >"$1/labs/01_small/answer.h"; }

# expect NAME CODE WORDS COMMAND...: its exit code, and something that it says.
expect() {
    local name=$1 code=$2 words=$3 status=0
    shift 3
    "$@" >"$scratch/said" 2>&1 || status=$?
    if [ $status -ne "$code" ] || ! grep -qF -- "$words" "$scratch/said"; then
        printf 'FAILED: %s: exit code %s, expected %s and "%s"\n' "$name" $status "$code" "$words"
        tail -n 5 "$scratch/said" | sed 's/^/    /'
        failures=$((failures + 1))
    fi
}
# judges NAME TREE ANSWER [SCRIPT]: the tree's own root and answer are found.
judges() {
    local code=1
    [ "$3" -ne 42 ] || code=0
    expect "$1" $code "root=$2|" "${4:-$2/raylab}" check 01
    expect "$1" $code "answer=$3|" "${4:-$2/raylab}" check 01
}

first="$scratch/the first tree"
make_tree "$first"
judges "a new tree" "$first" 42

second="$scratch/the copy"
cp -r "$first" "$second"
answer "$second" 41
judges "a copied tree" "$second" 41
judges "the tree that was copied" "$first" 42

third="$scratch/elsewhere"
mv "$second" "$third"
judges "a moved tree" "$third" 41

# A file put back from a copy is older than what was compiled last.
cp -p "$first/labs/01_small/answer.h" "$scratch/backup"
sleep 0.1
answer "$first" 41
judges "a change" "$first" 41
mv "$scratch/backup" "$first/labs/01_small/answer.h"
judges "a file put back" "$first" 42

mkdir "$scratch/bin"
ln -s "../the first tree/raylab" "$scratch/bin/raylab"
ln -s raylab "$scratch/bin/again"
judges "by a link to the script" "$first" 42 "$scratch/bin/again"
expect "help by a link to the script" 0 "check " "$scratch/bin/again" --help
expect "a link called from another tree" 2 "$third" \
    sh -c 'cd "$1/labs" && "$2" check 01' - "$third" "$scratch/bin/raylab"
expect "a script called from another tree" 0 "$third, which you are in" \
    sh -c 'cd "$1/labs" && "$2" check 01' - "$third" "$first/raylab"
ln -s "$first" "$scratch/link"
judges "by a link to the tree" "$first" 42 "$scratch/link/raylab"
fourth="$scratch/links"
cp -rs "$first" "$fourth"
rm -r "$fourth/build" "$fourth/labs/01_small/answer.h"
answer "$fourth" 40
judges "a tree made of links" "$fourth" 40

rm "$first/build/cpu/build.ninja"
judges "configured by halves" "$first" 42
rm "$first/build/cpu/CMakeCache.txt"
judges "without CMake's cache" "$first" 42
touch "$first/build/cpu/leftover"
sed -i 's/"Release"/"Release", "GREETING": "hello"/' "$first/CMakePresets.json"
expect "a changed preset" 0 "greeting=hello|" "$first/raylab" check 01
[ ! -e "$first/build/cpu/leftover" ] || { echo "FAILED: not begun anew"; failures=$((failures + 1)); }

mkdir -p "$scratch/overlay/labs/01_small"
echo 'constexpr int answer = 39;' >"$scratch/overlay/labs/01_small/answer.h"
cmake -S "$first" -B "$first/build/cpu" "-DRAYLAB_OVERLAY=$scratch/overlay" >/dev/null
judges "another lab laid over it by hand" "$first" 42

ln -s "$(command -v c++)" "$scratch/bin/c++"
rm -r "$third/build"
CXX=$scratch/bin/c++ "$third/raylab" check 01 >/dev/null 2>&1
rm "$scratch/bin/c++"
judges "a compiler that is gone" "$third" 41

# An optional package comes, and goes.
export CMAKE_PREFIX_PATH=$scratch/prefix
package=$scratch/prefix/lib/cmake/embree-3
mkdir -p "${package%/*}"
expect "without a package" 1 "embree=0" "$third/raylab" check 01
mkdir "$package"
echo 'set(embree_FOUND 1)' >"$package/embree-config.cmake"
echo 'set(PACKAGE_VERSION 3.1.0.7)
set(PACKAGE_VERSION_COMPATIBLE TRUE)
set(PACKAGE_VERSION_EXACT TRUE)' >"$package/embree-config-version.cmake"
expect "a package that came" 1 "embree=1" "$third/raylab" check 01
rm -r "$package"
expect "a package that went" 1 "embree=0" "$third/raylab" check 01

# What CMake complains about is seen, and what did not run has not passed.
echo 'message(WARNING "a word of warning")' >"$third/trouble.cmake"
rm -r "$third/build"
expect "a warning of CMake's" 1 "a word of warning" "$third/raylab" check 01
echo 'message(FATAL_ERROR "no way")' >"$third/trouble.cmake"
rm -r "$third/build"
expect "an error of CMake's" 3 "no way" "$third/raylab" check 01
expect "an unknown preset" 2 "no such preset" env RAYLAB_PRESET=.. "$third/raylab" check 01
expect "tests that pass" 0 "100% tests passed" "$first/raylab" test -R passing
expect "tests that fail" 1 "failing" "$first/raylab" test -R 'passing|failing'
expect "no such test" 3 "no test was run" "$first/raylab" test -R nothing
expect "a skipped test" 3 "no test was run" "$first/raylab" test -R skipped
expect "a test without its program" 3 "not every test was run" "$first/raylab" test -R 'passing|absent'

[ $failures -eq 0 ] || { echo "$failures failed"; exit 1; }
echo "trees: each judged by itself"
