// Loads a scene: its files, its sections in order, and what depends on the whole scene.
#include "common/load/scene_builder.h"

#include "common/load/keys.h"
#include "common/load/load.h"
#include "common/load/read_file.h"
#include "common/material/bsdf.h"
#include "common/math/features.h"
#include "common/scene/quad_groups.h"
#include "common/scene/shape_boxes.h"
#include "common/scene/sphere_groups.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab {

void FileHash::add(std::string_view bytes) {
    const auto mix = [this](std::uint64_t byte) { state_ = (state_ ^ byte) * 0x100000001B3; };
    for (int shift = 0; shift < 64; shift += 8) mix((std::uint64_t(bytes.size()) >> shift) & 255);
    for (const char c : bytes) mix(static_cast<unsigned char>(c));
}

std::string FileHash::hex() const { return fmt::format("{:016x}", state_); }

SceneBuilder::SceneBuilder(const JsonDocument& document, const std::filesystem::path& where)
    : document_(document), folder_(where.parent_path()) {
    scene_.name = where.stem().string();
    hash_.add(document.text);
}

Scene SceneBuilder::build() {
    const Node root(document_);
    // The version is read first, since another version may have other keys.
    const Node version = root.at("version");
    if (version.integer() != 1)
        version.fail_expected("1", "; this raylab reads scene files of version 1 only");
    root.expect_keys(scene_keys().at("scene"), "a scene");

    scene_.title = root.has("title") ? root.at("title").string() : scene_.name;
    if (const auto reason = root.find("reason")) scene_.reason = reason->string();
    const Node film = root.at("film");
    read_camera(root.at("camera"), film);
    read_render(root, film);
    if (const auto materials = root.find("materials")) read_materials(*materials);
    if (const auto shapes = root.find("shapes")) read_shapes(*shapes);
    sort_into_groups(scene_.spheres);
    sort_into_groups(scene_.quads);
    scene_.sphere_groups = group_spheres(scene_.spheres);
    scene_.quad_groups = group_quads(scene_.quads);
    make_area_lights();
    scene_.lights.insert(scene_.lights.end(), mesh_lights_.begin(), mesh_lights_.end());
    if (const auto lights = root.find("lights")) read_lights(*lights);
    if (const auto expect = root.find("expect")) read_expect(*expect);
    number_opaque_first();

    if (next_id_ == 0)
        scene_.warnings.push_back("the scene has no shapes: it shows only its environment");
    if (scene_.lights.empty())
        scene_.warnings.push_back(
            "no light and nothing emits: the image will be black; add a light, "
            "or an emission to a material");
    scene_.hash = hash_.hex();
    return std::move(scene_);
}

void SceneBuilder::read_camera(const Node& camera, const Node& film) {
    camera.expect_keys(scene_keys().at("camera"), "a camera");
    film.expect_keys(scene_keys().at("film"), "a film");
    const Node look_at = camera.at("look_at"), up_node = camera.at("up");
    const DVec3 position = camera.at("position").vec3();
    const DVec3 view = look_at.vec3() - position;
    const double distance = std::sqrt(dot(view, view));
    if (Vec3(look_at.vec3()) == Vec3(position))
        look_at.fail(
            "expected a point other than the camera's position, found the same; move one of "
            "them, the camera looks from position to look_at");
    const DVec3 forward = view / distance;
    const DVec3 side = cross(forward, up_node.direction()); // its length: sine of the angle between
    if (dot(side, side) < 1e-12)
        up_node.fail("expected a direction across the view, found one along it; choose another up, "
                     "such as [0, 0, 1] for a camera that looks straight down");
    const DVec3 right = side / std::sqrt(dot(side, side));

    const Node vfov = camera.at("vfov_deg");
    const double degrees = vfov.number();
    if (!(degrees > 0 && degrees < 180)) vfov.fail_expected("an angle between 0 and 180 degrees");
    Camera& c = scene_.camera;
    c.position = position;
    c.right = right;
    c.up = cross(right, forward);
    c.forward = forward;
    c.half_height = float(std::tan(glm::radians(degrees) / 2));
    const auto lens_radius = camera.find("lens_radius"), focus = camera.find("focus_distance");
    c.lens_radius = lens_radius ? float(lens_radius->not_negative()) : 0;
    c.focus_distance = float(focus ? focus->positive() : distance);
    set_film_size(c, film.at("width").integer(), film.at("height").integer());
}

void SceneBuilder::read_render(const Node& root, const Node& film) {
    RenderSettings& s = scene_.render;
    if (const auto render = root.find("render")) {
        render->expect_keys(scene_keys().at("render"), "a render block");
        if (const auto n = render->find("integrator"))
            s.integrator = n->one_of<Integrator>(
                {{"path", Integrator::path}, {"whitted", Integrator::whitted}});
        if (const auto n = render->find("max_depth")) s.max_depth = n->integer();
        if (const auto n = render->find("spp")) s.spp = n->integer();
        if (const auto n = render->find("seed")) s.seed = n->seed();
        if (const auto n = render->find("sampler"))
            s.sampler = n->one_of<SamplerKind>(
                {{"sobol", SamplerKind::sobol}, {"independent", SamplerKind::independent}});
        if (const auto n = render->find("direct_light"))
            s.direct_light = n->one_of<DirectLight>({{"mis", DirectLight::mis},
                                                     {"light", DirectLight::light},
                                                     {"bsdf", DirectLight::bsdf}});
        if (const auto n = render->find("roulette")) s.roulette = n->boolean();
        if (const auto n = render->find("jitter")) s.jitter = n->boolean();
    }
    if (const auto problem = problem_with(s, scene_.camera.width, scene_.camera.height)) {
        const bool of_film = problem->key == "width" || problem->key == "height";
        (of_film ? film : root.at("render")).at(problem->key).fail(problem->what);
    }
}

void SceneBuilder::read_expect(const Node& expect) {
    for (const Node& node : expect.elements()) {
        node.expect_keys(scene_keys().at("expect"), "an expectation");
        Expectation e;
        e.formula = node.at("formula").string();
        const Node value = node.at("value");
        e.value = value.is_array() ? value.rgb() : Vec3(float(value.not_negative()));
        e.tolerance = node.at("tolerance").not_negative();
        e.spp = scene_.render.spp;
        if (const auto spp = node.find("spp")) {
            RenderSettings settings = scene_.render;
            e.spp = settings.spp = spp->integer();
            if (const auto problem = problem_with(settings, 1, 1)) spp->fail(problem->what);
        }
        if (const auto region = node.find("region")) {
            const std::vector<Node> corner = region->elements();
            if (corner.size() != 4) region->fail_expected("an array of 4 integers: x0, y0, x1, y1");
            for (int i = 0; i < 4; ++i) e.region[i] = corner[i].integer();
            const auto [x0, y0, x1, y1] = e.region;
            if (!(0 <= x0 && x0 < x1 && x1 <= scene_.camera.width && 0 <= y0 && y0 < y1 &&
                  y1 <= scene_.camera.height))
                region->fail(
                    fmt::format("expected 0 <= x0 < x1 <= {} and 0 <= y0 < y1 <= {}, found "
                                "[{}, {}, {}, {}]",
                                scene_.camera.width, scene_.camera.height, x0, y0, x1, y1));
        }
        scene_.expect.push_back(std::move(e));
    }
}

// Every shape that glows, in the order of ids.
void SceneBuilder::make_area_lights() {
    struct Emitter {
        ShapeTags* tags;
        LightKind kind;
        int index;
    };
    std::vector<Emitter> emitters;
    const auto collect = [&](auto& shapes, LightKind kind) {
        for (std::size_t i = 0; i < shapes.size(); ++i)
            if (is_emissive(scene_.materials[shapes[i].tags.material]))
                emitters.push_back({&shapes[i].tags, kind, int(i)});
    };
    collect(scene_.spheres, LightKind::sphere);
    collect(scene_.quads, LightKind::quad);
    collect(scene_.triangles, LightKind::triangle);
    std::sort(emitters.begin(), emitters.end(),
              [](const Emitter& a, const Emitter& b) { return a.tags->id < b.tags->id; });
    for (const Emitter& e : emitters) {
        e.tags->light = int(scene_.lights.size());
        scene_.lights.push_back({e.kind, e.index, Vec3(0), Vec3(0)});
    }
}

// Where surfaces lie in one place, a ray meets the one with the lowest id. So opaque surfaces get
// the lower ids. Otherwise light would pass through a floor where glass stands on it, if the file
// lists the glass first.
void SceneBuilder::number_opaque_first() {
    const auto each_shape = [&](const auto& visit) {
        for (Sphere& shape : scene_.spheres) visit(shape.tags);
        for (Quad& shape : scene_.quads) visit(shape.tags);
        for (Plane& shape : scene_.planes) visit(shape.tags);
        for (Triangle& shape : scene_.triangles) visit(shape.tags);
    };
    std::vector<bool> is_clear_id(std::size_t(next_id_), false);
    each_shape([&](const ShapeTags& tags) {
        is_clear_id[tags.id] = is_clear(scene_.materials[tags.material]);
    });
    std::vector<int> number(is_clear_id.size());
    int next = 0;
    for (const bool clear : {false, true})
        for (std::size_t id = 0; id < number.size(); ++id)
            if (is_clear_id[id] == clear) number[id] = next++;
    each_shape([&](ShapeTags& tags) { tags.id = number[tags.id]; });
}

std::string SceneBuilder::read_named_file(const Node& file) {
    const std::string name = file.string();
    if (name.empty()) file.fail_expected("the name of a file");
    std::string bytes;
    if (const std::string problem = read_file(folder_ / name, bytes); !problem.empty())
        file.fail(problem + "; names are relative to the scene file");
    hash_.add(bytes);
    return bytes;
}

Scene parse_scene(std::string_view text, const std::filesystem::path& where) {
    const JsonDocument document = parse_json(text, where.string());
    return SceneBuilder(document, where).build();
}

Scene load_scene(const std::filesystem::path& file) {
    return parse_scene(read_file_or_throw(file), file);
}

} // namespace raylab
