#!/usr/bin/env bash
# configure.sh BUILD CMAKE-OPTIONS...: sees to it that the folder BUILD is configured for the tree that this
# file stands in, with these options, on this machine. Nothing happens where it is so already.
#
# People copy and move trees with their build folders, and CMake's files name the tree they were made in: a
# build there would compile, and a check would judge, that other tree. What does not belong here is removed
# and configured anew. BUILD/configured tells what the last complete configuring was for, and what it saw.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd -P)
mkdir -p "$1"
build=$(cd -- "$1" && pwd -P)
shift
cache=$build/CMakeCache.txt
stamp=$build/configured
log=$build/configure.log

cached() { sed -n "s,^$1:[A-Z]*=,,p" "$cache"; }
sum() { cksum | tr -s ' \t' -; }

# With another line of these, nothing in the build folder is of use.
purpose() {
    printf 'for %s %s\n' "$root" "$*"
    printf 'for presets %s\n' "$(cat "$root"/CMake*Presets.json 2>/dev/null | sum)"
    printf 'for packages %s\n' "$(cat "$root/third_party/packages.txt" 2>/dev/null | sum)"
    local language compiler
    for language in CXX CUDA; do
        compiler=$(cached CMAKE_${language}_COMPILER)
        [ -z "$compiler" ] || printf 'for compiler %s\n' "$("$compiler" --version 2>&1 | sum)"
    done
}

# Changes when something comes to the folders in which CMake looks for packages, or goes: what is optional
# and was missing may be there now.
surroundings() {
    local prefixes path folders=()
    IFS=':;' read -r -a prefixes <<<"${CMAKE_PREFIX_PATH-}:$PATH:/usr/local:/usr"
    for path in "${prefixes[@]}"; do
        folders+=("${path%/bin}"/{lib,lib64,share,lib/*-linux-gnu}/{cmake,pkgconfig})
    done
    # What names and times of files are to the stat of GNU, they are not to that of BSD and macOS.
    local names_and_times=(-c '%n %y')
    [ "$(uname -s)" != Darwin ] || names_and_times=(-f '%N %m')
    printf 'saw folders %s\n' "$(stat "${names_and_times[@]}" -- "${folders[@]}" 2>/dev/null | sort -u | sum)"
    printf 'saw programs %s\n' "$(command -v cmake ninja python3 pkg-config | sum)"
}

# Half a sentence on why what lies in the build folder is of no use; nothing where it is.
why_useless() {
    [ -f "$cache" ] && [ -f "$build/build.ninja" ] || { echo "was not configured to the end"; return; }
    local home tool path
    home=$(cached CMAKE_HOME_DIRECTORY)
    [ "$home" = "$root" ] || { echo "was configured for another tree, $home"; return; }
    [ "$(cached CMAKE_CACHEFILE_DIR)" = "$build" ] || { echo "was configured elsewhere"; return; }
    for tool in CMAKE_COMMAND CMAKE_MAKE_PROGRAM CMAKE_{C,CXX,CUDA}_COMPILER; do
        path=$(cached $tool)
        [ -z "$path" ] || [ -x "$path" ] || { echo "was configured with $path, which is gone"; return; }
    done
    [ ! -f "$stamp" ] || [ "$(purpose "$@")" = "$(grep '^for ' "$stamp")" ] ||
        echo "was configured with other options, packages or another compiler"
}

# Each -DNAME=VALUE as it is asked for: somebody may have configured by hand since.
options_hold() {
    local option
    for option in "$@"; do
        case $option in
            -D*=*) option=${option#-D}
                [ "$(cached "${option%%=*}")" = "${option#*=}" ] || return 1 ;;
        esac
    done
}

if [ -n "$(ls -A "$build")" ]; then
    useless=$(why_useless "$@")
    if [ -n "$useless" ]; then
        printf '%s %s: configuring it anew\n' "$build" "$useless" >&2
        find "$build" -mindepth 1 -delete
    elif [ -f "$stamp" ] && [ "$(surroundings)" = "$(grep '^saw ' "$stamp")" ] && options_hold "$@"; then
        exit 0
    fi
fi

echo "configuring ${build#"$root"/}" >&2
rm -f "$stamp" # stays away if this is interrupted
saw=$(surroundings)
status=0
cmake -S "$root" -B "$build" "$@" >"$log" 2>"$log.complaints" || status=$?
cat "$log.complaints" >&2
[ $status -eq 0 ] || { printf 'configuring failed (log: %s)\n' "$log" >&2; exit 3; }
{ purpose "$@"; printf '%s\n' "$saw"; } >"$stamp.part"
mv "$stamp.part" "$stamp"
