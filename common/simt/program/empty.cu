// A program of one source: how it is compiled and linked is how `raylab run` compiles and links the
// programs of others (app/run/build_program.cpp).
#include "common/simt/cuda.h"

__global__ void nothing() {}

int main() {
    nothing<<<1, 1>>>();
    return 0;
}
