#include "grader/results/text.h"

#include <fmt/format.h>

namespace raylab {

namespace {

constexpr std::string_view replacement = "\xEF\xBF\xBD"; // U+FFFD

// The length of the character of UTF-8 that the text begins with; 0 if it begins with none
// (RFC 3629: no overlong forms, no surrogates, nothing above U+10FFFF).
std::size_t character(std::string_view text) {
    const auto at = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const unsigned char first = at(0);
    if (first < 0x80) return 1;
    const std::size_t length = first >= 0xC2 && first < 0xE0   ? 2
                               : first >= 0xE0 && first < 0xF0 ? 3
                               : first >= 0xF0 && first < 0xF5 ? 4
                                                               : 0;
    if (length == 0 || text.size() < length) return 0;
    for (std::size_t i = 1; i < length; ++i)
        if ((at(i) & 0xC0) != 0x80) return 0;
    const bool overlong = (first == 0xE0 && at(1) < 0xA0) || (first == 0xF0 && at(1) < 0x90);
    const bool surrogate = first == 0xED && at(1) >= 0xA0;
    const bool too_large = first == 0xF4 && at(1) >= 0x90;
    return overlong || surrogate || too_large ? 0 : length;
}

bool is_printable(std::string_view character) {
    const auto byte = static_cast<unsigned char>(character[0]);
    if (character.size() == 1)
        return byte == '\t' || byte == '\n' || (byte >= 0x20 && byte != 0x7F);
    return character != "\xEF\xBF\xBE" && character != "\xEF\xBF\xBF"; // no characters in XML
}

} // namespace

std::string clean_utf8(std::string_view text) {
    std::string clean;
    while (!text.empty()) {
        const std::size_t length = character(text);
        if (length > 0 && is_printable(text.substr(0, length)))
            clean += text.substr(0, length);
        else if (text[0] != '\r')
            clean += replacement;
        text.remove_prefix(length > 0 ? length : 1);
    }
    return clean;
}

std::string shortened(const std::string& text, std::size_t bytes) {
    if (text.size() <= bytes) return text;
    constexpr std::string_view end = "\n... (more was said)";
    std::size_t keep = bytes > end.size() ? bytes - end.size() : 0;
    while (keep > 0 && (static_cast<unsigned char>(text[keep]) & 0xC0) == 0x80) --keep;
    return text.substr(0, keep) + std::string(end.substr(0, bytes));
}

std::string escape_html(std::string_view text) {
    std::string out;
    for (const char c : text) {
        switch (c) {
        case '&':
            out += "&amp;";
            break;
        case '<':
            out += "&lt;";
            break;
        case '>':
            out += "&gt;";
            break;
        case '"':
            out += "&quot;";
            break;
        case '\'':
            out += "&#39;";
            break;
        default:
            out += c;
        }
    }
    return out;
}

std::string escape_xml(std::string_view text) {
    std::string escaped;
    for (const char c : escape_html(clean_utf8(text)))
        escaped += c == '\n' ? std::string("&#10;") : std::string(1, c);
    return escaped;
}

std::string escape_github(std::string_view text, bool is_property) {
    std::string escaped;
    for (const char c : text)
        if (c == '%' || c == '\r' || c == '\n' || (is_property && (c == ':' || c == ',')))
            escaped += fmt::format("%{:02X}", static_cast<unsigned char>(c));
        else
            escaped += c;
    return escaped;
}

std::string csv_field(std::string_view text) {
    const std::string clean = clean_utf8(text);
    std::string quoted = "\"";
    if (!clean.empty() && std::string_view("=+-@\t").find(clean[0]) != std::string_view::npos)
        quoted += "'";
    for (const char c : clean) {
        if (c == '"') quoted += '"';
        quoted += c == '\n' ? ' ' : c;
    }
    return quoted + "\"";
}

} // namespace raylab
