// What g++ and clang hand to the handlers of UndefinedBehaviorSanitizer (compiler-rt's
// ubsan_handlers.h).
#pragma once

#include <cstdint>

namespace raylab::simt::watch {

struct SourceLocation {
    const char* file;
    uint32_t line, column;
};

struct TypeDescriptor {
    uint16_t kind, info;
    char name[1]; // "'float [8]'", as long as it is
};

struct OutOfBoundsData {
    SourceLocation location;
    const TypeDescriptor *array, *index;
};

struct OverflowData {
    SourceLocation location;
    const TypeDescriptor* type;
};

struct TypeMismatchData {
    SourceLocation location;
    const TypeDescriptor* type;
    unsigned char log_alignment, check_kind;
};

} // namespace raylab::simt::watch
