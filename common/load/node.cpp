// Typed reading of a scene file, with an error for each way to be wrong.
#include "common/load/node.h"

#include "common/load/scene_error.h"
#include "common/load/suggest.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace raylab {
namespace {

// RFC 6901: "~" and "/" within a key are escaped in a path.
std::string escaped(const std::string& key) {
    std::string result;
    for (const char c : key) result += c == '~' ? "~0" : c == '/' ? "~1" : std::string(1, c);
    return result;
}

} // namespace

void Node::expect_object() const {
    if (json_->kind != Json::Kind::object) fail_expected("an object");
}

void Node::expect_keys(const std::vector<std::string>& known, const std::string& of) const {
    expect_object();
    for (std::size_t i = 0; i < json_->keys.size(); ++i) {
        const std::string& key = json_->keys[i];
        if (std::find(known.begin(), known.end(), key) != known.end()) continue;
        fail_at(json_->key_offsets[i], path_ + "/" + escaped(key),
                "unknown key" + did_you_mean(key, known) + "; the keys of " + of + " are " +
                    listed(known));
    }
}

Node Node::at(const std::string& key) const {
    expect_object();
    if (const Json* json = json_->find(key))
        return Node(*document_, *json, path_ + "/" + escaped(key));
    fail(fmt::format("expected a key \"{}\" in this object, found none", key));
}

std::optional<Node> Node::find(const std::string& key) const {
    if (has(key)) return at(key);
    return std::nullopt;
}

std::vector<Node> Node::elements() const {
    if (!is_array()) fail_expected("an array");
    std::vector<Node> nodes;
    for (std::size_t i = 0; i < json_->items.size(); ++i)
        nodes.emplace_back(*document_, json_->items[i], fmt::format("{}/{}", path_, i));
    return nodes;
}

std::vector<std::pair<std::string, Node>> Node::members() const {
    expect_object();
    std::vector<std::pair<std::string, Node>> nodes;
    for (std::size_t i = 0; i < json_->items.size(); ++i)
        nodes.emplace_back(json_->keys[i], Node(*document_, json_->items[i],
                                                path_ + "/" + escaped(json_->keys[i])));
    return nodes;
}

bool Node::boolean() const {
    if (json_->kind != Json::Kind::boolean) fail_expected("true or false");
    return json_->boolean;
}

std::string Node::string() const {
    if (json_->kind != Json::Kind::string) fail_expected("a string");
    return json_->string;
}

int Node::integer() const {
    constexpr double high = std::numeric_limits<int>::max();
    if (json_->kind != Json::Kind::number || json_->number != std::floor(json_->number))
        fail_expected("an integer");
    if (std::fabs(json_->number) > high) fail_expected("an integer of at most 2147483647");
    return int(json_->number);
}

std::uint32_t Node::seed() const {
    const double value = number();
    if (!(value >= 0 && value <= 4294967295.0 && value == std::floor(value)))
        fail_expected("an integer from 0 to 4294967295");
    return std::uint32_t(value);
}

double Node::number(double low, double high) const {
    if (json_->kind != Json::Kind::number) fail_expected("a number");
    if (json_->number < low || json_->number > high) {
        if (high == std::numeric_limits<double>::max())
            fail_expected(fmt::format("a number of at least {}", low));
        fail_expected(fmt::format("a number from {} to {}", low, high));
    }
    if (std::fabs(json_->number) > std::numeric_limits<float>::max())
        fail_expected("a number of at most 3.4e38 (single precision)");
    return json_->number;
}

double Node::positive() const {
    const double value = number();
    if (!(float(value) > 0)) fail_expected("a number greater than 0");
    return value;
}

double Node::not_negative() const { return number(0); }

DVec3 Node::vec3() const {
    if (!is_array() || json_->items.size() != 3) fail_expected("an array of 3 numbers");
    const std::vector<Node> e = elements();
    return DVec3(e[0].number(), e[1].number(), e[2].number());
}

DVec3 Node::direction() const {
    const DVec3 v = vec3();
    const double largest = std::max({std::fabs(v.x), std::fabs(v.y), std::fabs(v.z)});
    if (largest == 0) fail("expected a direction, found [0, 0, 0], which has none");
    const DVec3 scaled = v / largest; // so that no square over- or underflows
    return scaled / std::sqrt(dot(scaled, scaled));
}

Vec3 Node::rgb(double high) const {
    if (!is_array() || json_->items.size() != 3)
        fail_expected("an array of 3 numbers: red, green, blue");
    const std::vector<Node> e = elements();
    return Vec3(e[0].number(0, high), e[1].number(0, high), e[2].number(0, high));
}

std::string Node::word(const std::vector<std::string>& known) const {
    if (json_->kind != Json::Kind::string) fail_expected(raylab::one_of(known));
    if (std::find(known.begin(), known.end(), json_->string) == known.end())
        fail_expected(raylab::one_of(known), did_you_mean(json_->string, known));
    return json_->string;
}

void Node::fail_expected(const std::string& what, const std::string& then) const {
    fail(fmt::format("expected {}, found {}{}", what, describe(*json_), then));
}

void Node::fail(const std::string& what) const { fail_at(json_->offset, path_, what); }

std::string Node::place() const {
    return document_->place(json_->offset) + ": " + (path_.empty() ? "/" : path_);
}

void Node::fail_at(std::size_t offset, const std::string& path, const std::string& what) const {
    throw SceneError(document_->place(offset) + ": " + (path.empty() ? "/" : path) + ": " + what);
}

} // namespace raylab
