// The section `shapes`: spheres, boxes, quads, planes, triangles, transformed into world space.
// Meshes are in read_mesh.cpp and read_procedural.cpp.
#include "common/geometry/make_quad.h"
#include "common/geometry/parameters.h"
#include "common/load/keys.h"
#include "common/load/scene_builder.h"
#include "common/scene/triangle_runs.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab {
namespace {

// A sphere is traced as a sphere up to this radius, in units of the distance from which the camera
// sees it.
constexpr double max_radius_seen = 0x1p30;

double norm(DVec3 v) { return std::sqrt(dot(v, v)); }

template <int N> void read_vertices(const Node& node, DVec3 (&v)[N]) {
    const std::vector<Node> vertices = node.elements();
    if (vertices.size() != N) node.fail_expected(fmt::format("an array of {} points", N));
    for (int i = 0; i < N; ++i) v[i] = vertices[i].vec3();
}

DVec3 quad_normal(const Vec3 (&v)[4]) {
    return cross(DVec3(v[1]) - DVec3(v[0]), DVec3(v[3]) - DVec3(v[0]));
}

// How far along the unit vector n rounding to single precision may have moved a corner.
double rounding_along(const Vec3 (&v)[4], DVec3 n) {
    Vec3 largest(0);
    for (const Vec3& corner : v) largest = glm::max(largest, abs(corner));
    return unit_roundoff * dot(DVec3(largest), glm::abs(n));
}

// How far rounding may have moved v[2], unit normal n, off the plane of the others: by its own
// rounding and by theirs, in proportion to v[2] = (1 - a - b) v[0] + a v[1] + b v[3].
double bend_by_rounding(const Vec3 (&v)[4], DVec3 n) {
    const Vec2 c = affine_coordinates(v[0], v[1], v[3], DVec3(v[2]));
    return rounding_along(v, n) * (1 + std::fabs(1 - c.x - c.y) + std::fabs(c.x) + std::fabs(c.y));
}

// A hint for a quad whose corners are no longer in one plane after rounding.
std::string precision_hint(const Vec3 (&v)[4], double size) {
    float largest = 0;
    for (const Vec3& corner : v) largest = std::max(largest, max_component(abs(corner)));
    const double rounding = unit_roundoff * largest;
    if (size > 1024 * rounding) return "";
    return fmt::format("; so far from the origin single precision rounds a coordinate by up to "
                       "{:.2g}: move the scene nearer to it",
                       rounding);
}

} // namespace

void SceneBuilder::read_shapes(const Node& shapes) {
    for (const Node& shape : shapes.elements()) {
        shape.expect_object();
        const Node kind = shape.at("kind");
        const std::string word =
            kind.word({"sphere", "box", "quad", "plane", "triangle", "mesh", "procedural"});
        shape.expect_keys(scene_keys().at("shape " + word), "a shape of kind " + word);
        if (word == "mesh") {
            read_mesh(shape);
            continue;
        }
        if (word == "procedural") {
            read_procedural(shape);
            continue;
        }
        const int material = material_named(shape.at("material"));
        if (scene_.materials[material].texture >= 0)
            shape.at("material")
                .fail("expected a material without a texture, since only meshes have "
                      "texture coordinates; use a mesh, or a reflectance");
        if (word == "sphere") read_sphere(shape, material);
        if (word == "box") read_box(shape, material);
        if (word == "quad") read_quad(shape, material);
        if (word == "plane") read_plane(shape, material);
        if (word == "triangle") read_triangle(shape, material);
    }
    const int first = int(scene_.triangles.size());
    scene_.triangles.insert(scene_.triangles.end(), loose_.begin(), loose_.end());
    cut_into_runs(scene_.triangles, first, scene_.runs);
    if (left_out_ > 0)
        scene_.warnings.push_back(
            fmt::format("{}: this triangle has no area and is left out, {} in all", first_left_out_,
                        left_out_));
}

// scale, then the rotations in order, then translate.
Transform SceneBuilder::read_transform(const Node& shape) const {
    Transform transform;
    const auto node = shape.find("transform");
    if (!node) return transform;
    node->expect_keys(scene_keys().at("transform"), "a transform");
    if (const auto scale = node->find("scale")) {
        const DVec3 s = scale->is_array() ? scale->vec3() : DVec3(scale->number());
        if (s.x == 0 || s.y == 0 || s.z == 0)
            scale->fail_expected("factors other than 0", ", which flattens the shape");
        transform.linear = glm::dmat3(s.x, 0, 0, 0, s.y, 0, 0, 0, s.z);
    }
    if (const auto rotations = node->find("rotate"))
        for (const Node& turn : rotations->elements()) {
            turn.expect_keys(scene_keys().at("rotate"), "a rotation");
            transform.linear =
                rotation(turn.at("axis").direction(), glm::radians(turn.at("angle_deg").number())) *
                transform.linear;
        }
    if (const auto translate = node->find("translate")) transform.translation = translate->vec3();
    return transform;
}

Vec3 SceneBuilder::placed(const Node& shape, const Transform& transform, DVec3 p) const {
    const Vec3 result = transform.point(p);
    if (!is_finite(result))
        shape.fail(
            "the transform moves this shape beyond single precision (3.4e38); scale it down");
    return result;
}

void SceneBuilder::read_sphere(const Node& shape, int material) {
    const Transform transform = read_transform(shape);
    const glm::dmat3& m = transform.linear;
    const double scale = norm(m[0]);
    if (std::fabs(norm(m[1]) - scale) > 1e-6 * scale ||
        std::fabs(norm(m[2]) - scale) > 1e-6 * scale)
        shape.at("transform")
            .at("scale")
            .fail("expected one factor for all axes: a sphere stretched "
                  "along one axis is no sphere; use a mesh");
    const DVec3 at = shape.at("center").vec3(), center = transform.point(at);
    placed(shape, transform, at);
    const double radius = scale * shape.at("radius").positive();
    if (!std::isfinite(float(radius)) || !(float(radius) > 0))
        shape.fail(
            fmt::format("the transform makes the radius {}, beyond single precision", radius));

    // Double holds a sphere's surface to about radius * 2^-52. A ground so large that this could be
    // seen is replaced by the plane that touches it below the camera: the horizon, sqrt(2 height /
    // radius) below eye level, rises by less than 5e-5.
    const DVec3 to_camera = DVec3(scene_.camera.position) - center;
    const double height = norm(to_camera) - radius;
    const double seen = std::max(height, double(scene_.camera.focus_distance));
    if (height >= 0 && radius > max_radius_seen * seen) {
        if (is_emissive(scene_.materials[material]))
            shape.fail(
                "the camera is so near to this glowing sphere that it would have to become a "
                "plane, which is too large to be a light; use a quad");
        const DVec3 normal = to_camera / norm(to_camera);
        scene_.planes.push_back(
            {Vec3(center + radius * normal), Vec3(normal), {next_id_++, material, -1}});
        scene_.warnings.push_back(shape.place() +
                                  ": a sphere of more than 10^9 times the distances that the "
                                  "camera sees is replaced by a plane; write a plane");
        return;
    }
    scene_.spheres.push_back({center, radius, {next_id_++, material, -1}});
}

// Six faces over eight corners that are rounded once, so that neighbours share their edges' bits.
void SceneBuilder::read_box(const Node& shape, int material) {
    const Transform transform = read_transform(shape);
    const Node high_node = shape.at("high");
    const DVec3 low = shape.at("low").vec3(), high = high_node.vec3();
    if (!(low.x < high.x && low.y < high.y && low.z < high.z))
        high_node.fail_expected("each coordinate greater than that of low");
    Vec3 corner[8]; // bit 0: x is high; bit 1: y; bit 2: z
    for (int i = 0; i < 8; ++i)
        corner[i] =
            placed(shape, transform,
                   DVec3(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z));
    // Counterclockwise seen from outside: -x, +x, -y, +y, -z, +z.
    constexpr int faces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                 {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
    for (const auto& f : faces) {
        Vec3 v[4];
        for (int i = 0; i < 4; ++i) v[i] = corner[f[transform.mirrors() ? (4 - i) % 4 : i]];
        add_quad(shape, v, material);
    }
}

void SceneBuilder::read_quad(const Node& shape, int material) {
    const Transform transform = read_transform(shape);
    DVec3 p[4];
    read_vertices(shape.at("vertices"), p);
    Vec3 v[4];
    for (int i = 0; i < 4; ++i)
        v[i] = placed(shape, transform, p[transform.mirrors() ? (4 - i) % 4 : i]);
    add_quad(shape, v, material);
}

// Checks the quad as it will be traced: in single precision, after its transform.
void SceneBuilder::add_quad(const Node& shape, const Vec3 (&v)[4], int material) {
    const DVec3 n = quad_normal(v);
    const double diagonal =
        std::max(norm(DVec3(v[2]) - DVec3(v[0])), norm(DVec3(v[3]) - DVec3(v[1])));
    if (!(norm(n) > 1e-12 * diagonal * diagonal))
        shape.fail("expected a quad with an area, found corners 0, 1 and 3 in one line" +
                   precision_hint(v, diagonal));
    const DVec3 normal = n / norm(n);
    for (int i = 0; i < 4; ++i) {
        const DVec3 here(v[i]), next(v[(i + 1) % 4]), before(v[(i + 3) % 4]);
        const double away = std::fabs(dot(normal, here - DVec3(v[0])));
        if (away > 1e-4 * diagonal + bend_by_rounding(v, normal))
            shape.fail(
                fmt::format("expected a flat quad, found corner {} at {:.3g} from the plane of "
                            "the others; use two triangles",
                            i, away));
        if (!(dot(normal, cross(next - here, before - here)) > 0))
            shape.fail(
                fmt::format("expected a convex quad with its corners in order around the edge, "
                            "found a turn the other way at corner {}; reorder the corners or use "
                            "two triangles{}",
                            i, precision_hint(v, diagonal)));
    }
    scene_.quads.push_back(make_quad({v[0], v[1], v[2], v[3]}, {next_id_++, material, -1}));
}

void SceneBuilder::read_plane(const Node& shape, int material) {
    if (is_emissive(scene_.materials[material]))
        shape.at("material")
            .fail("expected a material without emission: a plane is infinite, so no "
                  "point on it could be sampled as a light; use a quad");
    scene_.planes.push_back({Vec3(shape.at("point").vec3()),
                             Vec3(shape.at("normal").direction()),
                             {next_id_++, material, -1}});
}

void SceneBuilder::read_triangle(const Node& shape, int material) {
    const Transform transform = read_transform(shape);
    DVec3 p[3];
    read_vertices(shape.at("vertices"), p);
    if (transform.mirrors()) std::swap(p[1], p[2]);
    Triangle triangle{{}, {}, -1, {next_id_, material, -1}};
    for (int i = 0; i < 3; ++i) triangle.v[i] = placed(shape, transform, p[i]);
    if (!set_normal(triangle)) {
        if (left_out_++ == 0) first_left_out_ = shape.place();
        return;
    }
    ++next_id_;
    loose_.push_back(triangle);
}

// In double, where the products of single-precision differences are exact: only a triangle whose
// vertices are in one line, or not finite, has no normal.
bool set_normal(Triangle& triangle) {
    const DVec3 a(triangle.v[0]), b(triangle.v[1]), c(triangle.v[2]);
    const DVec3 n = cross(b - a, c - a);
    const double size = norm(n);
    if (!(size > 0) || !std::isfinite(size)) return false;
    triangle.normal = n / size;
    return true;
}

} // namespace raylab
