#!/usr/bin/env bash
# By hand, on Debian 12 for x86-64: raylab for aarch64 builds, passes its tests and draws the same bits. What
# the cross compiler builds is run by qemu's emulation of a processor. It takes an hour or two of two cores.
#   apt-get install g++-aarch64-linux-gnu qemu-user
#   tests/aarch64/run.sh       (RAYLAB_SYSROOT: a folder that has Debian's libraries for aarch64 already)
set -euo pipefail
cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.."
build=$PWD/build/aarch64
peer=$PWD/build/aarch64-peer # the same sources for the machine at hand
sysroot=${RAYLAB_SYSROOT:-$PWD/build/aarch64-sysroot}
images=$build/images
# Without microfacets, in which the C library's erff() has other bits (docs/architecture.md).
scenes=(cornell cornell_spheres whitted textured_mesh hdr_environment)
rooms=(common/simt/tests)
for list in common/*/CMakeLists.txt; do
    [ "$list" = common/simt/CMakeLists.txt ] || rooms+=("${list%/CMakeLists.txt}")
done

step() { printf '\n== %s (after %s s)\n' "$1" "$SECONDS"; }

for tool in aarch64-linux-gnu-g++ qemu-aarch64 dpkg; do
    command -v $tool >/dev/null || { echo "needs $tool: apt-get install g++-aarch64-linux-gnu qemu-user" >&2; exit 2; }
done

if [ ! -e "$sysroot/usr" ]; then
    step "Debian's libraries for aarch64, in $sysroot"
    # A list of packages of its own, where none is installed: nothing of this machine's changes.
    apt=$sysroot.apt
    mkdir -p "$apt/lists/partial" "$apt/cache/archives/partial"
    : >"$apt/status"
    apt_get() {
        apt-get -q -y -o APT::Architecture=arm64 -o APT::Architectures=arm64 -o APT::Sandbox::User= \
            -o Dir::State::status="$apt/status" -o Dir::State::Lists="$apt/lists" -o Dir::Cache="$apt/cache" "$@"
    }
    apt_get update
    apt_get install --download-only --no-install-recommends \
        $(sed -e 's/[# ].*//' packages.txt | grep -e '-dev$' | grep -v -e glfw -e glew)
    for package in "$apt"/cache/archives/*.deb; do dpkg -x "$package" "$sysroot.part"; done
    mv "$sysroot.part" "$sysroot"
fi

step "building for aarch64"
options=(-G Ninja -DRAYLAB_VARIANTS=one)
! command -v ccache >/dev/null || options+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
cmake -S . -B "$build" -DCMAKE_TOOLCHAIN_FILE="$PWD/tests/aarch64/toolchain.cmake" -DCMAKE_SYSROOT="$sysroot" \
    "${options[@]}" >/dev/null
cmake --build "$build" --target "${rooms[@]/%//all}" lab02_tasks_test labs_agreement_test raylab

step "tests of common and of lab 02"
# Not process_test: under qemu-user vfork() is a fork, and posix_spawn() cannot tell that its program is not there.
for room in "${rooms[@]}"; do ctest --test-dir "$build/$room" --output-on-failure -E process_test; done
ctest --test-dir "$build/labs/02_iterative" --output-on-failure -R tasks
qemu-aarch64 -L "$sysroot" "$build/app/labs_agreement_test" --gtest_brief=1 \
    --gtest_filter='*Every*Iterative*/cornell:*Every*Iterative*/whitted'

step "building for this machine"
cmake -S . -B "$peer" "${options[@]}" >/dev/null
cmake --build "$peer" --target raylab

step "images"
mkdir -p "$images"
for lab in 01 02 03 04; do
    for scene in "${scenes[@]}"; do
        for kind in x86-64 aarch64; do
            command=("$peer/app/raylab")
            [ $kind = x86-64 ] || command=(qemu-aarch64 -L "$sysroot" "$build/app/raylab")
            "${command[@]}" render $lab $scene --width 64 --height 64 --spp 4 -q -o "$images/$scene-$lab-$kind.exr"
        done
        cmp "$images/$scene-$lab-x86-64.exr" "$images/$scene-$lab-aarch64.exr"
        echo "lab $lab, $scene: the same bits"
    done
done
echo "done after $SECONDS s"
