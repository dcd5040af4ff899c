// Sentences about races, and how findings of the watch leave it.
#pragma once

#include "common/simt/finding.h"
#include "common/simt/watch/race_book.h"

#include <string>

namespace raylab::simt::watch {

// How far apart two threads that race are.
enum class Meeting { lanes, warps, blocks };

struct RaceWords {
    std::string message, advice;
};
RaceWords race_words(const Race& race, Meeting meeting, bool same_place, const char* harmless);

// The statement that a hook was called for; `pc` is its return address.
SourcePlace place_of(Pc pc);

// Writes it to stderr and records it, each place once; further ones are counted.
void emit(const Finding& finding);

} // namespace raylab::simt::watch
