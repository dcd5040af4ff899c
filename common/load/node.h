// Node: a value of a scene file with its place, read as what the loader expects to find there.
#pragma once

#include "common/load/located_json.h"
#include "common/math/vec.h"

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace raylab {

// Each reader throws SceneError `file:line:column: /path: expected ..., found ...` if the value is
// not what its name says. A Node is valid as long as its document.
class Node {
  public:
    Node(const JsonDocument& document, const Json& json, std::string path)
        : document_(&document), json_(&json), path_(std::move(path)) {}
    explicit Node(const JsonDocument& document) : Node(document, document.root, "") {}

    // An object with no other keys than these; `of` says whose keys they are ("a sphere").
    void expect_keys(const std::vector<std::string>& known, const std::string& of) const;
    void expect_object() const;

    bool has(const std::string& key) const { return json_->find(key) != nullptr; }
    Node at(const std::string& key) const;                  // error if the object has no such key
    std::optional<Node> find(const std::string& key) const; // nothing if the object has no such key
    std::vector<Node> elements() const;                     // of an array
    std::vector<std::pair<std::string, Node>> members() const; // of an object

    bool boolean() const;
    std::string string() const;
    int integer() const; // within int
    std::uint32_t seed() const;
    double number(double low = std::numeric_limits<double>::lowest(),
                  double high = std::numeric_limits<double>::max()) const; // also within float
    double positive() const;                                               // > 0, also as float
    double not_negative() const;
    DVec3 vec3() const;
    DVec3 direction() const; // a vec3 that is not zero, normalised
    Vec3 rgb(double high = std::numeric_limits<double>::max()) const; // each in [0, high]
    bool is_array() const { return json_->kind == Json::Kind::array; }

    // The enumerator whose name the string is.
    template <class E> E one_of(const std::vector<std::pair<std::string, E>>& names) const {
        std::vector<std::string> known;
        for (const auto& [name, value] : names) known.push_back(name);
        const std::string found = word(known);
        for (const auto& [name, value] : names)
            if (name == found) return value;
        return names.front().second; // word() has thrown
    }
    std::string word(const std::vector<std::string>& known) const; // a string that is one of them

    [[noreturn]] void fail_expected(const std::string& what, const std::string& then = "") const;
    [[noreturn]] void fail(const std::string& what) const;
    std::string place() const; // "file:line:column: /path"

  private:
    [[noreturn]] void fail_at(std::size_t offset, const std::string& path,
                              const std::string& what) const;

    const JsonDocument* document_;
    const Json* json_;
    std::string path_;
};

} // namespace raylab
