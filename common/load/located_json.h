// JSON that remembers where each value stands in its file, so that an error can point at it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace raylab {

struct Json {
    enum class Kind { null, boolean, number, string, array, object };

    Kind kind = Kind::null;
    std::size_t offset = 0; // of the value's first byte in the text
    bool boolean = false;
    double number = 0;
    std::string string;
    std::vector<Json> items;              // of an array or object, in file order
    std::vector<std::string> keys;        // of an object: keys[i] names items[i], no key twice
    std::vector<std::size_t> key_offsets; // of each key's opening quote

    const Json* find(std::string_view key) const; // nullptr if absent or not an object
};

// A parsed file with its text, which outlives the places that errors compute from it.
struct JsonDocument {
    std::string file; // as errors name it
    std::string text;
    Json root;

    // "scenes/a.json:3:14", line and column from 1, columns counted in characters (UTF-8).
    std::string place(std::size_t offset) const;
};

// How deep arrays and objects may be nested.
constexpr int max_json_depth = 64;

// Strict JSON: no comments, no trailing commas, no key twice, at most max_json_depth deep, numbers
// within the range of double. Throws SceneError with line and column.
JsonDocument parse_json(std::string_view text, const std::string& file);

// The text as a JSON string, control characters escaped, cut if long: fit for a terminal.
std::string quote(const std::string& text);

// `"a long string ..."`, `3.5`, `[1, 2]`, `an array of 7`: a value as an error message shows it.
std::string describe(const Json& value);

} // namespace raylab
