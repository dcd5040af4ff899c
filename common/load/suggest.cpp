// Spelling help by edit distance.
// Damerau, A technique for computer detection and correction of spelling errors, CACM 7(3), 1964.
#include "common/load/suggest.h"

#include <algorithm>

namespace raylab {

int edit_distance(std::string_view a, std::string_view b) {
    // row[i][j]: the distance between the first i letters of a and the first j of b. Only the last
    // three rows are needed.
    std::vector<int> before(b.size() + 1), previous(b.size() + 1), row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) row[j] = int(j);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        before = previous;
        previous = row;
        row[0] = int(i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const int replaced = previous[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({replaced, previous[j] + 1, row[j - 1] + 1});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], before[j - 2] + 1);
        }
    }
    return row[b.size()];
}

std::string did_you_mean(std::string_view word, const std::vector<std::string>& known) {
    if (word.size() > 64) return "";
    const std::string* best = nullptr;
    int best_distance = word.size() < 4 ? 2 : word.size() < 8 ? 3 : 4; // less than this is near
    for (const std::string& candidate : known) {
        int distance = edit_distance(word, candidate);
        // Half a name is a common slip too: "vfov" for "vfov_deg".
        if (word.size() >= 3 && candidate.starts_with(word)) distance = std::min(distance, 1);
        if (distance < best_distance) {
            best_distance = distance;
            best = &candidate;
        }
    }
    return best ? "; did you mean \"" + *best + "\"?" : "";
}

std::string one_of(const std::vector<std::string>& words) {
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i)
        text += (i == 0 ? "\"" : i + 1 == words.size() ? " or \"" : ", \"") + words[i] + "\"";
    return text.empty() ? "nothing" : text;
}

std::string listed(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text.append(text.empty() ? "" : ", ").append(word);
    return text;
}

} // namespace raylab
