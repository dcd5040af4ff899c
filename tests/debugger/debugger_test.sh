#!/usr/bin/env bash
# debugger_test.sh GDB SCRIPT PROGRAM: PROGRAM is paths.cu; SCRIPT is app/gdb_kernels.py.
set -euo pipefail

gdb=$1 script=$2 program=$3
if [ ! -x "$gdb" ]; then
    echo "gdb is not installed"
    exit 77
fi
failures=0

# expect STOP COMMANDS LINES: runs the program with RAYLAB_STOP=STOP; each of LINES is in gdb's output.
expect() {
    local output line command=()
    while IFS= read -r line; do command+=(-ex "$line"); done <<<"$2"
    output=$(RAYLAB_STOP=$1 "$gdb" -q -nx -batch -iex 'set debuginfod enabled off' -x "$script" -d "$(dirname "$script")/.." \
        -ex 'break raylab::path_stop' -ex run "${command[@]}" "$program" 2>&1)
    while IFS= read -r line; do
        grep -qF -- "$line" <<<"$output" && continue
        printf 'RAYLAB_STOP="%s": "%s" is not in\n%s\n' "$1" "$line" "$output"
        failures=$((failures + 1))
    done <<<"$3"
}

# Pixel 6 is that of thread 2 of block 1.
expect "6 1 2" 'print $pixel()
print $sample()
print $bounce()
print $threadIdx("x")
print $blockIdx()
print $blockDim("x")
print sum > 0' 'The path of pixel 6, sample 1 by thread (2,0,0) of block (1,0,0).
bounces (sampler=
sum += sampler.get_bounce(bounce).lobe;
$1 = 6
$2 = 1
$3 = 2
$4 = 2
$5 = 1
$6 = 4
$7 = true'

expect "3 0 -1" 'print $pixel()
print $bounce()' 'trace_kernel (
$1 = 3
$2 = -1'

# A function's name and a condition, in the same CUDA thread and in another one.
expect "5 0 0" 'tbreak bounces if $pixel() == 7 && $sample() == 1
continue
print $threadIdx("x")' '$1 = 3'

# A path that never comes there says how far it came.
expect "6 1 3" 'info program' 'the path of pixel 6, sample 1 did not come to bounce 3; the last bounce in which it took random numbers is 2
done'
expect "99 0 0" 'info program' 'no path began in pixel 99, sample 0'

exit $((failures > 0))
