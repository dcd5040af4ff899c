// Where values stand, and what is not JSON.
#include "common/load/located_json.h"

#include "common/load/suggest.h"
#include "common/load/tests/scene_files.h"

#include <fmt/format.h>

namespace raylab {
namespace {

// Every value of the document must stand where its own text stands: each is unique in the text.
void expect_in_place(const JsonDocument& document, const Json& json) {
    const std::string_view here = std::string_view(document.text).substr(json.offset);
    switch (json.kind) {
    case Json::Kind::number:
        EXPECT_TRUE(here.starts_with(fmt::format("{}", json.number))) << here;
        break;
    case Json::Kind::string:
        EXPECT_TRUE(here.starts_with(quote(json.string))) << here;
        break;
    case Json::Kind::boolean:
        EXPECT_TRUE(here.starts_with(json.boolean ? "true" : "false")) << here;
        break;
    case Json::Kind::null:
        EXPECT_TRUE(here.starts_with("null")) << here;
        break;
    case Json::Kind::array:
        EXPECT_TRUE(here.starts_with("[")) << here;
        break;
    case Json::Kind::object:
        EXPECT_TRUE(here.starts_with("{")) << here;
        break;
    }
    for (const Json& item : json.items) expect_in_place(document, item);
    for (std::size_t i = 0; i < json.keys.size(); ++i)
        EXPECT_EQ(document.text.substr(json.key_offsets[i], json.keys[i].size() + 2),
                  quote(json.keys[i]));
}

TEST(LocatedJson, EveryValueStandsWhereItsTextIs) {
    const JsonDocument document =
        parse_json("\xEF\xBB\xBF {\"a\":[1,-2.5 , 3e+20,{}],\r\n\t\"b, c\": {\"}\":\"x\\\"]\" "
                   ",\"d\":[ true,false , null,\"\"]},"
                   "\"e\":[[],[[4]]],\"\":5}",
                   "f");
    expect_in_place(document, document.root);
    EXPECT_EQ(document.root.items.size(), 4u);
    EXPECT_EQ(document.root.find("b, c")->items[0].string, "x\"]");
    EXPECT_EQ(document.place(document.root.find("b, c")->offset), "f:2:10");
}

TEST(LocatedJson, NestsSixtyFourDeepAndNoDeeper) {
    const auto nested = [](int depth) { return std::string(depth, '[') + std::string(depth, ']'); };
    EXPECT_NO_THROW(parse_json(nested(max_json_depth), "f"));
    EXPECT_EQ(error_of([&] { parse_json(nested(max_json_depth + 1), "f"); }),
              "f:1:65: nested more than 64 deep; no valid file needs that");
    EXPECT_NE(error_of([&] { parse_json(std::string(10'000'000, '['), "f"); }).find("more than 64"),
              std::string::npos);
}

TEST(LocatedJson, RefusesWhatIsNoDocument) {
    EXPECT_EQ(error_of([] { parse_json("", "f"); }),
              "f:1:1: not valid JSON: while parsing value - unexpected end of input; expected '[', "
              "'{', or a literal");
    EXPECT_EQ(error_of([] { load("[1]"); }), "s.json:1:1: /: expected an object, found [1]");
    EXPECT_EQ(error_of([] { load("{\"version\": 1, \"a\nb\": 2}"); }),
              "s.json:1:18: not valid JSON: while parsing object key - invalid string: control "
              "character U+000A (LF) "
              "must be escaped to \\u000A or \\n");
    EXPECT_NO_THROW(parse_json("1.0", "f"));
    EXPECT_THROW(parse_json("\xff", "f"), SceneError);
}

TEST(LocatedJson, ShowsHostileTextHarmlessly) { // no escape sequence reaches the terminal
    EXPECT_EQ(
        error_of([] { load(with(good_scene, "\"version\": 1", "\"version\": \"\\u001b[2J\"")); }),
        "s.json:2:14: /version: expected an integer, found \"\\u001b[2J\"");
}

TEST(Suggest, CountsInsertionsDeletionsReplacementsAndSwaps) {
    EXPECT_EQ(edit_distance("", "abc"), 3);
    EXPECT_EQ(edit_distance("kitten", "sitting"), 3);
    EXPECT_EQ(edit_distance("raduis", "radius"), 1); // a swap; plain Levenshtein says 2
    EXPECT_EQ(edit_distance("same", "same"), 0);
    EXPECT_EQ(did_you_mean("camrea", {"film", "camera"}), "; did you mean \"camera\"?");
    EXPECT_EQ(did_you_mean("zebra", {"film", "camera"}), "");
}

} // namespace
} // namespace raylab
