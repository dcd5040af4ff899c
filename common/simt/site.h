// A place in the source where CUDA threads meet: a __syncthreads(), a shuffle, a vote.
//
// Its identity is its address. Every textual occurrence has a Site of its own, also two on one line
// or in one macro: two barriers are the same barrier only if they are the same text.
#pragma once

namespace raylab::simt {

struct Site {
    const char* operation; // as the student wrote it, "__syncthreads()"
    const char* file;
    int line;
};

} // namespace raylab::simt

#define RAYLAB_SITE(operation)                                                                     \
    []() -> const ::raylab::simt::Site& {                                                          \
        static constexpr ::raylab::simt::Site site{operation, __FILE__, __LINE__};                 \
        return site;                                                                               \
    }()
