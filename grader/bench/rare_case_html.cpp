// The section of the page about the rare cases: two plots of what compaction saves, and the table.
#include "grader/bench/html_cells.h"
#include "grader/bench/rare_case.h"

#include <fmt/format.h>

namespace raylab::bench {

namespace {

using namespace html;
using nlohmann::ordered_json;

std::string times(double ratio) { return fmt::format("&times;&#8239;{:.2f}", ratio); }

std::string percent(double share) { return fmt::format("{:.1f}&#8239;%", 100 * share); }

// ms, and how many times the megakernel's.
std::string time_cells(double seconds, const ordered_json& megakernel) {
    return cell(digits(1e3 * seconds)) +
           cell(megakernel.is_null() ? unknown
                                     : times(seconds / megakernel.at("seconds").get<double>()));
}

std::string wavefront_html(const char* name, std::size_t colour, const ordered_json& costs,
                           const ordered_json& megakernel) {
    const auto figure = [&](const char* key) { return costs.at(key).get<double>(); };
    const auto whole = [](double v) { return cell(v > 0 ? fmt::format("{:.0f}", v) : unknown); };
    return fmt::format("<tr><td><span class=\"key c{}\"></span>{}</td>", colour, name) +
           time_cells(figure("seconds"), megakernel) + whole(figure("iterations")) +
           whole(figure("rays") / figure("iterations")) + whole(figure("blocks")) +
           whole(figure("batches")) + whole(figure("launches")) +
           cell(percent(figure("share_of_compaction_and_sort"))) +
           cell(percent(figure("share_between_launches"))) + "</tr>\n";
}

std::string case_html(const ordered_json& row) {
    const ordered_json& megakernel = row.at("megakernel");
    std::string html = fmt::format(
        "<tr class=\"case\"><td colspan=\"10\"><strong>{}</strong><span class=\"interval\">{}, {} "
        "&times; {}. {}</span></td></tr>\n",
        text(row.at("case")), text(row.at("scene")), row.at("width").get<int>(),
        row.at("height").get<int>(), text(row.at("why")));
    if (!megakernel.is_null()) {
        html += "<tr><td>megakernel</td>" + time_cells(megakernel.at("seconds"), megakernel);
        for (int column = 3; column < 10; ++column) html += cell(unknown);
        html += "</tr>\n";
    }
    return html + wavefront_html("without compaction", 0, row.at("without"), megakernel) +
           wavefront_html("with it", 1, row.at("with"), megakernel);
}

std::string plot(const char* quantity, const char* caption) {
    return fmt::format("<figure class=\"plot\" data-plot=\"rare_cases\" data-quantity=\"{}\">"
                       "<figcaption>{}</figcaption></figure>\n",
                       quantity, caption);
}

} // namespace

std::string rare_cases_html(const ordered_json& rows) {
    std::string cases;
    for (const ordered_json& row : rows) cases += case_html(row);
    return "<section id=\"rare-cases\"><h2>The rare cases that gain nothing</h2>\n"
           "<p class=\"reason\">Compaction takes the rays that have ended out of the list, so that "
           "later iterations launch fewer blocks. That pays where many rays end early, as in the "
           "first case; each of the others takes away one reason why it should.</p>\n"
           "<div class=\"plots\">\n" +
           plot("seconds", "Time of a sample over the megakernel's. Shorter is better: left of the "
                           "line the wavefront wins.") +
           plot("blocks", "Blocks that trace a sample, over those without compaction: what is "
                          "saved before any of it is time.") +
           "</div>\n<div class=\"wide\"><table class=\"bench cases\">" +
           head({{"Case", ""},
                 {"ms", "of a sample of the whole image, median of the rounds"},
                 {"to lab 02", "over the megakernel's time"},
                 {"Iterations", "a sample"},
                 {"Live rays", "mean of an iteration's"},
                 {"Blocks", "that trace, a sample"},
                 {"Batches", "in which the device works the blocks off"},
                 {"Launches", "of all kernels, a sample"},
                 {"Removing", "share of the time in compaction and sorting"},
                 {"Between", "share of the time between launches"}}) +
           "<tbody>" + cases + "</tbody></table></div></section>\n";
}

} // namespace raylab::bench
