// The few elements of Mitsuba's XML that several parts of an export write.
#pragma once

#include "app/labs.h"
#include "common/math/vec.h"

#include <fmt/format.h>

#include <string>

namespace raylab::app::mitsuba {

[[noreturn]] inline void refuse(const std::string& what) {
    throw UsageError("cannot be written for Mitsuba: " + what);
}

inline std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '"')
            result += "&quot;";
        else
            result += c;
    }
    return result;
}

inline std::string rgb(const char* name, Vec3 c) {
    return fmt::format("<rgb name=\"{}\" value=\"{} {} {}\"/>", name, c.x, c.y, c.z);
}

inline std::string point(const char* name, Vec3 p) {
    return fmt::format("<point name=\"{}\" x=\"{}\" y=\"{}\" z=\"{}\"/>", name, p.x, p.y, p.z);
}

// The transform to the world from the frame whose axes are x, y, z and whose origin is o.
inline std::string to_world(Vec3 x, Vec3 y, Vec3 z, Vec3 o) {
    return fmt::format("<transform name=\"to_world\"><matrix value=\"{} {} {} {} {} {} {} {} "
                       "{} {} {} {} 0 0 0 1\"/></transform>",
                       x.x, y.x, z.x, o.x, x.y, y.y, z.y, o.y, x.z, y.z, z.z, o.z);
}

} // namespace raylab::app::mitsuba
