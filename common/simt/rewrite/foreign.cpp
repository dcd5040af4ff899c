// What is refused to programs; see foreign.h.
#include "common/simt/rewrite/foreign.h"

#include <cctype>
#include <utility>

namespace raylab::simt {

namespace {

constexpr std::pair<std::string_view, std::string_view> libraries[] = {
    {"cublas", "cuBLAS"},     {"cufft", "cuFFT"},
    {"cusparse", "cuSPARSE"}, {"cudnn", "cuDNN"},
    {"cusolver", "cuSOLVER"}, {"cutensor", "cuTENSOR"},
    {"npp", "NPP"},           {"nvjpeg", "nvJPEG"},
    {"nvrtc", "NVRTC"},       {"nvml", "NVML"},
    {"nccl", "NCCL"},         {"cutlass/", "CUTLASS"},
    {"cute/", "CUTLASS"},     {"mma.h", "wmma: tensor cores"},
    {"optix", "OptiX"},       {"cuda_gl_interop", "OpenGL interoperation"},
    {"cuda/", "libcu++"},     {"cudaGL", "OpenGL interoperation"},
    {"nvgraph", "nvGRAPH"},   {"cupti", "CUPTI"},
};

bool begins_with(std::string_view text, std::string_view start) {
    return text.substr(0, start.size()) == start;
}

} // namespace

std::string refused_header(std::string_view header, bool has_thrust) {
    for (auto& [start, name] : libraries)
        if (begins_with(header, start))
            return std::string(name) + " (" + std::string(header) +
                   ") is not on the CPU machine: run this program on a GPU";
    if (begins_with(header, "cub/device/") || begins_with(header, "cub/util") ||
        begins_with(header, "cub/iterator/"))
        return "CUB (" + std::string(header) +
               ") is on the CPU machine only as far as blocks and warps go: run this program on a "
               "GPU";
    if (!has_thrust && begins_with(header, "thrust/"))
        return std::string(header) + " is not installed: Debian and Ubuntu have it in the package "
                                     "libthrust-dev";
    return {};
}

// PTX has instructions with types, "mov.u32", and registers with two percent signs.
bool is_ptx(std::string_view text) {
    for (size_t i = 0; i + 2 < text.size(); ++i) {
        if (text[i] == '%' && text[i + 1] == '%' && std::isalpha((unsigned char)text[i + 2]))
            for (std::string_view name : {"%%laneid", "%%lanemask", "%%warpid", "%%smid", "%%tid",
                                          "%%ctaid", "%%ntid", "%%clock", "%%globaltimer", "%%p"})
                if (begins_with(text.substr(i), name)) return true;
        if (std::isalpha((unsigned char)text[i]) && text[i + 1] == '.' &&
            std::isalpha((unsigned char)text[i + 2]))
            return true;
    }
    for (std::string_view word : {"trap;", "exit;", "membar", "bar.sync", "\"bfind", "\"prmt"})
        if (text.find(word) != std::string_view::npos) return true;
    return false;
}

} // namespace raylab::simt
