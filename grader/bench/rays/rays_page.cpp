// rays.html: one self-contained page, made from what rays.json holds. Figures are in its tables;
// the script draws the plots.
#include "grader/bench/html_cells.h"
#include "grader/bench/page_parts.h"
#include "grader/bench/rays/rays_bench.h"
#include "grader/report/html.h"
#include "grader/report/page_parts.h"

#include <fmt/format.h>

namespace raylab::bench {

extern const char* const rays_page_js; // rays_page_js.cpp.in

namespace {

using namespace html;
using nlohmann::ordered_json;

std::string key(const ordered_json& name, const ordered_json& bench) {
    return fmt::format("<span class=\"key c{}\"></span>",
                       bench.at("styles").at(name.get<std::string>()).at("colour").get<int>());
}

std::string name_cell(const ordered_json& row, const ordered_json& bench) {
    return fmt::format("<td>{}<strong>{}</strong>{}<span class=\"interval\">{}</span></td>",
                       key(row.at("name"), bench), text(row.at("name")),
                       row.at("name") == bench.at("baseline") ? " <em>baseline</em>" : "",
                       text(row.at("title")));
}

std::string optional(const ordered_json& value) {
    return value.is_null() ? unknown : digits(value.get<double>());
}

std::string builds_html(const ordered_json& race, const ordered_json& bench) {
    std::string rows;
    for (const ordered_json& row : race.at("rows")) {
        rows += "<tr>" + name_cell(row, bench);
        rows += row.contains("failure")
                    ? "<td colspan=\"3\" class=\"hint\">" + text(row.at("failure")) + "</td>"
                    : cell(html::measured(row.at("build_seconds"))) +
                          cell(optional(row.at("mtris_per_second"))) +
                          cell(optional(row.at("bytes_per_triangle")));
        rows += "</tr>\n";
    }
    return "<table>" +
           head({{"Structure", ""},
                 {"Build, s", "from triangles in memory to a structure that can be asked"},
                 {"Mtris / s", "million triangles built in a second"},
                 {"Bytes / triangle", "held besides the triangles given"}}) +
           "<tbody>" + rows + "</tbody></table>\n";
}

std::string cells_html(const ordered_json& race, const ordered_json& bench) {
    std::string rows;
    for (const ordered_json& row : race.at("rows")) {
        if (row.contains("failure")) continue;
        for (const ordered_json& c : row.at("cells"))
            rows += fmt::format(
                "<tr><td>{}{}</td><td>{}</td>{}{}{}{}{}{}</tr>\n", key(row.at("name"), bench),
                text(row.at("name")), text(c.at("rays")),
                cell(html::measured(c.at("mrays_per_second"))),
                cell(c.at("agrees").get<bool>() ? html::measured(c.at("ratio"), "&times;&#8239;")
                                                : "answers differ: no ratio"),
                cell(optional(c.at("nodes_per_ray"))), cell(optional(c.at("triangles_per_ray"))),
                cell(fmt::format("{} of {}", c.at("differing").get<int>(),
                                 c.at("count").get<int>())),
                cell(fmt::format("{} of {}", c.at("wrong").get<int>(),
                                 c.at("verified").get<int>())));
    }
    return "<div class=\"wide\"><table><thead><tr><th>Structure</th><th>Rays</th>"
           "<th class=\"number\">Mrays / s</th><th class=\"number\">Ratio</th>"
           "<th class=\"number\">Nodes / ray</th><th class=\"number\">Triangles / ray</th>"
           "<th class=\"number\">Differing answers</th>"
           "<th class=\"number\">Wrong, of those verified</th></tr></thead><tbody>" +
           rows + "</tbody></table></div>\n";
}

std::string plot(const std::string& kind, std::size_t race, const std::string& caption) {
    return fmt::format("<figure class=\"plot\" data-plot=\"{}\" data-race=\"{}\">"
                       "<figcaption>{}</figcaption></figure>\n",
                       kind, race, caption);
}

std::string race_html(const ordered_json& race, std::size_t index, const ordered_json& bench) {
    const std::string left_out = text(race.at("left_out"));
    return fmt::format("<section><h2>{}</h2>\n<p class=\"reason\">{} triangles{}; answers are "
                       "compared with "
                       "those of <strong>{}</strong>.</p>\n",
                       text(race.at("mesh")), race.at("triangles").get<int>(),
                       left_out.empty() ? "" : ", without " + left_out, text(race.at("truth"))) +
           plot("rays", index,
                "Million rays a second with its interval, by kind of ray; above a bar the ratio to "
                "the baseline. Higher is better.") +
           builds_html(race, bench) + cells_html(race, bench) + "</section>\n";
}

std::string scaling_html(const ordered_json& bench) {
    if (bench.at("scaling").get<std::string>().empty()) return "";
    return "<section><h2>Growth</h2>\n<div class=\"plots\">" +
           plot(
               "build", 0,
               "Microseconds to build, of each triangle, both logarithmic: level is in proportion. "
               "One line for each that is built, as for the first of its walks.") +
           plot(
               "trace", 0,
               "Nanoseconds a ray, mean over the kinds of rays, both logarithmic. A colour is what "
               "is built, a line how it is walked. A tree's grows with the logarithm of the "
               "triangles, brute force's in proportion.") +
           "</div></section>\n";
}

std::string summaries_html(const ordered_json& bench) {
    std::string rows;
    for (const ordered_json& s : bench.at("summaries")) {
        rows += fmt::format(
            "<tr><td>{}{}</td>{}{}</tr>\n", key(s.at("name"), bench), text(s.at("name")),
            cell(s.at("mean").is_null() ? text(s.at("why_not"))
                                        : html::measured(s.at("mean"), "&times;&#8239;")),
            cell(s.at("mean").is_null()
                     ? unknown
                     : digits(s.at("worst")) + " &ndash; " + digits(s.at("best"))));
    }
    return "<section><h2>All meshes and kinds of rays</h2>\n<table><thead><tr><th>Structure</th>"
           "<th class=\"number\">Geometric mean of the ratios</th>"
           "<th class=\"number\">Worst and best</th></tr></thead><tbody>" +
           rows + "</tbody></table></section>\n";
}

} // namespace

std::string rays_page_html(const ordered_json& bench, const std::string& machine) {
    std::string notes, sections;
    for (const ordered_json& note : bench.at("notes"))
        notes += "<p class=\"hint\">" + text(note) + "</p>\n";
    for (std::size_t i = 0; i < bench.at("races").size(); ++i)
        sections += race_html(bench.at("races")[i], i, bench);
    const std::string body = fmt::format(
        "<header><h1>Rays a second</h1>\n<p class=\"summary\">{} &times; {} camera rays and what "
        "follows from them, {} rounds, {} thread{}; ratios to <strong>{}</strong> in the same "
        "round</p>\n<p class=\"machine\">{}</p>\n<p class=\"machine\"><code>{}</code></p>\n{}"
        "</header>\n{}{}{}<section><h2>How this was measured</h2>\n<p class=\"reason\">Everybody "
        "traces the same rays, in turns. Some rays of each kind are verified by brute force. "
        "Figures are medians over the rounds; an interval holds "
        "the true median with {:.1f}&#8239;% probability, whatever disturbed the clock. Answers "
        "differ if one finds a hit and the other none, or if t differs by more than {} of it; of "
        "structures that promise raylab's bits already if a bit or the triangle does. Whose "
        "answers differ in more than {} of the rays, or at all if they promised bits, gets no "
        "ratio.</p></section>\n",
        bench.at("width").get<int>(), bench.at("height").get<int>(), bench.at("rounds").get<int>(),
        bench.at("threads").get<int>(), bench.at("threads") == 1 ? "" : "s",
        text(bench.at("baseline")), escape_html(machine), text(bench.at("command")), notes,
        summaries_html(bench), scaling_html(bench), sections,
        100 * bench.at("interval_coverage").get<double>(), bench.at("tolerated_t").get<double>(),
        bench.at("tolerated_share").get<double>());
    return html_page({"raylab bench-rays", std::string(raylab::page_css) + page_css, body,
                      bench.dump(-1, ' ', false, ordered_json::error_handler_t::replace),
                      std::string(plot_parts_js) + rays_page_js});
}

} // namespace raylab::bench
