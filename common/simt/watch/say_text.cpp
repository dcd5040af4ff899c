#include "common/simt/watch/say_text.h"

#include "common/simt/engine/findings.h"
#include "common/simt/engine/where_is.h"
#include "common/simt/finding_text.h"
#include "common/simt/watch/watcher.h"

#include <cstdio>
#include <map>
#include <tuple>

namespace raylab::simt::watch {

namespace {

std::string advice_for(const Race& race, Meeting meeting) {
    if (is_atomic(race.before.touch) || is_atomic(race.after.touch))
        return "the value may change between the two: read it by an atomic operation too, or after "
               "the "
               "kernel, or behind a barrier";
    switch (meeting) {
    case Meeting::lanes:
        return "put __syncwarp() between the two accesses, or __syncthreads() if other warps take "
               "part";
    case Meeting::warps:
        return "put __syncthreads() between the two accesses";
    case Meeting::blocks:
        break;
    }
    return "blocks of one launch run in any order: use an atomic operation, or two kernels one "
           "after the "
           "other";
}

std::string between(Meeting meeting) {
    switch (meeting) {
    case Meeting::lanes:
        return "two threads of one warp";
    case Meeting::warps:
        return "two threads of one block";
    case Meeting::blocks:
        break;
    }
    return "threads of two blocks";
}

std::string memory_name(Memory memory) {
    switch (memory) {
    case Memory::shared:
        return "shared memory";
    case Memory::symbol:
        return "a __device__ variable";
    case Memory::global:
        break;
    }
    return "global memory";
}

} // namespace

RaceWords race_words(const Race& race, Meeting meeting, bool same_place, const char* harmless) {
    const std::string where = memory_name(race.memory), who = between(meeting);
    RaceWords words;
    if (same_place && race.before_wrote && race.after_wrote)
        words.message = "race: " + who + " write the same place of " + where + " at this line";
    else if (same_place)
        words.message = "race: at this line one thread writes a place of " + where +
                        " that another reads, and nothing orders the two (" + who + ")";
    else
        words.message =
            std::string("race: ") + who + " " +
            (race.after_wrote ? race.before_wrote ? "write one place" : "read and write one place"
                              : "write and read one place") +
            " of " + where + ", and nothing orders the two";
    words.advice = advice_for(race, meeting);
    if (same_place && race.before.touch == Touch::plain && race.after.touch == Touch::plain)
        words.advice =
            "use an atomic operation such as atomicAdd(), or let each thread have a place of "
            "its own";
    if (harmless) {
        words.message += "; harmless on a GPU: " + std::string(harmless);
        words.advice = "an atomic operation says what is meant: atomicExch(), atomicOr()";
    }
    return words;
}

SourcePlace place_of(Pc pc) {
    static std::map<Pc, SourcePlace> known;
    const auto found = known.find(pc);
    if (found != known.end()) return found->second;
    const auto place = source_place(static_cast<const char*>(pc) - 1);
    return known[pc] = place.value_or(SourcePlace{});
}

void emit(const Finding& finding) {
    static std::map<std::tuple<std::string, SourcePlace, SourcePlace>, int> said;
    const SourcePlace other = finding.other ? finding.other->place : SourcePlace{};
    const int before = said[{finding.kind, finding.place, other}]++;
    if (before < 100) record(finding); // folded by who reads them
    if (before || !Watcher::get().prints()) return;
    std::fputs(to_text(finding).c_str(), stderr);
}

} // namespace raylab::simt::watch
