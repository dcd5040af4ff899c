// Escaping, base64, the packing of radiance into an opaque 8-bit picture, and the page.
#include "grader/report/html.h"

#include "common/image/image_file.h"
#include "common/math/index.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace raylab {
namespace {

std::string base64(std::string_view bytes) {
    constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    const auto at = [&](std::size_t i) -> unsigned {
        return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0;
    };
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const unsigned v = at(i) << 16 | at(i + 1) << 8 | at(i + 2);
        for (int k = 0; k < 4; ++k) text += digits[v >> (18 - 6 * k) & 63];
    }
    for (std::size_t pad = 0; pad < (3 - bytes.size() % 3) % 3; ++pad)
        text[text.size() - 1 - pad] = '=';
    return text;
}

std::uint8_t byte(float v) { return static_cast<std::uint8_t>(index_of(v, 256)); }

// The page's security policy allows only scripts and styles with this number, which are the page's
// own.
std::string random_nonce() {
    std::random_device random;
    return fmt::format("{:08x}{:08x}{:08x}{:08x}", random(), random(), random(), random());
}

} // namespace

std::string escape_script_json(std::string json) {
    for (std::size_t i = 0; (i = json.find('<', i)) != std::string::npos;)
        json.replace(i, 1, "\\u003c");
    return json;
}

std::string radiance_png(const Image& image) {
    const auto width = static_cast<std::size_t>(image.width);
    std::vector<Rgb8> pixels(2 * image.pixels());
    for (std::size_t i = 0; i < image.pixels(); ++i) {
        Rgb8& mantissa = pixels[i / width * 2 * width + i % width];
        Rgb8& exponent = pixels[i / width * 2 * width + width + i % width];
        const Vec3 v = image.mean[i];
        if (!is_finite(v)) {
            exponent = {255, 255, 255};
            continue;
        }
        int e = 0;
        std::frexp(max_component(v), &e); // largest = f 2^e, f in [0.5, 1)
        e = std::clamp(e, -127, 126);
        if (max_component(v) <= 0) e = -127;
        for (int c = 0; c < 3; ++c)
            mantissa[static_cast<std::size_t>(c)] = byte(std::ldexp(v[c], 8 - e));
        exponent.fill(static_cast<std::uint8_t>(e + 128));
    }
    return "data:image/png;base64," + base64(encode_png(2 * image.width, image.height, pixels));
}

std::string html_page(const HtmlPage& page) {
    return fmt::format(
        "<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
        "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
        "style-src 'nonce-{0}'; script-src 'nonce-{0}'; base-uri 'none'; form-action 'none'\">\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
        "<meta name=\"color-scheme\" content=\"light dark\">\n"
        "<title>{1}</title>\n<style nonce=\"{0}\">\n{2}</style>\n</head>\n<body>\n{3}"
        "<script type=\"application/json\" id=\"data\" nonce=\"{0}\">{4}</script>\n"
        "<script nonce=\"{0}\">\n{5}</script>\n</body>\n</html>\n",
        random_nonce(), escape_html(page.title), page.css, page.body, escape_script_json(page.data),
        page.script);
}

} // namespace raylab
