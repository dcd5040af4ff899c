// Lines up to an empty one, then the resolution (Ward, "The RADIANCE Picture File Format"):
//
//   #?RADIANCE
//   FORMAT=32-bit_rle_rgbe     or 32-bit_rle_xyze; none: rgbe
//   EXPOSURE=0.5               each program that scaled the picture adds one: they are multiplied
//   COLORCORR=1 1.2 1          the same, a factor for each channel
//
//   -Y 512 +X 1024             1024 columns of 512 rows, the top row first, each from left to right
#include "common/image/hdr_header.h"

#include "common/cli/parse_double.h"
#include "common/image/decode.h"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <cmath>
#include <vector>

namespace raylab {
namespace {

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \t\r");
    if (begin == text.npos) return {};
    return text.substr(begin, text.find_last_not_of(" \t\r") + 1 - begin);
}

std::string_view next_line(std::string_view bytes, std::size_t& at) {
    const std::size_t end = bytes.find('\n', at);
    if (end == bytes.npos) throw DecodeError("it ends too early");
    const std::string_view line = bytes.substr(at, end - at);
    at = end + 1;
    return trimmed(line);
}

std::vector<std::string_view> words_of(std::string_view text) {
    std::vector<std::string_view> words;
    while (!(text = trimmed(text)).empty()) {
        const std::size_t end = std::min(text.find_first_of(" \t"), text.size());
        words.push_back(text.substr(0, end));
        text.remove_prefix(end);
    }
    return words;
}

// The value of "NAME=1 2 3": `count` finite numbers above 0.
DVec3 factors(std::string_view name, std::string_view value, std::size_t count) {
    const std::vector<std::string_view> words = words_of(value);
    DVec3 result(0);
    bool good = words.size() == count;
    for (std::size_t i = 0; good && i < count; ++i) {
        double number = 0;
        const char* begin = words[i].data() + (words[i].starts_with('+') ? 1 : 0);
        const char* end = words[i].data() + words[i].size();
        const auto [stop, error] = parse_double(begin, end, number);
        good = error == std::errc() && stop == end && number > 0 && std::isfinite(number);
        result[int(i)] = number;
    }
    if (!good)
        throw DecodeError(fmt::format("its header says {}={}, which is not {} above 0", name, value,
                                      count == 1 ? "a number" : "three numbers"));
    return count == 1 ? DVec3(result.x) : result;
}

void read_line(std::string_view line, HdrHeader& header) {
    const std::size_t equals = line.find('=');
    if (equals == line.npos) return; // the commands that made the picture
    const std::string_view name = line.substr(0, equals), value = trimmed(line.substr(equals + 1));
    if (name == "EXPOSURE") {
        header.exposure *= factors(name, value, 1);
    } else if (name == "COLORCORR") {
        header.exposure *= factors(name, value, 3);
    } else if (name == "FORMAT") {
        header.is_xyz = value == "32-bit_rle_xyze";
        if (!header.is_xyz && value != "32-bit_rle_rgbe")
            throw DecodeError(fmt::format("its header says FORMAT={}, and raylab reads "
                                          "32-bit_rle_rgbe and 32-bit_rle_xyze",
                                          value));
    }
}

// "-Y 512 +X 1024": y goes down from scanline to scanline, x to the right along each. The eight
// orders are the two axes in either place with either sign.
void read_resolution(std::string_view line, HdrHeader& header) {
    const std::vector<std::string_view> words = words_of(line);
    std::array<std::int64_t, 2> size{};
    bool good = words.size() == 4 && words[0].size() == 2 && words[2].size() == 2;
    for (std::size_t i = 0; good && i < 2; ++i) {
        const std::string_view axis = words[2 * i], digits = words[2 * i + 1];
        int count = 0;
        const auto [stop, error] =
            std::from_chars(digits.data(), digits.data() + digits.size(), count);
        good = error == std::errc() && stop == digits.data() + digits.size() &&
               (axis[0] == '+' || axis[0] == '-') && (axis[1] == 'X' || axis[1] == 'Y');
        if (axis[1] == 'X') {
            header.width = size[i] = count;
            header.rightwards = axis[0] == '+';
        } else {
            header.height = size[i] = count;
            header.downwards = axis[0] == '-'; // Radiance counts y from the bottom
        }
    }
    if (!good || words[0][1] == words[2][1])
        throw DecodeError(fmt::format("its size should read as -Y HEIGHT +X WIDTH, and reads '{}'",
                                      line.substr(0, 60)));
    header.columns_first = words[0][1] == 'X';
}

} // namespace

bool is_hdr(std::string_view bytes) { return bytes.starts_with("#?"); }

HdrHeader read_hdr_header(std::string_view bytes) {
    if (!is_hdr(bytes)) throw DecodeError("it does not start with '#?RADIANCE'");
    HdrHeader header;
    std::string_view line = next_line(bytes, header.end); // "#?RADIANCE", "#?RGBE", a program
    while (!(line = next_line(bytes, header.end)).empty()) read_line(line, header);
    read_resolution(next_line(bytes, header.end), header);
    for (int c = 0; c < 3; ++c)
        if (!std::isnormal(header.exposure[c]))
            throw DecodeError("its header's exposures multiply to something that is no number");
    return header;
}

} // namespace raylab
