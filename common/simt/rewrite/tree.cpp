// Rewriting a source and its headers; see tree.h.
#include "common/simt/rewrite/tree.h"

#include "common/simt/rewrite/foreign.h"
#include "common/simt/rewrite/rewrite.h"

#include <fstream>
#include <set>
#include <sstream>
#include <stdexcept>

namespace fs = std::filesystem;

namespace raylab::simt {

namespace {

class Tree {
  public:
    Tree(const fs::path& source, const fs::path& out, const std::vector<fs::path>& folders)
        : home_(folder_of(source)), out_(fs::absolute(out)),
          has_thrust_(has_thrust("/usr/include")) {
        for (const fs::path& folder : folders)
            if (has_thrust(folder))
                has_thrust_ = true; // a library for a host compiler already: it stays as it is
            else
                folders_.push_back(folder);
    }

    // Rewrites the file, and those it includes, and returns where the copy is.
    fs::path add(const fs::path& file, bool main) {
        fs::path copy = copy_of(file, main);
        if (!done_.insert(copy).second) return copy;
        std::string text = rewrite_foreign(read(file), file.string(), [&](std::string_view quoted) {
            return include(quoted, folder_of(file));
        });
        // nvcc reads the runtime's header in front of every source.
        if (main) text = "#include <cuda_runtime.h>\n" + text;
        if (main && uses_thrust_) // nvcc says that its devices are GPUs
            text = "#ifndef THRUST_DEVICE_SYSTEM\n"
                   "#define THRUST_DEVICE_SYSTEM THRUST_DEVICE_SYSTEM_CPP\n#endif\n" +
                   text;
        write(copy, text);
        return copy;
    }

  private:
    static fs::path folder_of(const fs::path& file) {
        return file.has_parent_path() ? file.parent_path() : fs::path(".");
    }

    static bool has_thrust(const fs::path& folder) {
        return fs::exists(folder / "thrust/version.h");
    }

    Include include(std::string_view quoted, const fs::path& folder) {
        std::string name(quoted.substr(1, quoted.size() - 2));
        std::vector<fs::path> candidates;
        if (quoted[0] == '"') candidates.push_back(folder / name);
        for (const fs::path& other : folders_) candidates.push_back(other / name);
        for (const fs::path& candidate : candidates)
            if (fs::is_regular_file(candidate))
                return {"\"" + add(candidate.lexically_normal(), false).string() + "\"", ""};
        uses_thrust_ |= name.starts_with("thrust/");
        return {"", refused_header(name, has_thrust_)};
    }

    // Below `out` as the file is below the source's folder; steps upwards become folders "up".
    fs::path copy_of(const fs::path& file, bool main) const {
        fs::path copy = out_;
        for (const fs::path& part : fs::absolute(file).lexically_normal().lexically_relative(
                 fs::absolute(home_).lexically_normal()))
            copy /= part == ".." ? "up" : part;
        if (main) copy += ".cpp";
        return copy;
    }

    static std::string read(const fs::path& file) {
        std::ifstream in(file, std::ios::binary);
        std::stringstream text;
        text << in.rdbuf();
        if (!in) throw std::runtime_error(file.string() + ": error: cannot be read");
        const std::string all = text.str(), mark = "\xef\xbb\xbf"; // of UTF-8, by some editors
        return all.starts_with(mark) ? all.substr(mark.size()) : all;
    }

    static void write(const fs::path& file, const std::string& text) {
        std::error_code ignored;
        fs::create_directories(file.parent_path(), ignored);
        std::ofstream out(file, std::ios::binary);
        out << text;
        out.close();
        if (!out) throw std::runtime_error(file.string() + ": error: cannot be written");
    }

    fs::path home_, out_;
    bool has_thrust_, uses_thrust_ = false;
    std::vector<fs::path> folders_;
    std::set<fs::path> done_;
};

} // namespace

fs::path rewrite_tree(const fs::path& source, const fs::path& out,
                      const std::vector<fs::path>& folders) {
    return Tree(source, out, folders).add(source, true);
}

} // namespace raylab::simt
