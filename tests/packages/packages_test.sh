#!/usr/bin/env bash
# The script ./raylab asks for what is missing of packages.txt, by apt and, on macOS, by Homebrew: with programs
# of these names that install nothing and write down what they were called with.
set -euo pipefail
root=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd)
scratch=$(mktemp -d)
trap 'rm -rf -- "$scratch"' EXIT
failures=0

tree=$scratch/tree
mkdir -p "$tree/cmake" "$scratch/bin" "$scratch/brew/opt/ninja"
cp "$root/raylab" "$root/packages.txt" "$tree/"
touch "$tree/cmake/configure.sh"
program() { printf '#!/bin/sh\n%s\n' "$2" >"$scratch/bin/$1"; chmod +x "$scratch/bin/$1"; }
program brew "[ \"\$1\" != --prefix ] || { echo $scratch/brew; exit; }; echo \"brew \$*\" >>$scratch/calls; exit 1"
program apt-get "echo \"apt-get \$*\" >>$scratch/calls; case \$1 in install) exit 1 ;; esac"
program dpkg-query 'case $* in *ninja-build) echo installed ;; *) exit 1 ;; esac'
program id 'echo 0'

# expect SYSTEM CALL: on it, this is how the packages that are missing are asked for.
expect() {
    program uname "echo $1"
    rm -f "$scratch/calls"
    local status=0
    PATH=$scratch/bin:$PATH "$tree/raylab" scenes </dev/null >"$scratch/said" 2>&1 || status=$?
    if [ $status -ne 3 ] || [ "$(tail -n 1 "$scratch/calls")" != "$2" ]; then
        printf 'FAILED: on %s: exit code %s, expected 3; the last call should be\n    %s\nof\n    %s\n' "$1" $status \
            "$2" "$(cat "$scratch/calls")"
        failures=$((failures + 1))
    fi
}
expect Darwin "brew install cmake pkgconf ccache glm googletest nlohmann-json cli11 fmt openexr jpeg-turbo libspng boost"
expect Linux "apt-get install -y -q --no-install-recommends g++ cmake pkg-config ccache libglm-dev libglfw3-dev \
libglew-dev libstb-dev libgtest-dev libgmock-dev nlohmann-json3-dev libcli11-dev libfmt-dev libtinyobjloader-dev \
libtinygltf-dev libopenexr-dev libturbojpeg0-dev libspng-dev libboost-dev libboost-context-dev libdw-dev bubblewrap libseccomp-dev libarchive-dev libsqlite3-dev"

# A line is a package's two names.
if grep -nv -e '^#' -e '^[a-z0-9+.-][a-z0-9+.-]*  *[a-z0-9-][a-z0-9-]* *$' <(sed -e 's/\(.\) *#.*/\1/' "$root/packages.txt"); then
    echo "FAILED: these lines of packages.txt have not two names"
    failures=$((failures + 1))
fi
[ $failures -eq 0 ] || exit 1
echo "packages: asked for by their names"
