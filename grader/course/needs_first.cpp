#include "grader/course/needs_first.h"

#include "grader/course/contains.h"

#include <fmt/format.h>

#include <algorithm>

namespace raylab {

void say_what_is_needed_first(std::vector<TaskResult>& results) {
    const auto comes_first = [&](const std::string& need, const TaskResult& result) {
        return std::any_of(results.begin(), results.end(), [&](const TaskResult& other) {
            const bool mutual = contains(other.task.needs, result.task.id);
            return other.task.id == need && other.verdict == TaskVerdict::wrong &&
                   (!mutual || &other < &result);
        });
    };
    for (TaskResult& result : results) {
        if (result.verdict != TaskVerdict::wrong) continue;
        for (const std::string& need : result.task.needs)
            if (comes_first(need, result))
                result.facts.insert(
                    result.facts.begin(),
                    fmt::format("needs first: task {}, which is WRONG; mend it and check "
                                "this task again",
                                need));
    }
}

} // namespace raylab
