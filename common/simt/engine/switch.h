// The one thing that C++ cannot say: leave this stack and go on, on another one.
//
// switch_x86_64.S and switch_aarch64.S do it in some dozen instructions, switch_boost.cpp with
// boost.context anywhere.
#pragma once

#include <cstddef>

extern "C" {

// Makes an empty stack of `bytes` bytes below `top` ready: the first switch to the returned context
// calls raylab_simt_main() there.
void* raylab_simt_prepare(void* top, size_t bytes);

// Saves the caller's context in *from and goes on where `to` was left.
void raylab_simt_switch(void** from, void* to);

// What every stack runs (block.cpp). It never returns.
[[noreturn]] void raylab_simt_main();
}
