#include "app/export_mitsuba.h"

#include "app/export_ply.h"
#include "app/mitsuba_materials.h"
#include "app/mitsuba_sky.h"
#include "app/mitsuba_xml.h"
#include "common/geometry/make_quad.h"
#include "common/image/formats.h"
#include "common/math/frame.h"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <numbers>
#include <set>

namespace raylab::app {

namespace {

using namespace mitsuba;

// The distance between the two faces of a light, as a part of its size: far above the resolution of
// float, and far too small to be seen in an image.
constexpr float gap_of_size = 1e-4f;
constexpr int plane_levels = 8; // the largest square of a plane is 4^8 times the scene

class MitsubaWriter {
  public:
    explicit MitsubaWriter(const Scene& scene)
        : scene_(scene), extent_(extent()), materials_(scene, files_) {}

    std::vector<ExportedFile> write() {
        if (scene_.render.integrator != Integrator::path)
            refuse("its integrators follow whole paths; use --integrator path");
        line("<!-- written by raylab export; the scene's hash is {} -->", scene_.hash);
        line("<scene version=\"3.0.0\">");
        write_integrator();
        write_camera();
        write_polygons(); // the shapes come first: they tell which materials are used
        write_spheres();
        write_planes();
        write_lights();
        std::string materials;
        for (const int material : used_) materials += materials_.bsdf(material);
        text_.insert(materials_at_, materials);
        line("</scene>");
        files_.push_back({"scene.xml", text_});
        return std::move(files_);
    }

  private:
    template <class... Args> void line(fmt::format_string<Args...> format, Args&&... args) {
        text_ += fmt::format(format, std::forward<Args>(args)...) + '\n';
    }

    // Half the side of a box around the camera that holds all shapes of finite size.
    float extent() const {
        const Vec3 center = scene_.camera.position;
        float reach = scene_.camera.focus_distance;
        const auto reach_to = [&](Vec3 p, float r) {
            reach = fmaxf(reach, max_component(abs(p - center)) + r);
        };
        for (const Sphere& sphere : scene_.spheres) reach_to(sphere.center, sphere.radius);
        for (const Quad& quad : scene_.quads)
            for (const Vec3& v : quad.v) reach_to(v, 0);
        for (const Triangle& triangle : scene_.triangles)
            for (const Vec3& v : triangle.v) reach_to(v, 0);
        for (const Plane& plane : scene_.planes)
            reach = fmaxf(reach, fabsf(dot(center - plane.point, plane.normal)));
        return reach > 0 ? reach : 1;
    }

    // Mitsuba counts depth as raylab does: depth 1 shows only what the camera sees glow. rr_depth
    // 4: roulette begins at the fourth surface.
    void write_integrator() {
        const int depth = scene_.render.max_depth;
        line("<integrator type=\"path\"><integer name=\"max_depth\" value=\"{}\"/>"
             "<integer name=\"rr_depth\" value=\"{}\"/></integrator>",
             depth, scene_.render.roulette ? 4 : depth + 1);
    }

    // Mitsuba's camera looks along z with y up and x to the left.
    void write_camera() {
        const Camera& camera = scene_.camera;
        const double vfov = 2 * glm::degrees(std::atan(double(camera.half_height)));
        line("<sensor type=\"{}\">", camera.lens_radius > 0 ? "thinlens" : "perspective");
        line("{}", to_world(-camera.right, camera.up, camera.forward, camera.position));
        line("<string name=\"fov_axis\" value=\"y\"/><float name=\"fov\" value=\"{}\"/>", vfov);
        line("<float name=\"near_clip\" value=\"{}\"/><float name=\"far_clip\" value=\"{}\"/>",
             1e-7f * extent_, 1e7f * extent_);
        if (camera.lens_radius > 0)
            line("<float name=\"aperture_radius\" value=\"{}\"/>"
                 "<float name=\"focus_distance\" value=\"{}\"/>",
                 camera.lens_radius, camera.focus_distance);
        line("<film type=\"hdrfilm\"><integer name=\"width\" value=\"{}\"/>"
             "<integer name=\"height\" value=\"{}\"/><rfilter type=\"box\"/>"
             "<string name=\"pixel_format\" value=\"rgb\"/>"
             "<string name=\"component_format\" value=\"float32\"/></film>",
             camera.width, camera.height);
        line(
            "<sampler type=\"independent\"><integer name=\"sample_count\" value=\"{}\"/></sampler>",
            scene_.render.spp);
        line("</sensor>");
        materials_at_ = text_.size();
    }

    // A shape of one material; `content`: the elements inside the shape's element.
    void write_shape(const char* type, int material, const std::string& content) {
        used_.insert(material);
        const Vec3 emission = scene_.materials[material].emission;
        line("<shape type=\"{}\">{}<ref id=\"{}\"/>{}</shape>", type, content, id(scene_, material),
             is_black(emission)
                 ? ""
                 : "<emitter type=\"area\">" + rgb("radiance", emission) + "</emitter>");
    }

    void write_mesh(const PlyMesh& mesh, int material) {
        const std::string file = fmt::format("mesh_{}.ply", meshes_++);
        files_.push_back({file, encode_ply(mesh)});
        // In Mitsuba an image begins with its top row, so v is turned over.
        write_shape("ply", material,
                    fmt::format("<string name=\"filename\" value=\"{}\"/>"
                                "<boolean name=\"face_normals\" value=\"{}\"/>"
                                "<boolean name=\"flip_tex_coords\" value=\"true\"/>",
                                file, mesh.normals.empty()));
    }

    // Quads and triangles: one mesh for each material, or two, since flat faces have no normals.
    void write_polygons() {
        std::map<int, PlyMesh> flat, smooth;
        if (!scene_.corner_colours.empty())
            refuse("a mesh has vertex colours, which the export does not write");
        for (const Quad& quad : scene_.quads) flat[quad.tags.material].add(quad);
        for (const Triangle& triangle : scene_.triangles) {
            const int material = triangle.tags.material;
            if (triangle.corners < 0)
                flat[material].add(triangle);
            else
                smooth[material].add(triangle, scene_.corners[triangle.corners]);
        }
        for (const auto& [material, mesh] : flat) {
            write_mesh(mesh, material);
            if (is_emissive(scene_.materials[material])) write_mesh(back_of_light(mesh), material);
        }
        for (const auto& [material, mesh] : smooth) {
            if (is_emissive(scene_.materials[material]))
                refuse(fmt::format("the material '{}' glows on a mesh with shading normals, and "
                                   "its lights shine to the side of those",
                                   scene_.material_names[material]));
            write_mesh(mesh, material);
        }
    }

    static PlyMesh back_of_light(const PlyMesh& mesh) {
        double area2 = 0;
        for (const auto& [i, j, k] : mesh.faces)
            area2 += length(cross(mesh.positions[j] - mesh.positions[i],
                                  mesh.positions[k] - mesh.positions[i]));
        return mesh.back(gap_of_size * float(std::sqrt(area2 / 2 / double(mesh.faces.size()))));
    }

    void write_spheres() {
        for (const Sphere& sphere : scene_.spheres) {
            const int material = sphere.tags.material;
            const auto write = [&](float radius, bool inwards) {
                write_shape("sphere", material,
                            point("center", sphere.center) +
                                fmt::format("<float name=\"radius\" value=\"{}\"/>"
                                            "<boolean name=\"flip_normals\" value=\"{}\"/>",
                                            radius, inwards));
            };
            write(sphere.radius, false);
            if (is_emissive(scene_.materials[material]))
                write(sphere.radius * (1 - gap_of_size), true);
        }
    }

    // Squares around the point below the camera, each 4 times as large as the one before: a single
    // one would misplace its points by 2^-24 of its own huge size.
    void write_planes() {
        for (const Plane& plane : scene_.planes) {
            const DVec3 n(plane.normal), point(plane.point);
            const DVec3 to_camera = DVec3(scene_.camera.position) - point;
            const DVec3 middle = point + to_camera - dot(to_camera, n) * n;
            const Frame frame = Frame::around(plane.normal);
            const DVec3 x(frame.x), y(frame.y);
            PlyMesh mesh;
            Quad inner{};
            for (int level = 0; level <= plane_levels; ++level) {
                const double half = std::ldexp(double(extent_), 2 * level);
                Quad square{};
                const DVec3 corners[4] = {-x - y, x - y, x + y, y - x};
                for (int i = 0; i < 4; ++i) square.v[i] = Vec3(middle + half * corners[i]);
                if (level == 0) mesh.add(square);
                for (int i = 0; i < 4 && level > 0; ++i) {
                    const int next = (i + 1) % 4;
                    mesh.add(
                        make_quad({square.v[i], square.v[next], inner.v[next], inner.v[i]}, {}));
                }
                inner = square;
            }
            write_mesh(mesh, plane.tags.material);
        }
    }

    void write_lights() {
        for (const Light& light : scene_.lights)
            if (light.kind == LightKind::point)
                line("<emitter type=\"point\">{}{}</emitter>", point("position", light.position),
                     rgb("intensity", light.intensity));
        if (scene_.environment_light < 0) return;
        if (scene_.environment_map.empty()) {
            line("<emitter type=\"constant\">{}</emitter>",
                 rgb("radiance", scene_.environment_radiance));
            return;
        }
        files_.push_back({"sky.exr", formats::encode_exr(fine_sky(scene_))});
        // Mitsuba's u is 0 at -z and grows towards x; ours is 0 at x, turned by -turn, and grows
        // towards z.
        const double turn = 2 * std::numbers::pi * double(scene_.environment_turn);
        const float c = float(std::cos(turn)), s = float(std::sin(turn));
        line("<emitter type=\"envmap\"><string name=\"filename\" value=\"sky.exr\"/>{}</emitter>",
             to_world(Vec3(s, 0, c), Vec3(0, 1, 0), Vec3(-c, 0, s), Vec3(0)));
    }

    const Scene& scene_;
    const float extent_;
    std::string text_;
    std::size_t materials_at_ = 0;
    std::vector<ExportedFile> files_;
    Materials materials_;
    std::set<int> used_;
    int meshes_ = 0;
};

} // namespace

std::vector<ExportedFile> mitsuba_files(const Scene& scene) { return MitsubaWriter(scene).write(); }

} // namespace raylab::app
