#!/usr/bin/env bash
# raylab vendor: collects the third-party headers and libraries that raylab needs into one folder, so
# that it builds where there is a compiler and CMake, but no package registry and no root.
#
# Which packages: the lines of packages.txt that end in -dev, the -dev packages that these depend on, and
# the shared libraries that theirs load. What every C++ compiler brings stays out. The folder keeps the
# layout of /usr, because the packages' CMake files find their headers by relative paths.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
fail() { printf 'raylab: vendor: %s\n' "$2" >&2; exit "$1"; }

output=$root/third_party
while [ $# -gt 0 ]; do
    case $1 in
        -h | --help)
            cat <<'HELP'
./raylab vendor [-o DIR]
  Copies the headers and libraries of the packages in packages.txt into third_party/, about 40 MB, on a
  Debian or Ubuntu machine where they are installed. With that folder in the tree raylab asks for no
  package: a compiler, CMake and Ninja are enough (and nvcc, for RAYLAB_PRESET=cuda). The other machine
  needs the same kind of processor and a C library at least as new. docs/vendor.md tells more.
  -o DIR      the folder to write instead; it is replaced
Examples:
  ./raylab vendor
  ./raylab vendor && rsync -a --exclude build --exclude out ./ cluster:raylab/
  rm -r third_party           back to the system's packages
HELP
            exit 0 ;;
        -o) [ $# -ge 2 ] || fail 2 "-o needs a folder; see ./raylab vendor --help"
            output=$2; shift 2 ;;
        *) fail 2 "'$1' is not an option; see ./raylab vendor --help" ;;
    esac
done
case $output in /*) ;; *) output=$PWD/$output ;; esac
if [ -e "$output" ] && [ ! -f "$output/packages.txt" ]; then
    fail 2 "$output is there, and was not written by vendor: remove it, or choose another folder with -o"
fi
for tool in dpkg-query pkgconf ldd c++; do
    command -v "$tool" >/dev/null || fail 2 "needs $tool, and it is not here: collect on a Debian 12 or \
Ubuntu 22.04 machine (or newer) with the packages of packages.txt, and copy the folder"
done

installed() { dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null | grep -q '^installed$'; }
# Not libarchive: it loads 40 MB of Unicode's tables, and who grades a class has a machine with packages.
declared=$(sed -e 's/[# ].*//' "$root/packages.txt" | grep -e '-dev$' | grep -v -x libarchive-dev)
missing=()
for package in $declared; do installed "$package" || missing+=("$package"); done
[ ${#missing[@]} -eq 0 ] ||
    fail 2 "these packages are not installed: ${missing[*]}; run: apt-get install ${missing[*]}"

# The -dev packages below the declared ones, breadth first. Alternatives (a | b): those that are here.
dependencies() {
    dpkg-query -W -f='${Depends}' "$1" | tr ',|' '\n\n' | sed -e 's/[(:].*//' -e 's/ //g' |
        sed -n -e '/^libc6-/d' -e '/^libstdc++-/d' -e '/^libgcc-/d' -e '/-dev$/p'
}
packages=()
waiting=($declared)
while [ ${#waiting[@]} -gt 0 ]; do
    package=${waiting[0]}
    waiting=("${waiting[@]:1}")
    case " ${packages[*]-} " in *" $package "*) continue ;; esac
    installed "$package" || continue
    packages+=("$package")
    waiting+=($(dependencies "$package"))
done

new=$output.new
trap 'rm -rf -- "$new"' EXIT
rm -rf -- "$new"
mkdir -p "$new/bin" "$new/licences" || fail 3 "cannot write $new"
new=$(cd -- "$new" && pwd)
copy() { cp -P --parents -- "$@" "$new"; }

# A shared library with all its names (libfmt.so -> libfmt.so.9 -> libfmt.so.9.1.0).
lib=usr/lib/$(c++ -print-multiarch)
mkdir -p "$new/$lib"
# The file itself may have a name of its own kind (libdw.so.1 -> libdw-0.188.so).
library() {
    cp -P -- "${1%.so*}".so* "$new/$lib/"
    cp -n -- "$(readlink -f "$1")" "$new/$lib/"
}
# What a program loads, but for what comes with each compiler.
loaded_by() {
    ldd "$1" | sed -n 's/.* => \(\/[^ ]*\) .*/\1/p' |
        sed -E '/\/lib(c|m|dl|rt|pthread|resolv|gcc_s|stdc\+\+)\.so/d'
}

cd /
count=0
for package in "${packages[@]}"; do
    count=$((count + 1))
    printf '[%d/%d] %s\n' "$count" "${#packages[@]}" "$package" >&2
    while read -r file; do
        [ -f "$file" ] || continue
        case ${file#/} in
            usr/include/boost/*) ;; # 130 MB: below
            usr/include/* | usr/lib/*.pc | usr/lib/*.cmake | usr/share/*.pc | usr/share/*.cmake)
                copy "${file#/}" ;;
            usr/lib/*.so)
                library "$file"
                for needed in $(loaded_by "$file"); do library "$needed"; done ;;
            usr/lib/*.a) # static only where there is no shared one: GoogleTest
                [ -e "${file%.a}.so" ] || copy "${file#/}" ;;
        esac
    done < <(dpkg-query -L "$package")
    cp -L "usr/share/doc/$package/copyright" \
        "$new/licences/$(dpkg-query -W -f='${source:Package}' "$package")" 2>/dev/null || true
done

# Of Boost's headers those that the compiler reads for what our sources include, and how Boost adapts to
# other compilers.
echo "Boost's headers, as far as the sources reach" >&2
grep -rhoE '#include <boost/[^>]*>' "$root"/{app,common,grader,labs} | sort -u |
    c++ -std=c++20 -x c++ -M - | tr ' ' '\n' | grep '^/usr/include/boost/' | sed 's,^/,,' |
    xargs cp --parents -t "$new" -- || fail 3 "the compiler does not find Boost's headers"
cp -r --parents -- usr/include/boost/config "$new"

# pkg-config, for machines that have none; sees this folder only, wherever it lies.
cp -L -- "$(command -v pkgconf)" "$new/bin/pkgconf"
for needed in $(loaded_by "$new/bin/pkgconf"); do library "$needed"; done
cat >"$new/bin/pkg-config" <<WRAPPER
#!/bin/sh
top=\$(cd -- "\$(dirname -- "\$0")/.." && pwd)
export PKG_CONFIG_SYSROOT_DIR="\$top" LD_LIBRARY_PATH="\$top/$lib"
export PKG_CONFIG_LIBDIR="\$top/$lib/pkgconfig:\$top/usr/share/pkgconfig"
exec "\$top/bin/pkgconf" "\$@"
WRAPPER
chmod +x "$new/bin/pkg-config"

cp -- "$root/packages.txt" "$new/packages.txt"
cd "$root"
rm -rf -- "$output"
mv -- "$new" "$output"
echo "$output: $(du -sm "$output" | cut -f 1) MB of ${#packages[@]} packages"
