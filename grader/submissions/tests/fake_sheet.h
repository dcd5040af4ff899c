// A lab with files in a folder of its own and in one below it.
#pragma once

#include "grader/course/lab_sheet.h"

namespace raylab {

inline LabSheet fake_sheet() {
    LabSheet sheet;
    sheet.number = "02";
    sheet.folder = "02_iterative";
    sheet.title = "a lab";
    Task first, second;
    first.id = "2.1";
    first.files = {"path.h", "renderer.cu"};
    second.id = "2.2";
    second.files = {"path.h", "kd/split.cpp"};
    sheet.tasks = {first, second};
    return sheet;
}

} // namespace raylab
