// A page in a real browser, if there is one.
#pragma once

#include "common/cli/process.h"

#include <string>

namespace raylab {

// What headless Chromium makes of a page, its script run to the end; nothing where there is none.
// `page`: a file, and if need be its #fragment. `folder`: the browser's own, for its profile.
inline std::string page_in_browser(const std::string& page, const std::string& folder) {
    const auto output_of = [](const std::string& command) {
        return run_process({"sh", "-c", command}, {60}).output;
    };
    std::string browser = output_of("command -v chromium || command -v chromium-browser || "
                                    "command -v google-chrome");
    if (browser.empty()) return "";
    browser.resize(browser.find('\n'));
    return output_of(
        "'" + browser + "' --headless=new --no-sandbox --disable-gpu --user-data-dir='" + folder +
        "/profile' --virtual-time-budget=5000 --dump-dom 'file://" + page + "' 2>/dev/null");
}

} // namespace raylab
