// BOX-CORNER for triangles: no path leaves a closed mesh, however sharp its corners are and
// wherever it lies. And a point that is kept clear of the edges stays where it was, as nearly as it
// can.
#include "common/geometry/tests/support.h"

#include <cmath>

namespace raylab::test {
namespace {

struct Solid {
    const char* name;
    std::vector<DVec3> points;
    std::vector<std::array<int, 3>> faces;
};

constexpr int cube_faces[12][3] = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5},
                                   {0, 1, 5}, {0, 5, 4}, {2, 6, 7}, {2, 7, 3},
                                   {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};

Solid cube() {
    Solid solid{"cube", {}, {}};
    for (int k = 0; k < 8; ++k)
        solid.points.push_back(2.0 * DVec3(k & 1, k >> 1 & 1, k >> 2) - 1.0);
    for (const auto& f : cube_faces) solid.faces.push_back({f[0], f[1], f[2]});
    return solid;
}

Solid tetrahedron(const char* name, DVec3 top) {
    return {name,
            {{-1, -0.6, -0.7}, {1, -0.6, -0.7}, {0, -0.6, 1}, top},
            {{0, 1, 2}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

Solid ball() {
    const Mesh mesh = icosphere(2, 1, DVec3(0));
    return {"icosphere", {mesh.vertices.begin(), mesh.vertices.end()}, mesh.faces};
}

// Corners of about 10 degrees; edges at which two faces meet at 25 degrees; both; corners of all
// kinds.
std::vector<Solid> solids() {
    return {cube(), tetrahedron("spike", {0, 5, 0}), tetrahedron("flat", {0, -0.35, 0}),
            tetrahedron("leaning", {2, 0.4, 1}), ball()};
}

// The hit as it is before it is kept clear of edges.
SurfacePoint not_cleared(const Triangle& triangle, DVec3 p) {
    SurfacePoint s{};
    const ExactPlane plane = exact_plane(triangle);
    s.p = Vec3(project(plane, p));
    s.ng = triangle.normal;
    s.error = error_on_plane(plane, s.p, s.ng,
                             normal_conditioning(triangle.v[0], triangle.v[1], triangle.v[2]));
    return s;
}

// A path bounces about in the mesh; it begins with a ray at an edge or a corner. Does it get out?
bool escapes(const World& world, DVec3 from, Random& random, bool is_naive) {
    const SceneView scene = world.view();
    const Triangle& aimed = world.triangles[random.below(int(world.triangles.size()))];
    const double along = random.below(2) ? random.uniform() : 0;
    const DVec3 at = (1 - along) * DVec3(aimed.v[0]) + along * DVec3(aimed.v[1]);
    Ray ray{Vec3(from), Vec3(glm::normalize(at - DVec3(Vec3(from))))};
    for (int bounce = 0; bounce < 20; ++bounce) {
        const Hit hit = intersect<feature::triangle>(scene, ray);
        if (!hit.found()) return true;
        SurfacePoint p = surface_at<feature::triangle>(scene, ray, hit);
        if (is_naive)
            p = not_cleared(world.triangles[hit.index],
                            DVec3(ray.o) + double(hit.t) * DVec3(ray.d));
        const Vec3 inward = dot(p.ng, ray.d) < 0 ? p.ng : -p.ng;
        ray = spawn_ray(p, random.cosine_direction(inward));
    }
    return false;
}

TEST(CLOSED_MESH, nothing_escapes) {
    const int n = rays(200, 30'000), turns = 10;
    for (const Solid& solid : solids()) {
        int escaped = 0, naive_escaped = 0;
        for (const double size : {1e-4, 1.0, 1e4})
            // How far away, in sizes: at 65536 the shape is some hundred floats wide.
            for (const double away : {0.0, 1.0, 30.0, 4096.0, 65536.0})
                for (int turn = 0; turn < turns; ++turn) {
                    Random random(160 + turn);
                    const DVec3 z = random.unit(), x = glm::normalize(cross(z, random.unit())),
                                y = cross(z, x);
                    // Along an axis, where the coordinates differ most in size, and at a slant.
                    const DVec3 to = turn % 2 ? random.unit() : DVec3(1, 0, 0);
                    const auto placed = [&](DVec3 p) {
                        return size * (away * to + p.x * x + p.y * y + p.z * z);
                    };
                    World world;
                    for (const auto& f : solid.faces)
                        world.add(make_triangle(Vec3(placed(solid.points[f[0]])),
                                                Vec3(placed(solid.points[f[1]])),
                                                Vec3(placed(solid.points[f[2]]))));
                    world.make_runs(16);
                    DVec3 center(0);
                    for (const DVec3& p : solid.points) center += p / double(solid.points.size());
                    for (int i = 0; i < n / turns; ++i) {
                        Random again = random;
                        escaped += escapes(world, placed(center), random, false);
                        naive_escaped += escapes(world, placed(center), again, true);
                    }
                }
        figure("CLOSED-MESH", std::string(solid.name) + ": escapes", escaped, 0, naive_escaped);
    }
}

// Does p, moved from a point of the face, have its clearance, or what there is room for at least?
template <int n> bool is_clear(const Vec3 (&v)[n], DVec3 p, DVec3 clearance, double room) {
    const DVec3 normal = plane_through(v[0], v[1], v[2]).normal;
    bool clear = true;
    for (int i = 0; i < n; ++i) {
        const DVec3 inward = glm::normalize(cross(normal, DVec3(v[(i + 1) % n]) - DVec3(v[i])));
        const double needed = std::min(dot(clearance, glm::abs(inward)), room);
        clear = clear && dot(inward, p - DVec3(v[i])) >= needed;
    }
    return clear;
}

// The points with clearance are a convex set: no other is nearer to p if none beside it is. room:
// as much as the face has in any case.
template <int n>
void moves_no_farther_than_it_must(Random& random, const Vec3 (&v)[n], double room) {
    const ExactPlane plane = plane_through(v[0], v[1], v[2]);
    const DVec3 e1 = DVec3(v[1]) - DVec3(v[0]), e2 = DVec3(v[n - 1]) - DVec3(v[0]);
    // Near a corner, near an edge, anywhere.
    const double near = std::pow(10, random.between(-8, 0)) / 2;
    const double s = near * random.uniform(), t = near * random.uniform();
    const DVec3 p = DVec3(v[0]) + s * e1 + (random.below(2) ? t : random.uniform() / 2) * e2;
    const float error = error_on_plane(plane, Vec3(p), Vec3(glm::normalize(plane.normal)),
                                       normal_conditioning(v[0], v[1], v[2]));
    const DVec3 clearance = edge_clearance(v, p, error);
    const DVec3 moved = clear_of_edges(v, plane, p, error);
    ASSERT_TRUE(is_clear(v, moved, clearance * (1 - 1e-6), room));
    const double distance = glm::length(moved - p);
    if (distance == 0 || glm::length(clearance) > room) return;
    ASSERT_FALSE(is_clear(v, p, clearance * (1 + 1e-5), infinity)) << "moved without need";
    for (int i = 0; i < 20; ++i) {
        const DVec3 aside = std::pow(10, random.between(-3, 0)) * distance *
                            glm::normalize(cross(plane.normal, random.unit()));
        const DVec3 other = moved + aside;
        if (glm::length(other - p) < distance * (1 - 1e-5)) {
            EXPECT_FALSE(is_clear(v, other, clearance * (1 + 1e-6), infinity));
        }
    }
}

TEST(CLOSED_MESH, a_point_is_moved_no_farther_than_it_must) {
    Random random(170);
    for (int i = 0; i < 20'000; ++i) {
        const DVec3 at = std::pow(10, random.between(-1, 3)) * random.unit();
        const DVec3 x = random.unit(), y = cross(x, glm::normalize(cross(x, random.unit())));
        const double height = std::pow(10, random.between(-3, 0));
        // A needle with the corner v[0] at either end, or a triangle; a trapezoid.
        const double lean = random.between(-0.5, 1.5), top = random.between(0.1, 1);
        const Vec3 triangle[] = {Vec3(at), Vec3(at + x), Vec3(at + lean * x + height * y)};
        const Vec3 quad[] = {Vec3(at), Vec3(at + x), Vec3(at + (lean + top) * x + height * y),
                             Vec3(at + lean * x + height * y)};
        moves_no_farther_than_it_must(random, triangle, height / 8);
        moves_no_farther_than_it_must(random, quad, height / 40);
    }
}

} // namespace
} // namespace raylab::test
