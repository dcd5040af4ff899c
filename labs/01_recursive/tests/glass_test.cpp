// Task 1.6: Fresnel's equations and Snell's law at angles where they are known.
#include "common/task/facts.h"
#include "labs/01_recursive/glass.h"

namespace raylab::lab01 {

namespace {

using namespace task;

TEST(Task1_6, ReflectionIsTotalBeyondTheCriticalAngle) {
    const double critical = std::asin(1 / 1.5);
    const float beyond = reflected_part(float(std::cos(critical + 0.0175)), 1 / 1.5f);
    if (!expect_near("reflectance from inside, 1 degree beyond the critical angle", beyond, 1, 0,
                     std::isnan(beyond)
                         ? "where sin(theta_t) > 1 nothing is refracted, and 1 - sin^2 has no root"
                         : "eta is upside down: sin(theta_t) = sin(theta_i) / eta; where that is "
                           "more than 1, nothing is refracted"))
        return;
    const float below = reflected_part(float(std::cos(critical - 0.0175)), 1 / 1.5f);
    expect(below < 1, "reflectance 1 degree within the critical angle should be 0.44 but is 1; the "
                      "likely cause: eta is upside down");
}

TEST(Task1_6, ReflectanceAtAnglesThatAreKnown) {
    const double n = 1.5;
    expect_near("reflectance of glass seen straight on", reflected_part(1, 1.5f),
                std::pow((n - 1) / (n + 1), 2), 1e-6, "((n - 1) / (n + 1))^2 = 0.04");
    expect_near("the same from inside", reflected_part(1, 1 / 1.5f), 0.04, 1e-6,
                "eta is the far side's index over the near side's: 1/1.5 from inside");
    // Brewster's angle, tan = n: nothing polarised in the plane of incidence is reflected.
    const double brewster = std::cos(std::atan(n));
    const double schlick = 0.04 + 0.96 * std::pow(1 - brewster, 5);
    const float reflected = reflected_part(float(brewster), 1.5f);
    expect_near("reflectance at Brewster's angle", reflected,
                0.5 * std::pow((n * n - 1) / (n * n + 1), 2), 1e-5,
                std::fabs(reflected - schlick) < 1e-5
                    ? "this is Schlick's approximation; Fresnel's equations are asked for"
                    : "one of the two polarisations vanishes here; their mean remains");
    expect_near("reflectance at grazing incidence", reflected_part(0, 1.5f), 1, 1e-6,
                "at cos = 0 everything is reflected");
    expect_near("reflectance of a surface between equal media", reflected_part(0.3f, 1), 0, 1e-6,
                "without a difference of indices nothing is reflected");
}

// Light that goes the same way backwards is reflected as much.
TEST(Task1_6, BothWaysThroughReflectAlike) {
    for (const double theta : {0.2, 0.7, 1.2, 1.5}) {
        const double inside = std::asin(std::sin(theta) / 1.5);
        const float out = reflected_part(float(std::cos(theta)), 1.5f);
        if (!expect_near(fmt::format("reflectance from inside, at the angle to which {:g} degrees "
                                     "are refracted",
                                     theta * 180 / M_PI),
                         reflected_part(float(std::cos(inside)), 1 / 1.5f), out, 2e-4,
                         "Fresnel's equations are the same from both sides"))
            return;
    }
}

TEST(Task1_6, RefractionFollowsSnell) {
    for (const float eta : {1.5f, 1 / 1.5f, 2.4f})
        for (const float side : {1.0f, -1.0f}) {
            const Vec3 wo(0.36f, -0.48f, side * 0.8f);
            const Vec3 wi = refracted_direction(wo, eta);
            const std::string what = fmt::format("refracted direction for eta {:.3g}", eta);
            if (!expect_near("length of the " + what, length(wi), 1, 1e-5,
                             "the part across makes up the unit length") ||
                !expect(wi.z * side < 0,
                        "the " + what +
                            " should be on the other side of the surface but is on wo's; the "
                            "likely cause: the sign of the part across, which is that of -wo.z") ||
                !expect_vector(what + ", along the surface", Vec3(wi.x, wi.y, 0),
                               Vec3(-0.36f / eta, 0.48f / eta, 0), 1e-6,
                               side > 0 ? "sin(theta_t) = sin(theta_i) / eta, to the other side "
                                          "of the normal"
                                        : "right from outside, wrong from inside: eta is the far "
                                          "side's index over the near side's, inverted already"))
                return;
        }
    expect_vector("refracted direction straight on", refracted_direction(Vec3(0, 0, 1), 1.5f),
                  Vec3(0, 0, -1), 1e-6, "straight on nothing is bent");
}

// However the lobe is chosen: on average F of the light is reflected and 1 - F refracted.
TEST(Task1_6, GlassSplitsLightByItsReflectance) {
    Material glass;
    glass.kind = MaterialKind::glass;
    glass.ior = 1.5f;
    constexpr int n = 4096;
    for (const Vec3 wo : {Vec3(0, 0, 1), Vec3(0.96f, 0, 0.28f), Vec3(0.6f, 0, -0.8f)}) {
        const float eta = wo.z > 0 ? 1.5f : 1 / 1.5f;
        const double F = reflected_part(std::fabs(wo.z), eta);
        double reflected = 0, refracted = 0;
        for (int i = 0; i < n; ++i) {
            const BsdfSample sample = scatter_glass(glass, Vec3(1), wo, (i + 0.5f) / n);
            if (!sample.valid) continue;
            if (!expect(sample.specular,
                        "a sample of smooth glass should be marked specular but is not; the likely "
                        "cause: no light sample can find its direction"))
                return;
            const bool back = sample.wi.z * wo.z > 0;
            (back ? reflected : refracted) += sample.weight.x / n;
            if (!expect_vector(back ? "reflected direction" : "refracted direction", sample.wi,
                               back ? Vec3(-wo.x, -wo.y, wo.z) : refracted_direction(wo, eta), 1e-5,
                               "the direction belongs to the lobe that was chosen"))
                return;
        }
        const std::string cause = "choose reflection with probability p: it weighs tint F / p, "
                                  "refraction tint (1 - F) / (1 - p)";
        if (!expect_near("light reflected by clear glass", reflected, F, 1e-3, cause) ||
            !expect_near("light refracted by clear glass", refracted, 1 - F, 1e-3, cause))
            return;
        for (const float u_lobe : {0.01f, 0.99f}) {
            const Vec3 clear = scatter_glass(glass, Vec3(1), wo, u_lobe).weight;
            const Vec3 tinted = scatter_glass(glass, Vec3(0.5f, 1, 0.25f), wo, u_lobe).weight;
            if (!expect_vector("weight of glass of tint (0.5, 1, 0.25), over that of clear glass",
                               tinted / clear, Vec3(0.5f, 1, 0.25f), 1e-5,
                               "the tint counts once a surface, in each channel"))
                return;
        }
    }
}

} // namespace

} // namespace raylab::lab01
