// One function a result; names are spelt out, since programs of others read them.
#include "grader/judge/json.h"

#include <nlohmann/json.hpp>

namespace raylab {
namespace {

using nlohmann::json;

json to_array(const DVec3& v) { return {v.x, v.y, v.z}; }

json to_value(const std::optional<double>& v) { return v ? json(*v) : json(nullptr); }

json to_object(const TestResult& test) {
    return {{"statistic", test.statistic}, {"degrees_of_freedom", test.dof}, {"p", test.p}};
}

json to_object(const RegionTest& test) {
    json object = to_object(test.test);
    object["region"] = test.region;
    object["of"] = test.chroma ? "chroma" : "luminance";
    object["image_rgb"] = to_array(test.image);
    object["reference_rgb"] = to_array(test.reference);
    object["standard_error"] = test.standard_error;
    object["reference_share_of_variance"] = test.reference_share;
    return object;
}

json to_object(const ZMap& map) {
    return {{"columns", map.columns}, {"rows", map.rows}, {"tile", map.tile}, {"z", map.z}};
}

} // namespace

void to_json(json& j, const Verdict& v) {
    j = {{"passed", v.passed}, {"sentence", v.sentence}, {"hints", v.hints}};
}

void to_json(json& j, const Region& r) { j = {r.x0, r.y0, r.x1, r.y1}; }

void to_json(json& j, const Soundness& s) {
    j = {{"sound", s.verdict.passed},
         {"unwritten_pixels", s.unwritten},
         {"not_finite_pixels", s.not_finite},
         {"negative_pixels", s.negative},
         {"first_pixel", s.first_x < 0 ? json(nullptr) : json{s.first_x, s.first_y}}};
}

void to_json(json& j, const Metrics& m) {
    j = {{"mse", m.mse},
         {"relative_mse", m.rel_mse},
         {"relative_error_of_mean", m.rel_error},
         {"relative_bias", m.rel_bias}};
}

void to_json(json& j, const SamePathsResult& r) {
    j = {{"judge", "same_paths"},
         {"verdict", r.verdict},
         {"soundness", r.soundness},
         {"differing_pixels", r.differing_pixels},
         {"allowed_pixels", r.allowed_pixels},
         {"largest_relative_difference", r.largest_relative_difference},
         {"first_difference", nullptr}};
    if (r.first_x >= 0)
        j["first_difference"] = {{"pixel", {r.first_x, r.first_y}},
                                 {"value", to_array(DVec3(r.first_value))},
                                 {"reference", to_array(DVec3(r.first_reference))}};
}

void to_json(json& j, const ExactResult& r) {
    j = {{"judge", "exact"},
         {"verdict", r.verdict},
         {"wrong_pixels", r.wrong},
         {"edge_pixels", r.edge},
         {"edge_pixels_allowed", r.edge_allowed},
         {"first_pixel", r.first_x < 0 ? json(nullptr) : json{r.first_x, r.first_y}}};
}

void to_json(json& j, const IndependentResult& r) {
    const Measures measured = r.verdict.measured.value_or(Measures{});
    j = {{"judge", "independent"},
         {"verdict", r.verdict},
         {"soundness", r.soundness},
         {"false_alarm_rate", r.false_alarm_rate},
         {"detectable_relative_error", r.detectable_relative_error},
         {"tests", r.screening.tests.size()},
         {"tests_planned", r.screening.planned},
         {"regions_merged", r.screening.merged},
         {"first_stage", to_object(r.screening.worst)},
         {"second_stage", r.second ? to_object(*r.second) : json(nullptr)},
         {"whole_image", to_object(r.screening.whole)},
         {"honesty",
          {{"seed_ignored", r.honesty.seed_ignored},
           {"replicate_correlation", r.honesty.replicate_correlation},
           {"variance_over_reference", to_value(r.honesty.variance_ratio)},
           {"tile_variance_over_independent", r.honesty.tile_ratio},
           {"variance_fall_at_twice_the_samples", to_value(r.honesty.variance_fall)}}},
         {"metrics", measured.metrics},
         {"z_map", to_object(measured.z_map)}};
}

void to_json(json& j, const Comparison& c) {
    j = {{"judge", "compare"},
         {"verdict", c.verdict},
         {"decided", c.decided},
         {"equal", c.equal},
         {"replicates", {c.replicates_a, c.replicates_b}},
         {"tile_variance_over_independent", {c.shared_noise_a, c.shared_noise_b}},
         {"false_alarm_rate", c.false_alarm_rate},
         {"tests", c.tests},
         {"worst", to_object(c.worst)},
         {"metrics", c.metrics()},
         {"z_map", to_object(c.verdict.measured.value_or(Measures{}).z_map)}};
    j["worst"]["region"] = c.worst_region;
    j["worst"]["channel"] = c.worst_channel;
    j["worst"]["relative_difference"] = c.worst_relative;
    if (c.metrics_b) j["metrics_b"] = *c.metrics_b;
}

} // namespace raylab
