// Judges the lab that it was compiled with: the right answer is 42.
#include "labs/01_small/answer.h"

#include <cstdio>

int main() {
    std::printf("%s answer=%d|\n", FACTS, answer);
    return answer == 42 ? 0 : 1;
}
