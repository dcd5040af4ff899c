// TRI-EDGE and TRI-SCALE: rays aimed at the edges and vertices of a closed mesh never get out.
//
// This file is also compiled with -ffast-math: watertightness must not hang on rounding details.
#include "common/geometry/tests/naive.h"
#include "common/geometry/tests/support.h"

namespace raylab::test {
namespace {

// From somewhere inside to a vertex, an edge's midpoint, or anywhere on an edge.
struct EdgeRay {
    Ray ray;
    int from, to; // the edge's vertices
};

EdgeRay aim_at_an_edge(Random& random, const Mesh& mesh, Vec3 o) {
    const auto& face = mesh.faces[random.below(int(mesh.faces.size()))];
    const int corner = random.below(3), from = face[corner], to = face[(corner + 1) % 3];
    const int kind = random.below(3);
    const double s = kind == 0 ? 0 : kind == 1 ? 0.5 : random.uniform();
    const DVec3 target = (1 - s) * DVec3(mesh.vertices[from]) + s * DVec3(mesh.vertices[to]);
    return {{o, Vec3(glm::normalize(target - DVec3(o)))}, from, to};
}

// Does any face stop the ray? Those at the edge's two vertices are asked first: all others are only
// needed if none of them does, to be sure.
template <class Stops> bool is_stopped(const Mesh& mesh, const EdgeRay& aimed, const Stops& stops) {
    for (int vertex : {aimed.from, aimed.to})
        for (int face : mesh.faces_at[vertex])
            if (stops(mesh.triangle(face), aimed.ray)) return true;
    for (int face = 0; face < int(mesh.faces.size()); ++face)
        if (stops(mesh.triangle(face), aimed.ray)) return true;
    return false;
}

bool ours(const Triangle& triangle, const Ray& ray) {
    float t;
    return intersect(triangle, ShearedRay(ray), t);
}

bool moller_trumbore(const Triangle& triangle, const Ray& ray) {
    float t;
    return naive::moller_trumbore(triangle, ray, 1e-8f, 0, t);
}

TEST(TRI_EDGE, no_ray_leaves_a_closed_mesh_through_an_edge) {
    const Mesh mesh = icosphere(4, 1, DVec3(0));
    ASSERT_EQ(mesh.faces.size(), 5120u);
    const int n = rays(100'000, 1'000'000);
    int leaks = 0, woop_leaks = 0, naive_leaks = 0;
    Random random(11);
    for (int i = 0; i < n; ++i) {
        const EdgeRay aimed =
            aim_at_an_edge(random, mesh, Vec3(0.9 * random.uniform() * random.unit()));
        leaks += !is_stopped(mesh, aimed, ours);
        if (i % 10) continue; // the variants leak so often that a tenth of the rays shows it
        woop_leaks += !is_stopped(mesh, aimed, [](const Triangle& triangle, const Ray& ray) {
            return naive::woop(triangle, ray);
        });
        naive_leaks += !is_stopped(mesh, aimed, moller_trumbore);
    }
    figure("TRI-EDGE", "leaks per 1e6 (naive: Moller-Trumbore)", leaks * 1e6 / n, 0,
           naive_leaks * 1e7 / n);
#ifdef RAYLAB_CONTRACTED // only fused multiply-add breaks it
    figure("TRI-EDGE", "leaks per 1e6 (naive: Woop in float)", leaks * 1e6 / n, 0,
           woop_leaks * 1e7 / n);
#else
    note("TRI-EDGE", "leaks per 1e6 (naive: Woop in float)", leaks * 1e6 / n, woop_leaks * 1e7 / n);
#endif
}

TEST(TRI_SCALE, no_leak_at_any_size_or_place) {
    const struct {
        double radius, offset;
    } cases[] = {{1e-3, 0}, {1e-2, 0}, {1, 0}, {1e4, 0}, {1, 1e3}, {1, 1e5}, {1e4, 1e5}};
    for (const auto& [radius, offset] : cases) {
        const DVec3 center = offset * DVec3(0.48, -0.6, 0.64);
        const Mesh mesh = icosphere(4, radius, center);
        const int n = rays(30'000, 1'000'000);
        int leaks = 0, naive_leaks = 0;
        Random random(12);
        for (int i = 0; i < n; ++i) {
            const EdgeRay aimed = aim_at_an_edge(
                random, mesh, Vec3(center + 0.5 * radius * random.uniform() * random.unit()));
            leaks += !is_stopped(mesh, aimed, ours);
            if (i % 10 == 0) naive_leaks += !is_stopped(mesh, aimed, moller_trumbore);
        }
        char what[64];
        std::snprintf(what, sizeof what, "leaks per 1e6, R = %g, centre at %g", radius, offset);
        figure("TRI-SCALE", what, leaks * 1e6 / n, 0,
               radius < 0.1 ? std::optional(naive_leaks * 1e7 / n) : std::nullopt);
    }
}

// Two large faces meet at an edge; the ray starts a few ulps above one, very near the edge. In
// float the far corners' rounding exceeds that height, and the ray may find neither face.
TEST(TRI_EDGE, no_leak_from_close_above_a_large_face_beside_its_edge) {
    const int n = rays(200'000, 1'000'000);
    int leaks = 0, naive_leaks = 0;
    Random random(13);
    for (int i = 0; i < n; ++i) {
        // A floor and a wall with a common edge at y = 0, of slanted directions, 100 units long.
        const DVec3 along = 100.0 * random.unit();
        const DVec3 side = 100.0 * glm::normalize(cross(along, random.unit()));
        const DVec3 up = 100.0 * glm::normalize(cross(side, along));
        const Vec3 a(-along), b(along);
        const Triangle floor = make_triangle(a, b, Vec3(side)),
                       wall = make_triangle(b, a, Vec3(up));
        const double clearance = std::pow(10, random.between(-6, -3));
        const double cosine = std::pow(10, random.between(-3, 0));
        const Vec3 o(clearance * side / 100.0 + clearance * 1e-2 * up / 100.0);
        const Ray ray{o, Vec3(glm::normalize(-side + cosine * up))};
        leaks += !ours(floor, ray) && !ours(wall, ray);
        naive_leaks += !moller_trumbore(floor, ray) && !moller_trumbore(wall, ray);
    }
    figure("TRI-EDGE", "leaks per 1e6 from beside the edge of two large faces", leaks * 1e6 / n, 0);
    note("TRI-EDGE", "the same, Moller-Trumbore", leaks * 1e6 / n, naive_leaks * 1e6 / n);
}

} // namespace
} // namespace raylab::test
