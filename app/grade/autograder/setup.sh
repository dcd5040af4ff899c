#!/usr/bin/env bash
# Makes the machine that grades lab @LAB@ ready, once and as root, while the network is there.
#     setup.sh [SOURCE]      SOURCE: the folder with the files of this package
set -euo pipefail
source=${1:-@SOURCE@}
cd "$source"
mkdir tree
tar -xzf raylab.tar.gz -C tree
chmod 600 key
cd tree

# The machine that builds and the machine that grades may have different processors.
if [ "$(uname -m)" = x86_64 ]; then
    sed -i 's/^set(RAYLAB_ARCH native /set(RAYLAB_ARCH x86-64-v3 /' cmake/RaylabFlags.cmake
    grep -q '^set(RAYLAB_ARCH x86-64-v3 ' cmake/RaylabFlags.cmake
    # Some images keep whole seconds of times alone, as the archive does: another time means another build.
    touch -r raylab cmake/RaylabFlags.cmake
fi

# Installs the packages of packages.txt, builds the grader, and prints the tier of the sandbox.
./raylab doctor </dev/null

# Builds the lab's stubs, which all submissions stand on, and tries everything on the solution, which must
# have all points: else this script fails, and with it the package.
./raylab grade @LAB@ "labs/@FOLDER@" -o "$source/solution" --key "$source/key" </dev/null
