// A scene of one light, for the tests: owns what a SceneView points to.
#pragma once

#include "common/geometry/make_quad.h"
#include "common/light/sample_light.h"

#include <vector>

namespace raylab {

constexpr Features F = feature::all; // the tests know every kind of light

} // namespace raylab

namespace raylab::test {

struct LightScene {
    std::vector<Sphere> spheres;
    std::vector<Quad> quads;
    std::vector<Triangle> triangles;
    std::vector<Material> materials{1};
    std::vector<Light> lights;
    std::vector<Vec3> map;
    std::vector<float> row_cdf, column_cdf;
    Environment environment;

    explicit LightScene(Vec3 emission = Vec3(1)) { materials[0].emission = emission; }

    void add(Vec3 center, float radius) {
        spheres.push_back({center, radius, {0, 0, 0}});
        lights.push_back({LightKind::sphere, int(spheres.size()) - 1, Vec3(0), Vec3(0)});
    }
    void add(Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
        quads.push_back(make_quad({a, b, c, d}, {0, 0, 0}));
        lights.push_back({LightKind::quad, int(quads.size()) - 1, Vec3(0), Vec3(0)});
    }
    void add(Vec3 a, Vec3 b, Vec3 c) {
        triangles.push_back({{a, b, c}, normalize(cross(b - a, c - a)), -1, {0, 0, 0}});
        lights.push_back({LightKind::triangle, int(triangles.size()) - 1, Vec3(0), Vec3(0)});
    }
    // A map, with its distribution in proportion to luminance * sin(theta).
    void add(int width, int height, const std::vector<Vec3>& texels) {
        environment.light = int(lights.size());
        environment.radiance = Vec3(1);
        environment.width = width, environment.height = height;
        map = texels;
        std::vector<double> rows{0};
        for (int r = 0; r < height; ++r) {
            std::vector<double> columns{0};
            for (int c = 0; c < width; ++c)
                columns.push_back(columns.back() + luminance(texels[r * width + c]));
            for (int c = 0; c <= width; ++c) // a black row: any distribution will do
                column_cdf.push_back(columns.back() > 0 ? float(columns[c] / columns.back())
                                                        : float(c) / width);
            rows.push_back(rows.back() + columns.back() * std::sin(M_PI * (r + 0.5) / height));
        }
        for (double r : rows) row_cdf.push_back(float(r / rows.back()));
        lights.push_back({LightKind::environment, -1, Vec3(0), Vec3(0)});
    }

    template <class T> static Array<T> array(const std::vector<T>& v) {
        return {v.data(), int(v.size())};
    }

    SceneView view() const {
        SceneView view{};
        view.spheres = array(spheres), view.quads = array(quads), view.triangles = array(triangles);
        view.materials = array(materials), view.lights = array(lights);
        view.environment = environment;
        view.environment.map = array(map);
        view.environment.row_cdf = array(row_cdf), view.environment.column_cdf = array(column_cdf);
        return view;
    }
};

} // namespace raylab::test
