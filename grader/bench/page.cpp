#include "grader/bench/page.h"

#include "grader/bench/html_cells.h"
#include "grader/bench/page_parts.h"
#include "grader/bench/rare_case.h"
#include "grader/bench/text.h"
#include "grader/report/html.h"
#include "grader/report/page_parts.h"

#include <fmt/format.h>

#include <cmath>

namespace raylab::bench {

namespace {

using namespace html;
using nlohmann::ordered_json;

std::string bias(const ordered_json& b) {
    if (b.at("relative").is_null()) return unknown;
    return fmt::format("{:+.2f}&#8239;%<span class=\"interval\">&plusmn; {:.2f}&#8239;%</span>",
                       100 * b.at("relative").get<double>(),
                       100 * b.at("half_width_95").get<double>());
}

std::string millions(double v) { return v > 0 ? fmt::format("{:.2f}&#8239;M", v * 1e-6) : unknown; }

std::string row_html(const ordered_json& row, std::size_t colour) {
    const std::string name = fmt::format(
        "<td><span class=\"key c{}\"></span><strong>{}</strong>{}<span "
        "class=\"interval\">{}</span></td>",
        colour, text(row.at("name")), row.value("baseline", false) ? " <em>baseline</em>" : "",
        text(row.at("title")));
    if (row.contains("failure"))
        return fmt::format("<tr>{}<td colspan=\"8\" class=\"hint\">{}</td></tr>\n", name,
                           text(row.at("failure")));
    std::string html =
        "<tr>" + name + cell(html::measured(row.at("ms_per_spp"))) +
        cell(html::measured(row.at("start_up_seconds"))) + cell(html::measured(row.at("rel_mse"))) +
        cell(html::measured(row.at("efficiency"))) +
        cell(html::measured(row.at("efficiency_ratio"), "&times;&#8239;")) +
        cell(html::measured(row.at("seconds_to_target"))) + cell(bias(row.at("bias"))) +
        cell(millions(row.at("rays_per_second"))) +
        cell(row.at("bytes_per_path") > 0 ? digits(row.at("bytes_per_path")) : unknown) + "</tr>\n";
    html +=
        fmt::format("<tr class=\"verdict\"><td colspan=\"10\" class=\"{}\">{}</td></tr>\n",
                    row.at("agrees").get<bool>() ? "agrees" : "differs", text(row.at("verdict")));
    for (const ordered_json& remark : row.at("remarks"))
        html += fmt::format(
            "<tr class=\"verdict\"><td colspan=\"10\" class=\"hint\">{}</td></tr>\n", text(remark));
    return html;
}

std::string plot(const char* kind, std::size_t scene, const std::string& caption) {
    return fmt::format("<figure class=\"plot\" data-plot=\"{}\" data-scene=\"{}\">"
                       "<figcaption>{}</figcaption></figure>\n",
                       kind, scene, caption);
}

std::string scene_html(const ordered_json& scene, std::size_t index, const ordered_json& bench) {
    std::string rows;
    bool has_bounces = false;
    for (std::size_t i = 0; i < scene.at("rows").size(); ++i) {
        const ordered_json& row = scene.at("rows")[i];
        rows += row_html(row, i % 8);
        has_bounces = has_bounces || !row.value("bounces", json::array()).empty();
    }
    const std::string target = fmt::format("{:g}", bench.at("target_rel_mse").get<double>());
    std::string html = fmt::format("<section><h2>{}</h2>\n<p class=\"reason\">{} &times; {}, at "
                                   "most {} surfaces a path. {}</p>\n"
                                   "<div class=\"plots\">\n",
                                   text(scene.at("title")), scene.at("width").get<int>(),
                                   scene.at("height").get<int>(), scene.at("max_depth").get<int>(),
                                   text(scene.at("truth")));
    html +=
        plot("error", index,
             "Error against time, start-up taken out. Left and low is good. Dashed: error falls as "
             "1/N. Rings: where the line meets relMSE " +
                 target + ".");
    html += plot("efficiency", index,
                 "Efficiency, 1 / (MSE &times; seconds), with its interval. Longer is better.");
    if (has_bounces)
        html += plot(
            "bounces", index,
            "Line: paths still alive at each bounce, of those that began. Bars: the share of a "
            "GPU's lanes that work for them; what is missing are the wasted cycles.");
    return html + "</div>\n<div class=\"wide\"><table class=\"bench\">" +
           head({{"Contestant", ""},
                 {"ms / sample", "slope of time over samples a pixel"},
                 {"Start-up, s", "time at 0 samples"},
                 {"relMSE", "at the most samples, the reference's own noise taken off"},
                 {"Efficiency", "1 / (MSE seconds), start-up taken out"},
                 {"Ratio", "efficiency over the baseline's, round by round"},
                 {"s to target", "seconds to the target error, from relMSE = C / n"},
                 {"Bias", "of the mean luminance, 95 % interval"},
                 {"Rays / s", "camera, scattered and shadow rays"},
                 {"Bytes / path", "memory the renderer holds, its copy of the scene included"}}) +
           "<tbody>" + rows + "</tbody></table></div></section>\n";
}

std::string against_html(const ordered_json& against) {
    std::string rows;
    for (const ordered_json& c : against.at("changes"))
        rows += fmt::format(
            "<tr><td>{}</td><td>{}</td><td>{}</td>{}<td class=\"{}\">{}</td><td>{}</td></tr>\n",
            text(c.at("scene")), text(c.at("contestant")), text(c.at("quantity")),
            cell(fmt::format("{:.3f}<span class=\"interval\">{:.3f} &ndash; {:.3f}</span>",
                             c.at("ratio").get<double>(), c.at("low").get<double>(),
                             c.at("high").get<double>())),
            text(c.at("verdict")), text(c.at("verdict")), text(c.at("formed")));
    std::string notes;
    for (const ordered_json& note : against.at("notes"))
        notes += "<p class=\"hint\">" + text(note) + "</p>\n";
    return fmt::format(
        "<section><h2>Against commit {}</h2>\n<p class=\"reason\">This run over that of "
        "<code>{}</code>; "
        "above 1 is better. Noise: the interval holds 1.</p>\n<table><thead><tr><th>Scene</th>"
        "<th>Contestant</th><th>Quantity</th><th class=\"number\">Ratio</th><th>Verdict</th>"
        "<th>Formed from</th></tr></thead><tbody>{}</tbody></table>\n{}</section>\n",
        text(against.at("commit")), text(against.at("file")), rows, notes);
}

} // namespace

std::string page_html(const ordered_json& bench, const std::string& machine) {
    std::string notes, sections;
    for (const ordered_json& note : bench.at("notes"))
        notes += "<p class=\"hint\">" + text(note) + "</p>\n";
    for (std::size_t i = 0; i < bench.at("scenes").size(); ++i)
        sections += scene_html(bench.at("scenes")[i], i, bench);
    const std::string body = fmt::format(
        "<header><h1>Speed against error</h1>\n<p class=\"summary\">{} rounds, {} threads, up to "
        "{} "
        "samples a pixel; ratios to <strong>{}</strong> in the same round</p>\n"
        "<p class=\"machine\">{}</p>\n<p class=\"machine\"><code>{}</code></p>\n{}</header>\n{}{}{}"
        "<section><h2>How this was measured</h2>\n<p class=\"reason\">Contestants take turns, "
        "every run "
        "with a seed of its own. Figures are medians over the rounds; an interval holds the true "
        "median "
        "with {:.1f}&#8239;% probability, whatever disturbed the clock. Start-up and time a sample "
        "come "
        "apart by the line through the times at {} samples a pixel. A contestant whose image does "
        "not "
        "agree with the truth gets no ratio.</p></section>\n",
        bench.at("rounds").get<int>(), bench.at("threads").get<int>(),
        bench.at("spp").back().get<int>(), text(bench.at("baseline")), escape_html(machine),
        text(bench.at("command")), notes, sections,
        bench.contains("against") ? against_html(bench.at("against")) : "",
        bench.contains("rare_cases") ? rare_cases_html(bench.at("rare_cases")) : "",
        100 * bench.at("interval_coverage").get<double>(),
        joined(bench.at("spp").get<std::vector<int>>(), " and "));
    return html_page({"raylab bench", std::string(raylab::page_css) + page_css, body,
                      bench.dump(-1, ' ', false, json::error_handler_t::replace),
                      std::string(plot_parts_js) + page_js});
}

} // namespace raylab::bench
