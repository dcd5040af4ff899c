// CUDA's two additions to the syntax of C++, in terms of C++.
#pragma once

#include <functional>
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

// What becomes of an #include: the same, another file, or a refusal with its reason.
struct Include {
    std::string replacement; // with its quotes; empty: leave it
    std::string refusal;
};

// As rewrite(), for a program that was not written for raylab, or a header of it. Also: extern
// __shared__ outside of functions; texture references; `inline` written twice, which nvcc allows;
// kernels cast to void* where they are launched by address. Inline PTX, launches by kernels and
// what `include` refuses are refused; under an #if or in a macro only where the compiler comes to
// it.
std::string rewrite_foreign(std::string_view source, const std::string& name,
                            const std::function<Include(std::string_view)>& include);

} // namespace raylab::simt
