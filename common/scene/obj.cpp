// Wavefront OBJ by tinyobjloader. The library takes a garbled number for 0 and trusts some counts,
// so every line it will see is checked first, which also tells where in the file an error is; lines
// that describe no surface (groups, materials, curves) are not handed on.
#include "common/scene/located_json.h"
#include "common/scene/mesh.h"
#include "common/scene/scene_error.h"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <sstream>

namespace raylab {
namespace {

// tinyobjloader's triangulation takes quadratic time in a polygon's corners.
constexpr std::size_t max_polygon_corners = 256;

class ObjChecker {
  public:
    explicit ObjChecker(const std::string& name) : name_(name) {}

    // The lines of the text that make surfaces; throws SceneError if one of them is wrong.
    std::string surfaces(std::string_view text) {
        while (!text.empty()) {
            ++line_;
            const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
            check_line(text.substr(0, end));
            text.remove_prefix(end);
            if (!text.empty()) text.remove_prefix(text.starts_with("\r\n") ? 2 : 1);
        }
        if (faces_ == 0)
            throw SceneError(name_ + ": expected faces (lines that begin with f), found none");
        return std::move(checked_);
    }

  private:
    void check_line(std::string_view line) {
        line = line.substr(0, line.find('#'));
        const std::vector<std::string_view> words = split(line);
        if (words.empty()) return;
        const auto at = [&](std::size_t i) { return std::size_t(words[i].data() - line.data()); };
        if (words[0] == "v" || words[0] == "vn" || words[0] == "vt") {
            const bool texture = words[0] == "vt";
            const std::size_t least = texture ? 1 : 3;
            if (words.size() < least + 1)
                fail(at(0), fmt::format("expected {} numbers after {}, found {}", texture ? 2 : 3,
                                        words[0], words.size() - 1));
            checked_ += words[0];
            for (std::size_t i = 1; i < std::min<std::size_t>(words.size(), 4); ++i)
                checked_.append(" ").append(number(words[i], at(i)));
            ++count_[words[0] == "v" ? 0 : texture ? 1 : 2];
        } else if (words[0] == "f") {
            if (words.size() < 4)
                fail(at(0), fmt::format("expected a face of at least 3 corners, found {}",
                                        words.size() - 1));
            if (words.size() > max_polygon_corners + 1)
                fail(at(0), fmt::format("expected a face of at most {} corners, found {}; split it",
                                        max_polygon_corners, words.size() - 1));
            for (std::size_t i = 1; i < words.size(); ++i) check_corner(words[i], at(i));
            checked_ += line.substr(at(0));
            ++faces_;
        } else {
            return;
        }
        checked_ += '\n';
    }

    static std::vector<std::string_view> split(std::string_view line) {
        std::vector<std::string_view> words;
        for (std::size_t begin = 0; (begin = line.find_first_not_of(" \t", begin)) != line.npos;) {
            const std::size_t end = std::min(line.find_first_of(" \t", begin), line.size());
            words.push_back(line.substr(begin, end - begin));
            begin = end;
        }
        return words;
    }

    std::string number(std::string_view word, std::size_t at) const {
        double value = 0;
        const char* begin = word.data() + (word.starts_with('+') ? 1 : 0);
        const char* end = word.data() + word.size();
        const auto [stop, error] = std::from_chars(begin, end, value);
        if (error == std::errc::invalid_argument || stop != end)
            fail(at, fmt::format("expected a number, found {}", quote(std::string(word))));
        if (error != std::errc() || !(std::fabs(value) <= std::numeric_limits<float>::max()))
            fail(at, fmt::format("expected a finite number in single precision, found {}", word));
        // The library's own exponents overflow.
        return word.find_first_of("eE") == word.npos ? std::string(word) : fmt::format("{}", value);
    }

    // position[/[texture coordinate][/normal]], each counted from 1, or from the last one back from
    // -1.
    void check_corner(std::string_view word, std::size_t at) const {
        static constexpr std::array<const char*, 3> what{"vertex", "texture coordinate", "normal"};
        std::string_view rest = word;
        for (std::size_t part = 0; part < 3; ++part) {
            const std::size_t slash = std::min(rest.find('/'), rest.size());
            const std::string_view digits = rest.substr(0, slash);
            const bool left_out = digits.empty() && part == 1 && slash < rest.size(); // 1//3
            if (!left_out) {
                int index = 0;
                const auto [stop, error] =
                    std::from_chars(digits.data(), digits.data() + digits.size(), index);
                if (error != std::errc() || stop != digits.data() + digits.size())
                    fail(at,
                         fmt::format("expected a corner such as 1, 1/2, 1//3 or 1/2/3, found {}",
                                     quote(std::string(word))));
                if (index == 0 || index > count_[part] || index < -count_[part])
                    fail(at, fmt::format(
                                 "{} {} does not exist; {} are defined above this line, counted "
                                 "from 1",
                                 what[part], index, count_[part]));
            }
            if (slash == rest.size()) return;
            rest.remove_prefix(slash + 1);
        }
        fail(at, fmt::format("expected a corner such as 1, 1/2, 1//3 or 1/2/3, found {}",
                             quote(std::string(word))));
    }

    [[noreturn]] void fail(std::size_t at, const std::string& what) const {
        throw SceneError(fmt::format("{}:{}:{}: {}", name_, line_, at + 1, what));
    }

    const std::string& name_;
    std::string checked_;
    int line_ = 0;
    std::array<int, 3> count_{}; // vertices, texture coordinates, normals so far
    int faces_ = 0;
};

} // namespace

Mesh parse_obj(std::string_view text, const std::string& name) {
    std::istringstream stream(ObjChecker(name).surfaces(text));
    tinyobj::attrib_t attributes;
    std::vector<tinyobj::shape_t> shapes;
    std::vector<tinyobj::material_t> materials;
    std::string warning, error;
    constexpr bool triangulate = true, default_vertex_colors = false;
    if (!tinyobj::LoadObj(&attributes, &shapes, &materials, &warning, &error, &stream, nullptr,
                          triangulate, default_vertex_colors))
        throw SceneError(name + ": " + error);

    Mesh mesh;
    for (std::size_t i = 0; i + 2 < attributes.vertices.size(); i += 3)
        mesh.positions.emplace_back(attributes.vertices[i], attributes.vertices[i + 1],
                                    attributes.vertices[i + 2]);
    for (std::size_t i = 0; i + 2 < attributes.normals.size(); i += 3)
        mesh.normals.emplace_back(attributes.normals[i], attributes.normals[i + 1],
                                  attributes.normals[i + 2]);
    for (std::size_t i = 0; i + 1 < attributes.texcoords.size(); i += 2)
        mesh.uvs.emplace_back(attributes.texcoords[i], attributes.texcoords[i + 1]);
    for (const tinyobj::shape_t& shape : shapes) {
        const std::vector<tinyobj::index_t>& corners = shape.mesh.indices;
        for (std::size_t first = 0; first + 2 < corners.size(); first += 3) {
            MeshTriangle triangle;
            for (int i = 0; i < 3; ++i) {
                triangle.position[i] = corners[first + i].vertex_index;
                triangle.normal[i] = corners[first + i].normal_index;
                triangle.uv[i] = corners[first + i].texcoord_index;
            }
            // A triangle has normals or texture coordinates at all its corners or at none.
            for (auto* part : {&triangle.normal, &triangle.uv})
                if ((*part)[0] < 0 || (*part)[1] < 0 || (*part)[2] < 0) *part = {-1, -1, -1};
            mesh.triangles.push_back(triangle);
        }
    }
    return mesh;
}

} // namespace raylab
