// Any bytes as an archive, its names grouped as every platform does; any bytes as Gradescope's
// list.
#include "grader/submissions/archive.h"
#include "grader/submissions/class_export.h"
#include "grader/submissions/pick.h"
#include "grader/submissions/source_text.h"
#include "grader/submissions/submission_error.h"

#include <cstdint>
#include <cstdlib>

namespace {

raylab::LabSheet sheet() {
    raylab::LabSheet sheet;
    sheet.number = "02";
    sheet.folder = "02_iterative";
    raylab::Task task;
    task.files = {"path.h", "kd/split.cpp"};
    sheet.tasks = {task};
    return sheet;
}

void pick(const std::vector<raylab::Item>& items) {
    static const raylab::LabSheet lab = sheet();
    try {
        raylab::pick_files(items, lab);
    } catch (const raylab::SubmissionError&) {
    }
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string bytes(reinterpret_cast<const char*>(data), size);
    raylab::UnpackLimits limits;
    limits.bytes = 1 << 20;
    std::vector<raylab::Item> items;
    std::size_t taken = 0;
    try {
        raylab::read_archive_bytes(bytes, "input", limits, [&](const raylab::Item& item) {
            items.push_back(item);
            return [&taken](std::string_view block) { taken += block.size(); };
        });
    } catch (const raylab::SubmissionError&) {
    }
    if (taken > limits.bytes + (1 << 20)) std::abort(); // a block more than allowed at most
    items.push_back(raylab::item_named(bytes, {}));
    items.push_back(raylab::item_named(bytes.substr(0, 40) + "/path.h", {}));
    pick(items);
    for (const bool packed : {false, true})
        for (const auto& entry : raylab::group_class(items, bytes, packed).entries)
            pick(entry.items);
    items.push_back(raylab::item_named("submission_metadata.yml", {}));
    raylab::group_class(items, bytes, false);
    try {
        raylab::source_text(bytes, "input");
    } catch (const raylab::SubmissionError&) {
    }
    return 0;
}
