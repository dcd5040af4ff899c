// Launches, options and the error state; see machine.h and launch.h.
#include "common/simt/engine/machine.h"

#include "common/simt/api/kernels.h"
#include "common/simt/engine/cooperative.h"
#include "common/simt/engine/environment.h"
#include "common/simt/engine/findings.h"
#include "common/simt/engine/memory.h"
#include "common/simt/engine/registered.h"
#include "common/simt/engine/report.h"
#include "common/simt/engine/sanitizer_reports.h"
#include "common/simt/engine/watchdog.h"
#include "common/simt/engine/workers.h"
#include "common/simt/watch/events.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <thread>

namespace raylab::simt {

namespace {

constexpr size_t usual_shared = 48 << 10, most_shared = 99 << 10; // bytes a block may have

// CUDA's runtime is one for the whole process, and so is this.
struct Machine {
    std::mutex launching; // one launch at a time
    const Options usual = options_of_environment();
    Options options = usual;
    std::unique_ptr<Workers> workers; // made by the first launch after the options were set

    std::mutex state;
    cudaError_t last_error = cudaSuccess, sticky = cudaSuccess;
    std::string report;
    std::map<const void*, size_t> shared_limits;
};

Machine& machine() {
    static Machine machine;
    return machine;
}

void note(cudaError_t code, const std::string& report, Told told = Told::no) {
    machine().last_error = code;
    machine().report = report;
    if (told == Told::yes) return;
    record(finding_of_report(report));
    if (machine().options.print_reports) std::fputs((report + "\n").c_str(), stderr);
}

// "f.cu:12: error: kernel k cannot be launched: " and what is wrong, or nothing.
struct Refusal {
    cudaError_t code = cudaSuccess;
    std::string text;
};
Refusal check_configuration(const Launch& launch) {
    auto refusal = [&](cudaError_t code, const std::string& text) {
        return Refusal{code, place(launch.file, launch.line) + ": error: kernel " + launch.kernel +
                                 " cannot be launched: " + text};
    };
    const dim3 &grid = launch.grid, &block = launch.block;
    std::string shape = "the grid is " + to_string(grid) + " blocks of " + to_string(block) +
                        " threads\n  expected: ";
    if (!grid.x || !grid.y || !grid.z || !block.x || !block.y || !block.z)
        return refusal(cudaErrorInvalidConfiguration,
                       shape + "every extent is at least 1\n  to do: do not launch if there is "
                               "nothing to do");
    if (uint64_t(block.x) * block.y * block.z > max_threads || block.z > 64)
        return refusal(cudaErrorInvalidConfiguration,
                       shape + "a block has at most 1024 threads, and at most 64 in z");
    if (grid.x > 0x7fffffffu || grid.y > 0xffff || grid.z > 0xffff)
        return refusal(cudaErrorInvalidConfiguration,
                       shape + "a grid has at most 2147483647 x 65535 x 65535 blocks");
    if (launch.cooperative && uint64_t(grid.x) * grid.y * grid.z > most_cooperative_blocks)
        return refusal(cudaErrorCooperativeLaunchTooLarge,
                       shape + "at most " + std::to_string(most_cooperative_blocks) +
                           " blocks, for all of them run at the same time; "
                           "cudaOccupancyMaxActiveBlocksPerMultiprocessor() tells how many fit");
    if (size_t limit = shared_limit(launch.function); launch.shared_bytes > limit)
        return refusal(cudaErrorInvalidValue,
                       std::to_string(launch.shared_bytes) +
                           " bytes of dynamic shared memory\n  expected: at most " +
                           std::to_string(limit) +
                           "\n  to do: use less, or ask for up to 101376 with "
                           "cudaFuncSetAttribute(kernel, "
                           "cudaFuncAttributeMaxDynamicSharedMemorySize, bytes)");
    return {};
}

} // namespace

cudaError_t refuse(cudaError_t code, const std::string& report) {
    std::lock_guard lock(machine().state);
    note(code, report);
    return code;
}

void remember_fault(cudaError_t code, const std::string& report, Told told) {
    std::lock_guard lock(machine().state);
    machine().sticky = code;
    note(code, report, told);
}

void warn(const std::string& report) {
    record(finding_of_report(report));
    if (machine().options.print_reports) std::fputs((report + "\n").c_str(), stderr);
}

cudaError_t sticky_error() {
    std::lock_guard lock(machine().state);
    return machine().sticky;
}

size_t shared_limit(const void* kernel) {
    std::lock_guard lock(machine().state);
    if (!kernel) return most_shared; // chosen by the call: there is no one to ask
    auto found = machine().shared_limits.find(kernel);
    return found == machine().shared_limits.end() ? usual_shared : found->second;
}

cudaError_t get_attributes(cudaFuncAttributes* attributes, const void* kernel) {
    *attributes = {};
    attributes->maxThreadsPerBlock = max_threads;
    attributes->numRegs = 32;
    attributes->ptxVersion = attributes->binaryVersion = 75;
    attributes->maxDynamicSharedSizeBytes = int(shared_limit(kernel));
    return sticky_error();
}

std::string first_argument(CallText call) {
    std::string_view text = call.text;
    int depth = 0;
    for (size_t i = 0; i < text.size(); ++i) {
        if (std::string_view("(<[{").find(text[i]) != text.npos) ++depth;
        if (std::string_view(")>]}").find(text[i]) != text.npos) --depth;
        if (text[i] == ',' && depth == 0) return std::string(text.substr(0, i));
    }
    return std::string(text);
}

cudaError_t kernel_without_type(const char* call, Where where) {
    return refuse(
        cudaErrorInvalidDeviceFunction,
        place(where) + ": error: " + call +
            " is given a kernel as void*\n  expected: the kernel's name in this call, with "
            "or without a cast, for the types of its arguments are needed");
}

cudaError_t set_attribute(const void* kernel, cudaFuncAttribute attribute, int value) {
    if (attribute != cudaFuncAttributeMaxDynamicSharedMemorySize) return cudaSuccess;
    if (value < 0 || size_t(value) > most_shared)
        return refuse(cudaErrorInvalidValue,
                      "error: cudaFuncSetAttribute(): " + std::to_string(value) +
                          " bytes of shared memory\n  expected: 0 to " +
                          std::to_string(most_shared));
    std::lock_guard lock(machine().state);
    machine().shared_limits[kernel] = size_t(value);
    return cudaSuccess;
}

void forget_errors_and_limits() {
    std::lock_guard lock(machine().state);
    machine().last_error = machine().sticky = cudaSuccess;
    machine().report.clear();
    machine().shared_limits.clear();
}

int worker_count() {
    if (check_build) return 1;
    if (machine().options.threads > 0) return machine().options.threads;
    return std::max(1, int(std::thread::hardware_concurrency()));
}

void set_options(const Options& options) {
    if (options.threads < 0 || options.threads > 1024)
        throw std::invalid_argument("Options::threads is " + std::to_string(options.threads) +
                                    ": expected 0 (all) to 1024");
    if (options.stack_size < 16 << 10)
        throw std::invalid_argument("Options::stack_size is " + std::to_string(options.stack_size) +
                                    ": expected at least 16384 bytes");
    std::lock_guard lock(machine().launching);
    Options wanted = options;
    if (wanted.order == Order::forward) {
        wanted.order = machine().usual.order;
        wanted.seed = machine().usual.seed;
    }
    if (wanted == machine().options) return;
    machine().options = wanted;
    machine().workers.reset();
}

Options options() {
    std::lock_guard lock(machine().launching);
    return machine().options;
}

std::string last_report() {
    std::lock_guard lock(machine().state);
    return machine().report;
}

bool check_argument(const Launch& launch, int index, const void* pointer) {
    if (!pointer || look_up(pointer).known || is_registered(pointer) ||
        sticky_error() != cudaSuccess)
        return true;
    const std::string start =
        place(launch.file, launch.line) + ": error: kernel " + launch.kernel + " is given a ";
    const std::string argument = " pointer as argument " + std::to_string(index);
    if (std::string freed = describe_freed(pointer); !freed.empty())
        remember_fault(cudaErrorIllegalAddress,
                       start + "freed" + argument + ": " + freed +
                           "\n  expected: a pointer from cudaMalloc() that was not freed\n  to do: "
                           "free the memory after the last launch that uses it");
    else
        remember_fault(cudaErrorIllegalAddress,
                       start + "host" + argument +
                           "\n  expected: a pointer from cudaMalloc() that was not freed\n  to do: "
                           "copy the data to device memory with cudaMemcpy() and give that");
    return false;
}

void run(const Launch& launch, void (*thread_main)(const void*), const void* arguments) {
    if (sticky_error() != cudaSuccess) return;
    if (current_block) {
        watch::Pause paused;
        refuse(cudaErrorNotSupported, place(launch.file, launch.line) + ": error: " +
                                          current_block->running() + " launches " + launch.kernel +
                                          "\n  expected: kernels are launched by host code");
        return;
    }
    if (Refusal refusal = check_configuration(launch); refusal.code != cudaSuccess) {
        refuse(refusal.code, refusal.text);
        return;
    }
    std::lock_guard lock(machine().launching);
    const dim3 &grid = launch.grid, &block = launch.block;
    count_launch(uint64_t(grid.x) * grid.y * grid.z * block.x * block.y * block.z);
    auto finished = std::make_unique<char>();
    Work work{launch, thread_main, arguments, finished.get()};
    DeviceAccess access;
    TimedLaunch timed;
    Workers::KernelFault fault;
    if (launch.cooperative) {
        fault = run_cooperative(work, machine().options);
    } else {
        if (!machine().workers)
            machine().workers = std::make_unique<Workers>(machine().options, worker_count());
        watch::begin_launch(launch, machine().options.print_reports);
        fault = machine().workers->run(work);
        watch::end_launch();
    }
    announce_acquire(finished.get());
    record_races();
    if (fault.code != cudaSuccess)
        remember_fault(fault.code, fault.report,
                       watch::has_told(fault.report) ? Told::yes : Told::no);
}

} // namespace raylab::simt

cudaError_t cudaPeekAtLastError() {
    std::lock_guard lock(raylab::simt::machine().state);
    return raylab::simt::machine().last_error;
}

cudaError_t cudaGetLastError() {
    std::lock_guard lock(raylab::simt::machine().state);
    auto& machine = raylab::simt::machine();
    return std::exchange(machine.last_error, machine.sticky);
}
