// A place in the source, for messages: as std::source_location, which clang 14 does not have yet.
#pragma once

namespace raylab::simt {

struct Where {
    const char* file;
    int line;

    // As a default argument: where the function that has it is called.
    static constexpr Where here(const char* file = __builtin_FILE(), int line = __builtin_LINE()) {
        return {file, line};
    }
};

} // namespace raylab::simt
