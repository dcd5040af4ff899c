// Wavefront OBJ: what describes surfaces (v, vt, vn, f) and names their materials (usemtl, mtllib);
// groups, curves and lines are passed over.
// Own code, since tinyobjloader takes a garbled number for 0, trusts counts, and cuts polygons with
// notches wrongly.
#include "common/cli/parse_double.h"
#include "common/load/located_json.h"
#include "common/load/mesh.h"
#include "common/load/mtl.h"
#include "common/load/obj_lines.h"
#include "common/load/polygon.h"
#include "common/load/scene_error.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <map>
#include <span>

namespace raylab {
namespace {

// Cutting takes quadratic time in the corners.
constexpr std::size_t max_polygon_corners = 1 << 14;

// The three lists that a corner points into.
enum Part { vertex, texture_coordinate, normal };

class ObjReader {
  public:
    ObjReader(const std::string& name, const ReadNamedFile& read) : name_(name), read_(read) {}

    Mesh read(std::string_view text) {
        ObjLines lines(text);
        for (;;) {
            const std::vector<ObjWord>& words = lines.next();
            if (words.empty()) break;
            const std::string_view kind = words[0].text;
            if (kind == "v")
                mesh_.positions.push_back(numbers(words, 3));
            else if (kind == "vn")
                mesh_.normals.push_back(numbers(words, 3));
            else if (kind == "vt")
                mesh_.uvs.push_back(Vec2(numbers(words, 1)));
            else if (kind == "f")
                add_face(words);
            else if (kind == "usemtl" && read_)
                material_ = material_named(std::string(lines.rest()));
            else if (kind == "mtllib" && read_)
                libraries_.emplace_back(lines.rest());
        }
        if (faces_.empty())
            throw SceneError(name_ + ": expected faces (lines that begin with f), found none");
        if (!mesh_.materials.empty()) read_materials();
        for (const Face& face : faces_) cut(face); // they may name vertices that come later
        warn();
        return std::move(mesh_);
    }

  private:
    using Corner = std::array<int, 3>; // an index for each Part, from 0, or none
    struct Face {
        std::size_t first, count; // of corners_
        ObjWord highest;          // the corner with the highest vertex
        int material;
    };

    [[noreturn]] void fail(const ObjWord& at, const std::string& what) const {
        throw SceneError(fmt::format("{}:{}:{}: {}", name_, at.line, at.column, what));
    }

    // The first three numbers of a statement, of which `least` must be there.
    DVec3 numbers(const std::vector<ObjWord>& words, std::size_t least) const {
        if (words.size() < least + 1)
            fail(words[0], fmt::format("expected {} numbers after {}, found {}", least == 1 ? 2 : 3,
                                       words[0].text, words.size() - 1));
        DVec3 values(0);
        for (std::size_t i = 1; i < std::min<std::size_t>(words.size(), 4); ++i)
            values[int(i) - 1] = number(words[i]);
        return values;
    }

    double number(const ObjWord& word) const {
        double value = 0;
        const std::string_view text = word.text.substr(word.text.starts_with('+') ? 1 : 0);
        const auto [stop, error] = parse_double(text.data(), text.data() + text.size(), value);
        if (error == std::errc::invalid_argument || stop != text.data() + text.size())
            fail(word, fmt::format("expected a number, found {}", quote(std::string(word.text))));
        if (error == std::errc::result_out_of_range) // too large, or so small that it is 0
            value = std::strtod(std::string(text).c_str(), nullptr);
        if (!(std::fabs(value) <= std::numeric_limits<float>::max()))
            fail(word,
                 fmt::format("expected a finite number in single precision, found {}", word.text));
        return value;
    }

    void add_face(const std::vector<ObjWord>& words) {
        const std::size_t count = words.size() - 1;
        if (count < 3) {
            ++without_area_;
            return;
        }
        if (count > max_polygon_corners)
            fail(words[0], fmt::format("expected a face of at most {} corners, found {}; split it",
                                       max_polygon_corners, count));
        Face face{corners_.size(), count, words[1], material_};
        int highest = -1;
        for (std::size_t i = 1; i < words.size(); ++i) {
            corners_.push_back(corner(words[i]));
            if (corners_.back()[vertex] <= highest) continue;
            highest = corners_.back()[vertex];
            face.highest = words[i];
        }
        faces_.push_back(face);
    }

    // vertex[/[texture coordinate][/[normal]]]. Each index counts from 1 at the first of the file,
    // or back from -1 at the last above this line.
    Corner corner(const ObjWord& word) const {
        Corner corner{none, none, none};
        std::string_view rest = word.text;
        for (const Part part : {vertex, texture_coordinate, normal}) {
            const std::size_t slash = std::min(rest.find('/'), rest.size());
            const std::string_view digits = rest.substr(0, slash);
            if (!digits.empty() || part == vertex) corner[part] = index(word, digits, part);
            if (slash == rest.size()) return corner;
            rest.remove_prefix(slash + 1);
        }
        fail_as_corner(word);
    }

    int index(const ObjWord& word, std::string_view digits, Part part) const {
        int index = 0;
        const auto [stop, error] =
            std::from_chars(digits.data(), digits.data() + digits.size(), index);
        if (error != std::errc() || stop != digits.data() + digits.size()) fail_as_corner(word);
        if (index > 0) return index - 1;
        const int above = int(part == vertex               ? mesh_.positions.size()
                              : part == texture_coordinate ? mesh_.uvs.size()
                                                           : mesh_.normals.size());
        if (index < 0 && index >= -above) return above + index;
        if (part == vertex)
            fail(word, fmt::format("vertex {} does not exist; {} are defined above this line, "
                                   "counted from 1, or back from -1",
                                   index, above));
        return missing;
    }

    [[noreturn]] void fail_as_corner(const ObjWord& word) const {
        fail(word, fmt::format("expected a corner such as 1, 1/2, 1//3 or 1/2/3, found {}",
                               quote(std::string(word.text))));
    }

    void cut(const Face& face) {
        const auto corners = std::span(corners_).subspan(face.first, face.count);
        std::vector<DVec3> positions;
        for (Corner& corner : corners) {
            if (corner[vertex] >= int(mesh_.positions.size()))
                fail(face.highest,
                     fmt::format("vertex {} does not exist; the file has {}, counted from 1",
                                 corner[vertex] + 1, mesh_.positions.size()));
            positions.push_back(mesh_.positions[corner[vertex]]);
            check(corner[texture_coordinate], mesh_.uvs.size());
            check(corner[normal], mesh_.normals.size());
        }
        for (const std::array<int, 3>& cut : cut_polygon(positions)) {
            MeshTriangle triangle;
            for (int i = 0; i < 3; ++i) {
                triangle.position[i] = corners[cut[i]][vertex];
                triangle.uv[i] = corners[cut[i]][texture_coordinate];
                triangle.normal[i] = corners[cut[i]][normal];
            }
            // A triangle has normals or texture coordinates at all its corners or at none.
            for (auto* part : {&triangle.normal, &triangle.uv})
                if ((*part)[0] < 0 || (*part)[1] < 0 || (*part)[2] < 0) *part = {none, none, none};
            triangle.material = material_of(face, triangle);
            mesh_.triangles.push_back(triangle);
        }
    }

    int material_named(const std::string& name) {
        const auto [found, is_new] = material_index_.try_emplace(name, int(mesh_.materials.size()));
        if (is_new) mesh_.materials.push_back({name, {}, -1});
        return found->second;
    }

    void read_materials() {
        const MtlLibrary library = read_mtl(libraries_, name_, read_, mesh_);
        for (std::size_t i = 0; i < mesh_.materials.size(); ++i) {
            MeshMaterial& material = mesh_.materials[i];
            const auto found = library.find(material.name);
            if (found != library.end())
                material = found->second;
            else
                mesh_.warnings.push_back(
                    fmt::format("{}: no MTL file describes the material {}; it "
                                "is drawn in grey",
                                name_, quote(material.name)));
            material.source = int(i);
        }
        for (const Face& face : faces_)
            if (face.material < 0 && default_material_ < 0)
                default_material_ = material_named("default");
    }

    // A picture needs texture coordinates: a face without them gets the same material without the
    // picture.
    int material_of(const Face& face, const MeshTriangle& triangle) {
        const int material = face.material < 0 ? default_material_ : face.material;
        if (material < 0 || mesh_.materials[material].picture < 0 || triangle.uv[0] >= 0)
            return material;
        const auto [found, is_new] = plain_.try_emplace(material, int(mesh_.materials.size()));
        if (is_new) {
            MeshMaterial plain = mesh_.materials[material];
            plain.picture = -1;
            mesh_.materials.push_back(plain);
        }
        return found->second;
    }

    void check(int& index, std::size_t size) {
        if (index != missing && index < int(size)) return;
        index = none;
        ++missing_;
    }

    void warn() {
        if (without_area_ > 0)
            mesh_.warnings.push_back(fmt::format(
                "{}: {} faces have fewer than 3 corners and are left out", name_, without_area_));
        if (missing_ > 0)
            mesh_.warnings.push_back(
                fmt::format("{}: {} corners name texture coordinates or normals that the file does "
                            "not have; their faces go without",
                            name_, missing_));
    }

    static constexpr int none = -1, missing = std::numeric_limits<int>::max();

    const std::string& name_;
    const ReadNamedFile& read_;
    Mesh mesh_;
    std::map<std::string, int> material_index_;
    std::map<int, int> plain_; // a material with a picture -> the same one without
    std::vector<std::string> libraries_;
    int material_ = none, default_material_ = none; // current; of faces that name none
    std::vector<Corner> corners_;
    std::vector<Face> faces_;
    int without_area_ = 0, missing_ = 0;
};

} // namespace

Mesh parse_obj(std::string_view text, const std::string& name, const ReadNamedFile& read) {
    return ObjReader(name, read).read(text);
}

} // namespace raylab
