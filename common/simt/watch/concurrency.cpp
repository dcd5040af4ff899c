#include "common/simt/watch/concurrency.h"

#include "common/simt/engine/report.h"
#include "common/simt/watch/say.h"
#include "common/simt/watch/say_text.h"

#include <algorithm>

namespace raylab::simt::watch {

namespace {

std::string named(const OperationName& name) {
    const std::string where = place(name.file.c_str(), name.line);
    return name.kernel.empty() ? "the copy at " + where
                               : "kernel " + name.kernel + ", launched at " + where + ",";
}

bool overlap(uintptr_t a, size_t a_bytes, uintptr_t b, size_t b_bytes) {
    return a < b + b_bytes && b < a + a_bytes;
}

} // namespace

// Who accesses now: the running launch, a copy, or host code.
struct Concurrency::Doer {
    enum Kind { kernel, copy, host } kind;
    Pc pc;       // of a kernel or host code
    Where where; // of a copy
    Touch touch = Touch::plain;
    bool knows(const StreamOrder& order, Operation operation) const {
        return kind == host ? order.host_knows(operation) : order.running_knows(operation);
    }
};

Operation Concurrency::begin_launch(const Launch& launch) {
    std::lock_guard lock(mutex_);
    return order_.issue(launch.stream, {launch.kernel, launch.file, launch.line});
}

void Concurrency::copy(const CopyCall& call, Range& arena) {
    std::lock_guard lock(mutex_);
    const Operation operation =
        order_.issue(call.stream.value_or(nullptr), {{}, call.where.file, call.where.line});
    const uintptr_t to = uintptr_t(call.to), from = uintptr_t(call.from);
    if (concerns_launch()) {
        const Doer doer{Doer::copy, nullptr, call.where};
        if (arena.has(to)) look_at_range(doer, arena, to, call.bytes, true);
        if (arena.has(from)) look_at_range(doer, arena, from, call.bytes, false);
    }
    if (!call.stream) {
        order_.host_waits_for_stream(nullptr);
    } else {
        if (arena.has(to)) copies_.push_back({operation, to, call.bytes, true});
        if (arena.has(from)) copies_.push_back({operation, from, call.bytes, false});
        // To memory that is not page-locked a copy returns when it is done.
        if (arena.has(from) && !arena.has(to)) order_.host_waits_for_stream(*call.stream);
    }
    forget_what_ended();
}

void Concurrency::look_at_range(const Doer& doer, Range& arena, uintptr_t begin, size_t bytes,
                                bool writes) {
    compare_copies(doer, begin, bytes, writes);
    for (uintptr_t word = (begin - arena.begin) / 4; word * 4 < begin - arena.begin + bytes; ++word)
        compare(doer, arena.words[word], writes);
}

void Concurrency::kernel_access(const Word& word, uintptr_t address, unsigned bytes, bool writes,
                                Touch touch, Pc pc) {
    std::lock_guard lock(mutex_);
    const Doer doer{Doer::kernel, pc, {}, touch};
    compare(doer, word, writes);
    compare_copies(doer, address, bytes, writes);
}

void Concurrency::host_access(Range& arena, uintptr_t address, unsigned bytes, bool writes, Pc pc) {
    std::lock_guard lock(mutex_);
    if (told_.contains(pc)) return;
    look_at_range({Doer::host, pc, {}}, arena, address, bytes, writes);
}

void Concurrency::compare(const Doer& doer, const Word& word, bool writes) {
    const auto is_unordered = [&](const Access& before) {
        return before.site && before.launch && !doer.knows(order_, before.launch) &&
               (before.touch == Touch::plain || doer.touch == Touch::plain);
    };
    const auto tell = [&](const Access& before, bool before_wrote) {
        say(doer, writes, order_.name(before.launch), before_wrote,
            place_of(sites_.pc(before.site)));
    };
    if (is_unordered(word.writer)) return tell(word.writer, true);
    if (!writes) return;
    for (const Access& reader : word.readers)
        if (is_unordered(reader)) return tell(reader, false);
}

void Concurrency::compare_copies(const Doer& doer, uintptr_t begin, size_t bytes, bool writes) {
    for (const PendingCopy& copy : copies_)
        if ((writes || copy.writes) && overlap(begin, bytes, copy.begin, copy.bytes) &&
            !doer.knows(order_, copy.operation)) {
            const OperationName& name = order_.name(copy.operation);
            return say(doer, writes, name, copy.writes, {name.file, name.line, 0});
        }
}

void Concurrency::say(const Doer& doer, bool writes, const OperationName& before, bool before_wrote,
                      const SourcePlace& before_place) {
    Finding finding;
    finding.kind = "unsynchronised";
    finding.place = doer.kind == Doer::copy ? SourcePlace{doer.where.file, doer.where.line, 0}
                                            : place_of(doer.pc);
    if (doer.kind == Doer::host) told_.insert(doer.pc);
    if (finding.place.file.empty()) return; // of a library
    finding.mode = "watch";
    const char* who = doer.kind == Doer::host     ? "host code"
                      : doer.kind == Doer::kernel ? "the kernel"
                                                  : "this copy";
    finding.message = std::string(who) + (writes ? " writes" : " reads") + " memory that " +
                      named(before) + " may still " + (before_wrote ? "write" : "read") +
                      ": nothing waits for it in between";
    if (doer.kind == Doer::kernel) finding.actor = running_actor();
    if (doer.kind == Doer::host)
        finding.advice = "call cudaDeviceSynchronize() or cudaStreamSynchronize() first";
    else
        finding.advice = "give both to one stream, or put cudaEventRecord() behind the first and "
                         "cudaStreamWaitEvent() before the second";
    finding.other = Finding::Other{before_place, before_wrote ? "write" : "read", {}};
    finding.other->actor.kernel = before.kernel;
    emit(finding);
}

void Concurrency::forget_what_ended() {
    std::erase_if(copies_,
                  [&](const PendingCopy& copy) { return order_.host_knows(copy.operation); });
}

} // namespace raylab::simt::watch
