#include "grader/report/lanes.h"

#include "grader/report/html.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab {

namespace {

// In pixels of the picture.
constexpr int cell_width = 15, cell_height = 18, left = 76, top = 66, gap = 48, bar_width = 300;

constexpr char style[] =
    "<style>text{font:12px sans-serif;fill:#222}.t{font-size:15px;font-weight:bold}"
    ".n{font-size:9px;text-anchor:middle}.b{text-anchor:end}</style>";

struct Drawing {
    std::string shapes;

    void rectangle(double x, double y, double width, double height, const char* colour) {
        shapes += fmt::format(
            "<rect x=\"{:.1f}\" y=\"{}\" width=\"{:.1f}\" height=\"{}\" fill=\"{}\"/>\n", x, y,
            width, height, colour);
    }
    void text(double x, double y, const char* kind, const std::string& words) {
        shapes += fmt::format("<text x=\"{:.1f}\" y=\"{}\" class=\"{}\">{}</text>\n", x, y, kind,
                              escape_html(words));
    }
};

constexpr char traced[] = "#2a78b8", done[] = "#f2c14e", wasted[] = "#e4e4e4";

const char* colour_of(const PathRecord& path, int bounce) {
    return bounce < path.length ? traced : bounce == path.length ? done : wasted;
}

// The warp, from its first bounce to the last of its longest path.
void draw_warp(Drawing& drawing, std::span<const PathRecord> warp, int rows, int first_pixel) {
    int longest = 0, rays = 0;
    for (const PathRecord& path : warp) {
        longest = std::max<int>(longest, path.length);
        rays += path.length;
    }
    const int lanes = static_cast<int>(warp.size());
    drawing.text(left, top - 40, "t",
                 fmt::format("Pixels {} to {} as one warp", first_pixel, first_pixel + lanes - 1));
    drawing.text(left, top - 22, "",
                 fmt::format("{} of {} lane-bounces at work, {:.0f} % wasted", rays,
                             lanes * longest,
                             longest == 0 ? 0.0 : 100 - 100.0 * rays / (lanes * longest)));
    for (int lane = 0; lane < lanes; ++lane) {
        const double x = left + lane * cell_width;
        drawing.text(x + cell_width / 2.0, top - 5, "n", std::to_string(lane));
        for (int bounce = 0; bounce < std::min(longest, rows); ++bounce)
            drawing.rectangle(x, top + bounce * cell_height, cell_width - 1, cell_height - 1,
                              colour_of(warp[lane], bounce));
    }
}

void draw_bounces(Drawing& drawing, const Ledger& ledger, int x, int rows) {
    drawing.text(x, top - 40, "t", "All warps: lanes at work");
    drawing.text(x, top - 22, "", fmt::format("{} samples a pixel", ledger.samples));
    for (int bounce = 0; bounce < rows; ++bounce) {
        const BounceCounts& counts = ledger.bounces[bounce];
        const int y = top + bounce * cell_height;
        const double share = lanes_alive(counts);
        drawing.text(left - 8, y + 13, "b", fmt::format("bounce {}", bounce));
        drawing.rectangle(x, y, bar_width, cell_height - 1, wasted);
        drawing.rectangle(x, y, bar_width * share, cell_height - 1, traced);
        drawing.text(x + bar_width + 8, y + 13, "",
                     fmt::format("{:.1f} %   {} of {}", 100 * share, counts.rays, counts.lanes));
    }
}

void draw_legend(Drawing& drawing, int y) {
    const struct {
        const char *colour, *words;
    } entries[] = {{traced, "a ray is traced"},
                   {done, "the path is done: the lane is idle from here on"},
                   {wasted, "wasted: the warp waits for its longest path"}};
    double x = left;
    for (const auto& entry : entries) {
        drawing.rectangle(x, y, 12, 12, entry.colour);
        drawing.text(x + 18, y + 11, "", entry.words);
        x += 40 + 7 * std::string(entry.words).size();
    }
}

} // namespace

std::string lanes_picture(const Ledger& ledger, std::span<const PathRecord> warp, int first_pixel) {
    int rows = 0; // bounces that some path had
    while (rows < static_cast<int>(ledger.bounces.size()) && ledger.bounces[rows].rays > 0) ++rows;
    const int bars = left + static_cast<int>(warp.size()) * cell_width + gap;
    const int width = bars + bar_width + 230, height = top + rows * cell_height + 50;
    Drawing drawing;
    drawing.rectangle(0, 0, width, height, "white");
    draw_warp(drawing, warp, rows, first_pixel);
    draw_bounces(drawing, ledger, bars, rows);
    draw_legend(drawing, top + rows * cell_height + 20);
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" "
        "height=\"{1}\">\n<title>{2}, {3}: lanes at work</title>\n{4}\n{5}</svg>\n",
        width, height, escape_html(ledger.lab), escape_html(ledger.scene), style, drawing.shapes);
}

} // namespace raylab
