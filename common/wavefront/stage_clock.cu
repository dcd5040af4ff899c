#include "common/wavefront/stage_clock.h"

namespace raylab {

namespace {
constexpr std::size_t span_count = 256; // read, and used again, when all are used
}

StageClock::StageClock(std::span<const char* const> names) {
    for (const char* name : names) counts_.push_back({name});
    spans_.resize(span_count);
    for (Span& span : spans_) {
        check(cudaEventCreate(&span.begin), "cudaEventCreate");
        check(cudaEventCreate(&span.end), "cudaEventCreate");
    }
}

StageClock::~StageClock() {
    for (const Span& span : spans_) {
        cudaEventDestroy(span.begin);
        cudaEventDestroy(span.end);
    }
}

void StageClock::begin(std::size_t stage) {
    if (used_ == spans_.size()) read();
    spans_[used_].stage = stage;
    check(cudaEventRecord(spans_[used_].begin), "cudaEventRecord");
}

void StageClock::end(std::size_t stage, std::uint64_t blocks, std::uint64_t threads) {
    StageCounts& counts = counts_[stage];
    check(cudaGetLastError(), counts.name);
    check(cudaEventRecord(spans_[used_++].end), "cudaEventRecord");
    ++counts.launches;
    counts.blocks += blocks;
    counts.threads += threads;
}

void StageClock::read() {
    for (std::size_t i = 0; i < used_; ++i) {
        float milliseconds = 0;
        check(cudaEventSynchronize(spans_[i].end), "cudaEventSynchronize");
        check(cudaEventElapsedTime(&milliseconds, spans_[i].begin, spans_[i].end),
              "cudaEventElapsedTime");
        counts_[spans_[i].stage].seconds += 1e-3 * milliseconds;
    }
    used_ = 0;
}

const std::vector<StageCounts>& StageClock::counts() {
    read();
    return counts_;
}

} // namespace raylab
