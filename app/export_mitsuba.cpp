#include "app/export_mitsuba.h"

#include "app/export_ply.h"
#include "app/labs.h"
#include "common/geometry/make_quad.h"
#include "common/image/formats.h"
#include "common/math/frame.h"

#include <fmt/format.h>

#include <map>
#include <set>

namespace raylab::app {

namespace {

// Both faces of a light are this part of its size apart: far above float's resolution, far below
// what shows in an image.
constexpr float gap_of_size = 1e-4f;
constexpr int plane_levels = 8; // the largest square of a plane is 4^8 times the scene
constexpr int sky_columns = 8, sky_rows = 32; // for each texel of ours

[[noreturn]] void refuse(const std::string& what) {
    throw UsageError("cannot be written for Mitsuba: " + what);
}

std::string escaped(const std::string& text) {
    std::string result;
    for (const char c : text) {
        if (c == '&')
            result += "&amp;";
        else if (c == '<')
            result += "&lt;";
        else if (c == '"')
            result += "&quot;";
        else
            result += c;
    }
    return result;
}

std::string rgb(const char* name, Vec3 c) {
    return fmt::format("<rgb name=\"{}\" value=\"{} {} {}\"/>", name, c.x, c.y, c.z);
}

std::string point(const char* name, Vec3 p) {
    return fmt::format("<point name=\"{}\" x=\"{}\" y=\"{}\" z=\"{}\"/>", name, p.x, p.y, p.z);
}

// The frame whose axes are x, y, z and whose origin is o, to the world.
std::string to_world(Vec3 x, Vec3 y, Vec3 z, Vec3 o) {
    return fmt::format("<transform name=\"to_world\"><matrix value=\"{} {} {} {} {} {} {} {} "
                       "{} {} {} {} 0 0 0 1\"/></transform>",
                       x.x, y.x, z.x, o.x, x.y, y.y, z.y, o.y, x.z, y.z, z.z, o.z);
}

class MitsubaWriter {
  public:
    explicit MitsubaWriter(const Scene& scene) : scene_(scene), extent_(extent()) {}

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
        for (const int material : used_) materials += bsdf(material);
        text_.insert(materials_at_, materials);
        line("</scene>");
        files_.push_back({"scene.xml", text_});
        return std::move(files_);
    }

  private:
    template <class... Args> void line(fmt::format_string<Args...> format, Args&&... args) {
        text_ += fmt::format(format, std::forward<Args>(args)...) + '\n';
    }

    // Half the side of a box around the camera that holds all that is finite.
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

    // Both count depth alike: 1 is what the camera sees glow. rr_depth 4: from the fourth surface.
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

    std::string id(int material) const {
        return fmt::format("{}_{}", material, escaped(scene_.material_names[material]));
    }

    // What replaces `name` in a BSDF: the material's reflectance or its texture, texels as they
    // are.
    std::string reflectance(const Material& material, const char* name) {
        if (material.texture < 0) return rgb(name, material.reflectance);
        const std::string file = fmt::format("texture_{}.pfm", material.texture);
        if (written_textures_.insert(material.texture).second) {
            const Texture& texture = scene_.textures[material.texture];
            Image image{texture.width, texture.height, {}, {}, {}};
            for (int row = texture.height - 1; row >= 0; --row) // ours have row 0 at the bottom
                for (int column = 0; column < texture.width; ++column)
                    image.mean.push_back(
                        scene_.texels[texture.first + row * texture.width + column]);
            files_.push_back({file, formats::encode_pfm(image)});
        }
        return fmt::format("<texture type=\"bitmap\" name=\"{}\"><string name=\"filename\" "
                           "value=\"{}\"/><boolean name=\"raw\" value=\"true\"/></texture>",
                           name, file);
    }

    std::string roughness(const Material& material) const {
        return fmt::format("<float name=\"alpha\" value=\"{}\"/><string name=\"distribution\" "
                           "value=\"{}\"/>",
                           material.alpha,
                           material.microfacets == Microfacets::ggx ? "ggx" : "beckmann");
    }

    std::string bsdf(int index) {
        const Material& m = scene_.materials[index];
        const std::string name = scene_.material_names[index];
        const auto opaque = [&](const char* type, const std::string& content) {
            return fmt::format(
                "<bsdf type=\"twosided\" id=\"{}\"><bsdf type=\"{}\">{}</bsdf></bsdf>\n", id(index),
                type, content);
        };
        const auto clear = [&](const char* type, const std::string& content) {
            return fmt::format("<bsdf type=\"{}\" id=\"{}\"><float name=\"int_ior\" value=\"{}\"/>"
                               "<float name=\"ext_ior\" value=\"1\"/>{}{}{}</bsdf>\n",
                               type, id(index), m.ior, content,
                               reflectance(m, "specular_reflectance"),
                               reflectance(m, "specular_transmittance"));
        };
        const bool has_fresnel = m.kind == MaterialKind::glass ||
                                 m.kind == MaterialKind::conductor ||
                                 m.kind == MaterialKind::rough_dielectric;
        if (has_fresnel && m.fresnel == FresnelModel::schlick)
            refuse(fmt::format("the material '{}' uses Schlick's approximation, and Mitsuba has "
                               "Fresnel's equations only",
                               name));
        switch (m.kind) {
        case MaterialKind::diffuse:
            return opaque("diffuse", reflectance(m, "reflectance"));
        case MaterialKind::mirror:
            return opaque("conductor", "<string name=\"material\" value=\"none\"/>" +
                                           reflectance(m, "specular_reflectance"));
        case MaterialKind::glass:
            return clear("dielectric", "");
        case MaterialKind::phong:
            refuse(
                fmt::format("the material '{}' is Phong's, which Mitsuba 3 does not have", name));
        case MaterialKind::conductor:
            return opaque(m.is_smooth() ? "conductor" : "roughconductor",
                          (m.is_smooth() ? "" : roughness(m)) + rgb("eta", m.eta) + rgb("k", m.k) +
                              reflectance(m, "specular_reflectance"));
        case MaterialKind::rough_dielectric:
            return m.is_smooth() || m.ior == 1 ? clear("dielectric", "")
                                               : clear("roughdielectric", roughness(m));
        }
        return {};
    }

    // A shape of one material; `content` tells the rest.
    void write_shape(const char* type, int material, const std::string& content) {
        used_.insert(material);
        const Vec3 emission = scene_.materials[material].emission;
        line("<shape type=\"{}\">{}<ref id=\"{}\"/>{}</shape>", type, content, id(material),
             is_black(emission)
                 ? ""
                 : "<emitter type=\"area\">" + rgb("radiance", emission) + "</emitter>");
    }

    void write_mesh(const PlyMesh& mesh, int material) {
        const std::string file = fmt::format("mesh_{}.ply", meshes_++);
        files_.push_back({file, encode_ply(mesh)});
        // Images begin with their top row there: v is turned over.
        write_shape("ply", material,
                    fmt::format("<string name=\"filename\" value=\"{}\"/>"
                                "<boolean name=\"face_normals\" value=\"{}\"/>"
                                "<boolean name=\"flip_tex_coords\" value=\"true\"/>",
                                file, mesh.normals.empty()));
    }

    // Quads and triangles: one mesh for each material, or two, since flat faces have no normals.
    void write_polygons() {
        std::map<int, PlyMesh> flat, smooth;
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
        files_.push_back({"sky.exr", formats::encode_exr(fine_sky())});
        // Mitsuba's u is 0 at -z and grows towards x; ours is 0 at x and grows towards z.
        line("<emitter type=\"envmap\"><string name=\"filename\" value=\"sky.exr\"/>{}</emitter>",
             to_world(Vec3(0, 0, 1), Vec3(0, 1, 0), Vec3(-1, 0, 0), Vec3(0)));
    }

    // The sky for a renderer that interpolates linearly between samples at (column + 1/2) / width
    // and row / (height - 1). Edges between our texels lie half way between two columns, and on
    // rows, which take the mean of both sides: so each ramp keeps the integral of the step.
    Image fine_sky() const {
        const int w = scene_.environment_width, h = scene_.environment_height;
        Image image{sky_columns * w, sky_rows * h + 1, {}, {}, {}};
        for (int y = 0; y < image.height; ++y) {
            const int below = std::min(y / sky_rows, h - 1);
            const int above = y % sky_rows == 0 ? std::max(y / sky_rows - 1, 0) : below;
            for (int x = 0; x < image.width; ++x)
                image.mean.push_back(scene_.environment_radiance * 0.5f *
                                     (scene_.environment_map[above * w + x / sky_columns] +
                                      scene_.environment_map[below * w + x / sky_columns]));
        }
        return image;
    }

    const Scene& scene_;
    const float extent_;
    std::string text_;
    std::size_t materials_at_ = 0;
    std::vector<ExportedFile> files_;
    std::set<int> used_, written_textures_;
    int meshes_ = 0;
};

} // namespace

std::vector<ExportedFile> mitsuba_files(const Scene& scene) { return MitsubaWriter(scene).write(); }

} // namespace raylab::app
