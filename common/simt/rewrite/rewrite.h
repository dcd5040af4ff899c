// CUDA's two additions to the syntax of C++, in terms of C++.
#pragma once

#include <stdexcept>
#include <string>
#include <string_view>

namespace raylab::simt {

// "f.cu:12: error: ..."
struct RewriteError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

// The text of a .cu file, for a host compiler:
//   k<<<g, b>>>(args)            ::raylab::simt::launcher(RAYLAB_KERNEL(k), g, b)(args)
//   extern __shared__ T name[];  T* name = ::raylab::simt::dynamic_shared<T>();
// Nothing else is touched, and every line keeps its number. `name` is what __FILE__ and errors say.
// Throws RewriteError.
std::string rewrite(std::string_view source, const std::string& name);

} // namespace raylab::simt
