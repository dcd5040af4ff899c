// nlohmann's SAX parser reports every token in order, but not where it stood. A cursor that walks
// over the text beside it, one token per event, knows: strict JSON has only white space, commas and
// colons between two tokens.
#include "common/load/located_json.h"

#include "common/load/scene_error.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <unordered_map>

namespace raylab {
namespace {

class TokenCursor {
  public:
    explicit TokenCursor(std::string_view text)
        : text_(text), at_(text.starts_with("\xEF\xBB\xBF") ? 3 : 0) {}

    // The offset of the next token; the cursor moves behind it.
    std::size_t next() {
        at_ = std::min(text_.find_first_not_of(" \t\r\n,:", at_), text_.size());
        const std::size_t start = at_;
        if (at_ == text_.size()) return start;
        if (text_[at_] == '"') {
            for (++at_; at_ < text_.size() && text_[at_] != '"'; ++at_)
                if (text_[at_] == '\\') ++at_;
            ++at_;
        } else if (std::string_view("{}[]").find(text_[at_]) != std::string_view::npos) {
            ++at_;
        } else {
            at_ = std::min(text_.find_first_of(" \t\r\n,:[]{}\"", at_), text_.size());
        }
        at_ = std::min(at_, text_.size());
        return start;
    }

  private:
    std::string_view text_;
    std::size_t at_;
};

class Builder : public nlohmann::json::json_sax_t {
  public:
    explicit Builder(JsonDocument& document) : document_(document), cursor_(document.text) {}

    bool null() override { return add(Json::Kind::null); }
    bool boolean(bool value) override {
        Json& json = place(Json::Kind::boolean);
        json.boolean = value;
        return true;
    }
    bool number_integer(number_integer_t value) override { return add_number(double(value)); }
    bool number_unsigned(number_unsigned_t value) override { return add_number(double(value)); }
    bool number_float(number_float_t value, const string_t&) override { return add_number(value); }
    bool string(string_t& value) override {
        Json& json = place(Json::Kind::string);
        json.string = std::move(value);
        return true;
    }
    bool binary(binary_t&) override { return false; } // JSON text has none
    bool start_object(std::size_t) override { return open(Json::Kind::object); }
    bool start_array(std::size_t) override { return open(Json::Kind::array); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(string_t& name) override {
        const std::size_t offset = cursor_.next();
        const auto [first, is_new] = open_.back().keys.emplace(name, offset);
        if (!is_new)
            fail(offset, fmt::format("key {} stands here a second time (first on line {}); "
                                     "remove one of them",
                                     quote(name), line_of(first->second)));
        Json& object = *open_.back().json;
        object.keys.push_back(std::move(name));
        object.key_offsets.push_back(offset);
        return true;
    }

    bool parse_error(std::size_t position, const std::string& token,
                     const nlohmann::json::exception& error) override {
        const std::size_t end = document_.text.size();
        const std::string_view what = error.what();
        if (error.id == 406) // a number beyond double
            fail(cursor_.next(), fmt::format("{} is too large; numbers must be finite", token));
        // "[json...101] parse error at line 1, column 5: syntax error while parsing value - ..."
        const std::size_t cut = what.find("while parsing ");
        std::string_view reason = cut == what.npos ? what : what.substr(cut);
        reason = reason.substr(0, reason.find("; last read: ")); // the place shows it
        const auto says = [reason](const char* words) { return reason.find(words) != reason.npos; };
        const char* hint = "";
        if (says("unexpected string literal") || says("unexpected '{'") || says("unexpected '['"))
            hint = "; is a comma missing before it?";
        if (says("object key - unexpected '}'") || says("value - unexpected ']'"))
            hint = "; is there a comma too many before it?";
        // An unexpected token is pointed at where it begins, a broken one where it breaks.
        std::size_t back = 1;
        if (says("unexpected")) back = std::max<std::size_t>(token.size(), 1);
        const std::size_t offset = position > end ? end : position - std::min(position, back);
        fail(offset, fmt::format("not valid JSON: {}{}", reason, hint));
        return false;
    }

  private:
    // A new value at the cursor, in the array or object that is open.
    Json& place(Json::Kind kind) {
        Json* json = &document_.root;
        if (!open_.empty()) json = &open_.back().json->items.emplace_back();
        json->kind = kind;
        json->offset = cursor_.next();
        return *json;
    }
    bool add(Json::Kind kind) {
        place(kind);
        return true;
    }
    bool add_number(double value) {
        place(Json::Kind::number).number = value;
        return true;
    }
    bool open(Json::Kind kind) {
        Json& json = place(kind);
        if (open_.size() == max_json_depth)
            fail(json.offset,
                 fmt::format("nested more than {} deep; no valid file needs that", max_json_depth));
        open_.push_back({&json, {}});
        return true;
    }
    bool close() {
        cursor_.next();
        open_.pop_back();
        return true;
    }

    int line_of(std::size_t offset) const {
        const auto begin = document_.text.begin();
        return 1 + int(std::count(begin, begin + std::ptrdiff_t(offset), '\n'));
    }
    [[noreturn]] void fail(std::size_t offset, const std::string& what) const {
        throw SceneError(document_.place(offset) + ": " + what);
    }

    struct Open {
        Json* json; // stays put: its parent's items do not grow while it is open
        std::unordered_map<std::string, std::size_t> keys;
    };
    JsonDocument& document_;
    TokenCursor cursor_;
    std::vector<Open> open_;
};

} // namespace

const Json* Json::find(std::string_view key) const {
    for (std::size_t i = 0; i < keys.size(); ++i)
        if (keys[i] == key) return &items[i];
    return nullptr;
}

std::string JsonDocument::place(std::size_t offset) const {
    int line = 1, column = 1;
    for (std::size_t i = 0; i < offset && i < text.size(); ++i) {
        if (text[i] == '\n') {
            ++line;
            column = 1;
        } else if ((text[i] & 0xC0) != 0x80) { // not a continuation byte: a new character
            ++column;
        }
    }
    return fmt::format("{}:{}:{}", file, line, column);
}

JsonDocument parse_json(std::string_view text, const std::string& file) {
    JsonDocument document{file, std::string(text), {}};
    Builder builder(document);
    nlohmann::json::sax_parse(document.text, &builder);
    return document;
}

std::string quote(const std::string& text) {
    constexpr std::size_t longest = 60;
    const std::string shown = text.size() > longest ? text.substr(0, longest) + "..." : text;
    return nlohmann::json(shown).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

std::string describe(const Json& value) {
    switch (value.kind) {
    case Json::Kind::null:
        return "null";
    case Json::Kind::boolean:
        return value.boolean ? "true" : "false";
    case Json::Kind::number:
        return fmt::format("{}", value.number);
    case Json::Kind::string:
        return quote(value.string);
    case Json::Kind::array: {
        if (value.items.empty()) return "an empty array";
        std::string list;
        for (const Json& item : value.items) {
            if (item.kind != Json::Kind::number || value.items.size() > 4)
                return fmt::format("an array of {}", value.items.size());
            list.append(list.empty() ? "[" : ", ").append(describe(item));
        }
        return list + "]";
    }
    case Json::Kind::object:
        return "an object";
    }
    return "";
}

} // namespace raylab
