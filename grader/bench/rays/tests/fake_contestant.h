// A contestant with the right answers of brute force, spoiled as a test wants, at a speed by
// arrangement: no clock is read.
#pragma once

#include "grader/bench/rays/race.h"

namespace raylab::bench {

struct Fake {
    double ns_a_ray = 100;
    bool is_exact = true;
    std::function<void(std::span<RayAnswer>)> spoil = {};
    std::vector<std::string>* log = nullptr; // its name, each time it traces
};

class FakeStructure : public RayStructure {
  public:
    FakeStructure(std::string name, Fake fake, std::span<const Triangle> triangles)
        : name_(std::move(name)), fake_(std::move(fake)),
          right_(brute_force().build(triangles, 1).structure) {}

    double closest(std::span<const Ray> rays, std::span<RayAnswer> answers) const override {
        right_->closest(rays, answers);
        if (fake_.spoil) fake_.spoil(answers);
        return seconds(rays);
    }
    double any(std::span<const Ray> rays, std::span<std::uint8_t> blocked) const override {
        right_->any(rays, blocked);
        return seconds(rays);
    }

  private:
    double seconds(std::span<const Ray> rays) const {
        if (fake_.log) fake_.log->push_back(name_);
        return 1e-9 * fake_.ns_a_ray * double(rays.size());
    }

    std::string name_;
    Fake fake_;
    std::unique_ptr<RayStructure> right_;
};

inline RayContestant fake(const std::string& name, const Fake& fake = {}) {
    return {name, "the <" + name + ">, fake", fake.is_exact,
            std::numeric_limits<double>::infinity(),
            [name, fake](std::span<const Triangle> triangles, int) {
                return BuiltStructure{std::make_unique<FakeStructure>(name, fake, triangles), 0.25,
                                      10.0 * double(triangles.size())};
            }};
}

inline RayContestant broken(const std::string& name) {
    return {name, name, true, std::numeric_limits<double>::infinity(),
            [](std::span<const Triangle>, int) -> BuiltStructure {
                throw ContestantError("no memory, and a \"quote\"");
            }};
}

// A small mesh of which every camera ray of a 16 x 16 film that goes through the middle meets some.
inline RayMesh small_mesh(const std::string& kind = "sphere_flake", int film = 16) {
    RayMesh mesh = procedural_ray_mesh(kind, 200, 1);
    set_film_size(mesh.camera, film, film);
    return mesh;
}

} // namespace raylab::bench
