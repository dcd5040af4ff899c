// k<<<grid, block, shared, stream>>>(args) is, after the rewriter,
//
//     ::raylab::simt::launcher(RAYLAB_KERNEL(k), grid, block, shared, stream)(args)
//
// The launcher is typed on the parameters of k, so that args convert as in a call: a literal 0
// becomes a null pointer. Where k names no single function, because its template arguments are to
// be deduced from args, or it is overloaded, the call itself chooses, with the types args have.
//
// A launch returns when the kernel has finished. Its errors are those of CUDA: cudaGetLastError().
#pragma once

#include "common/simt/index.h"
#include "common/simt/runtime.h"

#include <cstring>
#include <tuple>
#include <type_traits>
#include <utility>

// The launch itself reads the arguments where host code left them: not an access of the kernel.
#if defined(RAYLAB_CHECK_WATCH)
#define RAYLAB_UNWATCHED __attribute__((no_sanitize("thread")))
#else
#define RAYLAB_UNWATCHED
#endif

namespace raylab::simt {

// Everything about a launch but the kernel's arguments.
struct Launch {
    const char* kernel; // as written at the launch, "reduce<256>"
    const char* file;   // where it is launched
    int line;
    const void* function; // null where the call chooses among several
    dim3 grid, block;
    size_t shared_bytes;      // dynamic shared memory
    bool cooperative = false; // all blocks run at the same time
    cudaStream_t stream = nullptr;
};

// Runs thread_main(arguments) once for each CUDA thread of the launch.
void run(const Launch& launch, void (*thread_main)(const void*), const void* arguments);

// Notes a fault if `pointer`, which argument `index` passes to the kernel, is neither null nor
// device memory, and returns whether the launch may go on.
bool check_argument(const Launch& launch, int index, const void* pointer);

// The current block's dynamic shared memory, aligned to 16 bytes.
void* dynamic_shared_memory();

template <class T> inline T* dynamic_shared() { return static_cast<T*>(dynamic_shared_memory()); }

template <class T>
inline bool check_argument_value(const Launch& launch, int index, const T& value) {
    if constexpr (std::is_pointer_v<T> && !std::is_function_v<std::remove_pointer_t<T>>)
        return check_argument(launch, index,
                              const_cast<const void*>(static_cast<const volatile void*>(value)));
    return true;
}

// Whether passing T by value runs none of its code.
template <class T>
inline constexpr bool is_plain =
    std::is_trivially_copy_constructible_v<T>&& std::is_trivially_destructible_v<T>;

// std::vector, std::string and their kin.
template <class T> inline constexpr bool owns_host_memory = requires {
    typename T::allocator_type;
};

// One thread's copy of an argument. One with constructors or a destructor is handed to a kernel as
// nvcc does it: as its bytes, of which the kernel's end destroys nothing.
template <class T, bool plain = is_plain<T>> struct Copy {
    T value;
    T get() { return value; }
};
template <class T> struct Copy<T, false> {
    alignas(T) unsigned char bytes[sizeof(T)];
    explicit Copy(const T& value) { std::memcpy(bytes, &value, sizeof(T)); }
    T& get() { return *reinterpret_cast<T*>(bytes); }
};

// Calls the kernel with copies of the arguments. On every platform of the CPU machine a function
// takes an object that is not plain by its address, and the caller makes and destroys it; so the
// kernel may be called with the address of bytes that no one constructs or destroys.
template <class... Params>
#if defined(__clang__)
__attribute__((no_sanitize("function")))
#endif
RAYLAB_UNWATCHED inline void
call_kernel(void (*kernel)(Params...), const Params&... params) {
    if constexpr ((is_plain<Params> && ...)) {
        kernel(params...);
    } else {
        auto by_address =
            reinterpret_cast<void (*)(decltype(std::declval<Copy<Params>&>().get())...)>(
                reinterpret_cast<void (*)()>(kernel)); // by which g++ knows that this is meant
        [by_address](Copy<Params>... copies)
            RAYLAB_UNWATCHED { by_address(copies.get()...); }(Copy<Params>{params}...);
    }
}

// Runs call(args...) in each CUDA thread; every thread gets its own copies, as kernel parameters.
template <class Call, class... Args>
inline void run_with(const Launch& launch, Call call, const Args&... args) {
    static_assert(!(owns_host_memory<Args> || ...),
                  "a container of the host cannot be a kernel's argument: copy what it holds with "
                  "cudaMemcpy() and give the pointer");
    int index = 0;
    if (!(check_argument_value(launch, ++index, args) && ...)) return;
    auto closure = [&]() RAYLAB_UNWATCHED { call(args...); };
    run(
        launch,
        [](const void* self) RAYLAB_UNWATCHED { (*static_cast<const decltype(closure)*>(self))(); },
        &closure);
}

// A kernel that is one function: the arguments convert to its parameter types. Where they are
// fewer, the call takes the default arguments of its declaration.
template <class ByCall, class... Params> struct FunctionLauncher {
    Launch launch;
    void (*kernel)(Params...);
    ByCall call;
    void operator()(Params... params) const {
        run_with(
            launch, [this](const Params&... p) RAYLAB_UNWATCHED { call_kernel(kernel, p...); },
            params...);
    }
    template <class... Args>
    requires(sizeof...(Args) < sizeof...(Params)) void operator()(Args... args) const {
        run_with(
            launch, [this](Args... a) RAYLAB_UNWATCHED { call(a...); }, args...);
    }
};

// A kernel that the call chooses.
template <class Call> struct CallLauncher {
    Launch launch;
    Call call;
    template <class... Args> void operator()(Args... args) const {
        run_with(
            launch, [this](Args... a) RAYLAB_UNWATCHED { call(a...); }, args...);
    }
};

struct ToFunctionPointer {
    template <class... Params> auto operator()(void (*kernel)(Params...)) const { return kernel; }
};

struct KernelPlace {
    const char *name, *file;
    int line;
};

// `by_pointer` hands the kernel to its argument, `by_call` calls the kernel with its arguments.
template <class ByPointer, class ByCall>
inline auto launcher(ByPointer by_pointer, ByCall by_call, KernelPlace place, dim3 grid, dim3 block,
                     size_t shared_bytes = 0, cudaStream_t stream = nullptr) {
    Launch launch{place.name, place.file,   place.line, nullptr, grid,
                  block,      shared_bytes, false,      stream};
    if constexpr (std::is_invocable_v<ByPointer, ToFunctionPointer>) {
        auto kernel = by_pointer(ToFunctionPointer{});
        launch.function = reinterpret_cast<const void*>(kernel);
        return [&]<class... Params>(void (*)(Params...)) {
            return FunctionLauncher<ByCall, Params...>{launch, kernel, by_call};
        }(kernel);
    } else {
        return CallLauncher<ByCall>{launch, by_call};
    }
}

} // namespace raylab::simt

#define RAYLAB_KERNEL(...)                                                                         \
    [&](auto use) -> decltype(use(__VA_ARGS__)) { return use(__VA_ARGS__); },                      \
        [&](auto... args) RAYLAB_UNWATCHED { __VA_ARGS__(args...); },                              \
        ::raylab::simt::KernelPlace {                                                              \
#__VA_ARGS__, __FILE__, __LINE__                                                           \
    }
