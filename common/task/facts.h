// What a task's test says when a lab is wrong: the measured fact, and where to look for its cause.
//
//     t of the ray through the centre should be 4 but is 6; the likely cause: the far root
//
// `raylab check` shows this sentence and nothing else of the test.
#pragma once

#include "common/simt/where.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace raylab::task {

using Place = simt::Where;

// Fails the test with the sentence, unless `holds`. Returns `holds`.
inline bool expect(bool holds, const std::string& sentence, Place place = Place::here()) {
    if (!holds) ADD_FAILURE_AT(place.file, place.line) << sentence;
    return holds;
}

inline std::string should_be(const std::string& what, const std::string& expected,
                             const std::string& got, const std::string& cause) {
    return fmt::format("{} should be {} but is {}; the likely cause: {}", what, expected, got,
                       cause);
}

inline bool expect_equal(const std::string& what, long long got, long long expected,
                         const std::string& cause, Place place = Place::here()) {
    return expect(got == expected,
                  should_be(what, std::to_string(expected), std::to_string(got), cause), place);
}

// tolerance: absolute. A NaN is never near.
inline bool expect_near(const std::string& what, double got, double expected, double tolerance,
                        const std::string& cause, Place place = Place::here()) {
    return expect(
        std::fabs(got - expected) <= tolerance,
        should_be(what, fmt::format("{:.6g}", expected), fmt::format("{:.6g}", got), cause), place);
}

// Each of three coordinates within the tolerance.
template <class Vector>
bool expect_vector(const std::string& what, const Vector& got, const Vector& expected,
                   double tolerance, const std::string& cause, Place place = Place::here()) {
    const auto text = [](const Vector& v) {
        return fmt::format("({:.5g}, {:.5g}, {:.5g})", v.x, v.y, v.z);
    };
    const bool near = std::fabs(got.x - expected.x) <= tolerance &&
                      std::fabs(got.y - expected.y) <= tolerance &&
                      std::fabs(got.z - expected.z) <= tolerance;
    return expect(near, should_be(what, text(expected), text(got), cause), place);
}

} // namespace raylab::task
