// The page: a table of all judgements, then a section for each scene. Text is in the HTML itself;
// the script (page.js) only draws the pictures. Every caption is computed from the data.
#include "grader/report/html.h"
#include "grader/report/report.h"

#include "grader/report/page_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

namespace raylab {
namespace {

std::string anchor(const ReportEntry& e) {
    std::string name = e.scene + "-" + e.lab;
    std::replace_if(
        name.begin(), name.end(),
        [](unsigned char c) { return !std::isalnum(c) && c != '_' && c != '-'; }, '-');
    return name;
}

std::string badge(const ReportEntry& e) {
    if (!e.decided) return "<span class=\"badge open\">undecided</span>";
    return e.passed ? "<span class=\"badge pass\">passed</span>"
                    : "<span class=\"badge fail\">failed</span>";
}

std::string percent(double share, const char* format = "{:+.2f}&#8239;%") {
    return std::isfinite(share) ? fmt::format(fmt::runtime(format), 100 * share) : "&ndash;";
}

std::string seconds(double s) {
    return s < 0.1  ? fmt::format("{:.0f}&#8239;ms", 1000 * s)
           : s < 90 ? fmt::format("{:.1f}&#8239;s", s)
                    : fmt::format("{:.1f}&#8239;min", s / 60);
}

// Pictures of the page, each stored once however often it is shown.
class Pictures {
  public:
    std::string id_of(const Image& image) {
        const auto [found, fresh] =
            ids_.try_emplace(radiance_png(image), fmt::format("p{}", ids_.size()));
        if (fresh) data_[found->second] = found->first;
        return found->second;
    }
    const nlohmann::json& data() const { return data_; }

  private:
    std::map<std::string, std::string> ids_;
    nlohmann::json data_ = nlohmann::json::object();
};

std::string table_row(const ReportEntry& e) {
    std::string error = "&ndash;", rel_mse = "&ndash;";
    if (has_pair(e)) {
        const Metrics m = e.verdict.measured.value_or(Measures{}).metrics;
        error = percent(m.rel_error);
        rel_mse = fmt::format("{:.1e}", m.rel_mse);
    }
    return fmt::format("<tr><td><a href=\"#at={}\">{}</a></td><td>{}</td><td>{}</td>"
                       "<td class=\"number\">{}</td><td class=\"number\">{}</td>"
                       "<td class=\"number\">{}</td></tr>\n",
                       anchor(e), escape_html(e.title), escape_html(e.lab), badge(e), error,
                       rel_mse, seconds(e.seconds));
}

// Bars in SVG: the security policy forbids style attributes.
std::string lanes_chart(const std::vector<double>& alive) {
    if (alive.empty()) return "";
    constexpr double width = 320, height = 84;
    const double step = width / double(alive.size());
    std::string bars;
    for (std::size_t i = 0; i < alive.size(); ++i) {
        const double h = height * std::clamp(alive[i], 0.0, 1.0);
        bars += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\">"
                            "<title>bounce {}: {:.1f} %</title></rect>",
                            double(i) * step, height - h, std::max(1.0, step - 2), h, i + 1,
                            100 * alive[i]);
    }
    const double first = alive.front(), last = alive.back();
    const char* moves = last < first ? "fall" : last > first ? "rise" : "stay";
    const std::string caption =
        alive.size() == 1
            ? fmt::format("{:.1f} % of lanes are alive at the only bounce.", 100 * first)
            : fmt::format(
                  "Lanes alive {} from {:.1f} % at the first bounce to {:.1f} % at bounce {}.",
                  moves, 100 * first, 100 * last, alive.size());
    return fmt::format("<figure class=\"lanes\"><svg viewBox=\"0 0 {0} {1}\" role=\"img\" "
                       "aria-label=\"{2}\"><line x1=\"0\" y1=\"0\" x2=\"{0}\" y2=\"0\"/>{3}</svg>"
                       "<figcaption>{2}</figcaption></figure>\n",
                       width, height, escape_html(caption), bars);
}

// "Of 64 tiles 95 % have |z| below 1.9; the largest is +2.6."
std::string z_caption(const ZMap& map) {
    std::vector<double> sizes;
    double largest = 0;
    for (const double z : map.z) {
        if (!std::isfinite(z)) continue;
        sizes.push_back(std::abs(z));
        if (std::abs(z) > std::abs(largest)) largest = z;
    }
    if (sizes.empty()) return "Neither image carries a variance: there is no z.";
    std::sort(sizes.begin(), sizes.end());
    return fmt::format(
        "Each {0} x {0} tile's mean, rendered less reference, in standard errors (red: "
        "too bright, blue: too dark, full colour at 6). 95 % of {1} tiles are within "
        "{2:.1f}; the largest is {3:+.1f}.",
        map.tile, sizes.size(), sizes[(sizes.size() - 1) * 95 / 100], largest);
}

// The range of the difference picture: 95 % of pixels lie within it. Relative to the mean.
double difference_range(const Image& image, const Image& reference) {
    std::vector<double> sizes;
    double mean = 0;
    for (std::size_t i = 0; i < image.pixels(); ++i) {
        const double a = luminance(image.mean[i]), b = luminance(reference.mean[i]);
        if (!std::isfinite(a) || !std::isfinite(b)) continue;
        sizes.push_back(std::abs(a - b));
        mean += b;
    }
    if (sizes.empty() || mean <= 0) return 1;
    std::sort(sizes.begin(), sizes.end());
    const double range = sizes[(sizes.size() - 1) * 95 / 100] / (mean / double(sizes.size()));
    return range > 0 ? range : 1;
}

std::string spp_of(const Image& image) {
    return image.provenance.spp > 0 ? fmt::format(", {} samples a pixel", image.provenance.spp)
                                    : "";
}

// The viewer of one entry; `view` receives what its script needs.
std::string viewer(const ReportEntry& e, Pictures& pictures, nlohmann::json& view) {
    if (!e.image) return "";
    const Image& image = *e.image;
    view["image"] = pictures.id_of(image);
    view["width"] = image.width;
    view["height"] = image.height;
    const std::string rendered = "Rendered" + spp_of(image) + ".";
    view["captions"]["rendered"] = rendered;
    std::vector<std::pair<const char*, const char*>> modes{{"rendered", "rendered"}};
    if (has_pair(e)) {
        const auto [metrics, map] = e.verdict.measured.value_or(Measures{});
        const double range = difference_range(image, *e.reference);
        view["reference"] = pictures.id_of(*e.reference);
        view["z"] = map.z;
        view["z_columns"] = map.columns;
        view["z_tile"] = map.tile;
        view["range"] = range;
        view["captions"]["slider"] = fmt::format("Left: rendered{}. Right: reference{}.",
                                                 spp_of(image), spp_of(*e.reference));
        view["captions"]["reference"] = "Reference" + spp_of(*e.reference) + ".";
        view["captions"]["difference"] =
            fmt::format("Rendered less reference (red: too bright, blue: too dark), full colour at "
                        "{:.2g} % of the "
                        "mean, which 95 % of pixels do not pass. The mean differs by {:+.2g} %.",
                        100 * range, 100 * metrics.rel_error);
        view["captions"]["z"] = z_caption(map);
        modes = {{"slider", "slider"},
                 {"rendered", "rendered"},
                 {"reference", "reference"},
                 {"difference", "difference"},
                 {"z", "z-map"}};
    }
    std::string buttons;
    for (const auto& [mode, name] : modes)
        buttons += fmt::format("<button type=\"button\" data-mode=\"{}\"><canvas></canvas>"
                               "<span>{}</span></button>",
                               mode, name);
    return fmt::format(
        "<figure class=\"viewer\"><canvas class=\"stage\" width=\"{}\" height=\"{}\" "
        "tabindex=\"0\" "
        "aria-label=\"{} by {}\"></canvas><p class=\"readout\">Point at a pixel to read its "
        "radiance.</p>"
        "<div class=\"modes\">{}</div>"
        "<label class=\"exposure\">Exposure <input type=\"range\" min=\"-8\" max=\"8\" "
        "step=\"0.25\" value=\"0\"><output>0</output></label>"
        "<figcaption>{}</figcaption></figure>\n",
        image.width, image.height, escape_html(e.title), escape_html(e.lab), buttons,
        escape_html(rendered));
}

std::string checks_list(const ReportEntry& e) {
    if (e.checks.empty()) return "";
    std::string items;
    for (const Verdict& check : e.checks)
        items += fmt::format("<li class=\"{}\">{}</li>", check.passed ? "pass" : "fail",
                             escape_html(check.sentence));
    return "<ul class=\"checks\">" + items + "</ul>\n";
}

std::string entry_html(const ReportEntry& e, Pictures& pictures, nlohmann::json& views) {
    nlohmann::json view = nlohmann::json::object();
    const std::string pictures_html = viewer(e, pictures, view);
    views[anchor(e)] = view;
    std::string hints, facts;
    for (const std::string& hint : e.verdict.hints)
        hints += "<p class=\"hint\">" + escape_html(hint) + "</p>\n";
    for (const Fact& fact : e.facts)
        facts +=
            fmt::format("<dt>{}</dt><dd>{}</dd>", escape_html(fact.label), escape_html(fact.value));
    return fmt::format("<article id=\"{}\">\n<h3>{} {}</h3>\n<p class=\"sentence\">{}</p>\n{}{}"
                       "<div class=\"body\">{}<div class=\"side\"><dl>{}</dl>{}</div></div>\n"
                       "</article>\n",
                       anchor(e), escape_html(e.lab), badge(e), escape_html(e.verdict.sentence),
                       hints, checks_list(e), pictures_html, facts, lanes_chart(e.lanes_alive));
}

} // namespace

std::string report_html(const Report& report) {
    Pictures pictures;
    nlohmann::json views = nlohmann::json::object();
    std::string rows, sections, scene;
    std::size_t passed = 0;
    for (const ReportEntry& e : report.entries) {
        passed += e.passed;
        rows += table_row(e);
        if (e.scene != scene || sections.empty()) {
            if (!sections.empty()) sections += "</section>\n";
            sections += fmt::format("<section><h2>{}</h2><p class=\"reason\">{}</p>\n",
                                    escape_html(e.title), escape_html(e.reason));
            scene = e.scene;
        }
        sections += entry_html(e, pictures, views);
    }
    if (!sections.empty()) sections += "</section>\n";

    const nlohmann::json data{{"pictures", pictures.data()}, {"views", views}};
    const std::string body = fmt::format(
        "<header><h1>{0}</h1>\n<p class=\"summary\"><strong>{1} of {2}</strong> passed</p>\n"
        "<p class=\"machine\">{3}</p>\n<p class=\"machine\"><code>{4}</code></p></header>\n"
        "<noscript><p class=\"hint\">The pictures need JavaScript; all text is here without it.</p>"
        "</noscript>\n"
        "<table><thead><tr><th>Scene</th><th>Lab</th><th>Verdict</th>"
        "<th class=\"number\" title=\"of the image's mean luminance\">Mean error</th>"
        "<th class=\"number\" title=\"the reference's own noise is taken off\">relMSE</th>"
        "<th class=\"number\">Time</th></tr></thead>\n<tbody>\n{5}</tbody></table>\n{6}",
        escape_html(report.title), passed, report.entries.size(), escape_html(report.machine),
        escape_html(report.command), rows, sections);
    return html_page({report.title, page_css, body,
                      data.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace),
                      page_js});
}

} // namespace raylab
