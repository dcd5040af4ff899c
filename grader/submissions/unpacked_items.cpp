#include "grader/submissions/archive.h"

#include "common/cli/files.h"

#include <algorithm>
#include <fstream>
#include <memory>

namespace raylab {

namespace fs = std::filesystem;

std::vector<Item> unpacked_items(const fs::path& file, const std::string& name,
                                 const fs::path& folder, const UnpackLimits& limits,
                                 const std::function<bool(const Item& item)>& keep) {
    std::vector<Item> items;
    fs::create_directories(folder);
    read_archive(file, name, limits, [&](const Item& entry) -> Sink {
        Item item = entry;
        const bool is_deep_folder = item.kind == Item::Kind::folder &&
                                    std::count(item.name.begin(), item.name.end(), '/') > 1;
        if (is_deep_folder) return nullptr;
        const bool kept = item.kind == Item::Kind::file && !is_junk(item.name) && keep(item);
        if (kept) item.path = folder / std::to_string(items.size());
        items.push_back(item);
        if (!kept) return nullptr;
        const auto stream = std::make_shared<std::ofstream>(item.path, std::ios::binary);
        return [stream, path = item.path](std::string_view bytes) {
            if (!stream->write(bytes.data(), static_cast<std::streamsize>(bytes.size())).flush())
                throw FileError("cannot write '" + path.string() +
                                    "': is the disk full? Free some space, or name another folder",
                                ExitCode::tool_failed);
        };
    });
    return items;
}

} // namespace raylab
