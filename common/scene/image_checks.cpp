// JPEG (ITU-T T.81, annex B): segments of a marker FF xx, a length and data, then coded data, in
// which FF xx with xx other than 00 is a marker again.
// PNG (ISO/IEC 15948, 5.3): chunks of a length, a name of four letters, data, and a check sum.
#include "common/scene/image_checks.h"

#include <algorithm>

namespace raylab {
namespace {

constexpr int define_huffman_tables = 0xC4, first_frame = 0xC0, last_frame = 0xCF;

// The byte at `at`, or 255 behind the end: a table that is cut off must not fit.
int byte(std::string_view bytes, std::size_t at) {
    return at < bytes.size() ? static_cast<unsigned char>(bytes[at]) : 255;
}

int length_at(std::string_view bytes, std::size_t at) {
    return byte(bytes, at) << 8 | byte(bytes, at + 1);
}

// One segment may hold several tables: a byte, 16 numbers of codes by their length, the codes.
bool tables_fit(std::string_view bytes, std::size_t at) {
    const std::size_t end = std::min(at + std::size_t(length_at(bytes, at)), bytes.size());
    for (at += 2; at < end;) {
        int codes = 0;
        for (std::size_t length = 1; length <= 16; ++length) codes += byte(bytes, at + length);
        if (codes > 256) return false;
        at += 17 + std::size_t(codes);
    }
    return true;
}

} // namespace

bool huffman_tables_fit(std::string_view bytes) {
    if (!bytes.starts_with("\xFF")) return true;
    // Before the frame, segments are skipped by their lengths, for one may hold anything (a
    // thumbnail, a colour profile); behind it, every FF C4 is looked at.
    bool in_frame = false;
    for (std::size_t at = 0; at + 1 < bytes.size();) {
        const int marker = byte(bytes, at + 1);
        if (byte(bytes, at) != 0xFF || marker == 0xFF) {
            ++at;
            continue;
        }
        at += 2;
        if (marker == define_huffman_tables) {
            if (!tables_fit(bytes, at)) return false;
        } else if (marker >= first_frame && marker <= last_frame) {
            in_frame = true;
        }
        const bool has_length = marker > 1 && !(marker >= 0xD0 && marker <= 0xD8);
        if (!in_frame && has_length) at += std::max<std::size_t>(length_at(bytes, at), 2);
    }
    return true;
}

bool png_chunks_fit(std::string_view bytes) {
    constexpr std::string_view signature("\x89PNG\r\n\x1a\n");
    if (!bytes.starts_with(signature)) return true;
    constexpr std::size_t name_and_length = 8, check_sum = 4;
    for (std::size_t at = signature.size(); bytes.size() - at >= name_and_length;) {
        const std::size_t length =
            std::size_t(length_at(bytes, at)) << 16 | std::size_t(length_at(bytes, at + 2));
        const std::string_view name = bytes.substr(at + 4, 4);
        if (name == "IEND") return true;
        if (length > bytes.size() - at - name_and_length || (name == "IDAT" && length == 0))
            return false;
        at = std::min(at + name_and_length + length + check_sum, bytes.size());
    }
    return false;
}

} // namespace raylab
