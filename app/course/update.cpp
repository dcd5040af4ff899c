// raylab update NEW_TREE: a mended release comes into this tree; the student's work stays.
#include "app/course/commands.h"
#include "common/cli/files.h"
#include "common/cli/process.h"
#include "grader/course/released_as.h"
#include "grader/course/update_tree.h"

#include <fmt/format.h>

namespace raylab::app {

namespace fs = std::filesystem;

namespace {

struct UpdateOptions {
    std::string mended;
    bool dry_run = false;
};

class TemporaryFolder {
  public:
    TemporaryFolder() : path_((fs::temp_directory_path() / "raylab-update-XXXXXX").string()) {
        if (mkdtemp(path_.data()) == nullptr)
            throw std::system_error(errno, std::generic_category(), path_);
    }
    ~TemporaryFolder() {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    fs::path path() const { return path_; }

  private:
    std::string path_;
};

// The one lab of a released tree.
LabSheet only_lab(const fs::path& root) {
    const std::vector<std::string> labs =
        fs::is_directory(root / "labs") ? lab_folders(root) : std::vector<std::string>();
    if (labs.size() != 1 || !fs::exists(root / released_as))
        throw CourseError(fmt::format(
            "'{}' is no released tree: it has {} labs, and {} {}", root.string(), labs.size(),
            fs::exists(root / released_as) ? "has" : "lacks", released_as));
    return read_lab_sheet(root, labs.front());
}

void print(const std::vector<FileUpdate>& updates, const LabSheet& sheet) {
    int kept = 0;
    for (const FileUpdate& update : updates) {
        fmt::print("{:9} {}\n", name(update.fate), update.file);
        kept += update.fate == Fate::kept;
    }
    if (kept > 0)
        fmt::print("{} of your files stay as they are, though the release has changed them, too: "
                   "the new text is in FILE.new beside each. Compare them, take over what you "
                   "need, and remove FILE.new\n",
                   kept);
    fmt::print("{} files to update; `./raylab check {}` builds what is new\n", updates.size(),
               sheet.number);
}

ExitCode run_update(const Tree& tree, const UpdateOptions& options) {
    const LabSheet sheet = only_lab(tree.root), theirs = only_lab(options.mended);
    if (sheet.folder != theirs.folder)
        throw CourseError(fmt::format("this is a tree of lab {}, and '{}' is one of lab {}",
                                      sheet.number, options.mended, theirs.number));
    const TemporaryFolder folder;
    const fs::path base = folder.path() / "base", mended = folder.path() / "mended";
    unpack_release(tree.root, base);
    unpack_release(options.mended, mended);
    std::set<std::string> task_files;
    for (const std::string& file : sheet.files())
        task_files.insert("labs/" + sheet.folder + "/" + file);
    const std::vector<FileUpdate> updates = plan_update(base, mended, tree.root, task_files);
    print(updates, sheet);
    if (options.dry_run) return ExitCode::success;
    apply_update(updates, mended, tree.root);
    // Last: until now the update can be done again.
    write_file((tree.root / released_as).string(),
               read_file((fs::path(options.mended) / released_as).string()));
    return ExitCode::success;
}

} // namespace

Run add_update(CLI::App& app, const Tree& tree) {
    auto options = std::make_shared<UpdateOptions>();
    app.description("Bring a mended release into this tree; what you have written stays.");
    app.add_option("NEW_TREE", options->mended, "the folder of the mended release, of the same lab")
        ->required()
        ->check(CLI::ExistingDirectory);
    app.add_flag("--dry-run", options->dry_run, "say what would be done, and do nothing");
    app.footer("Examples:\n  raylab update ~/Downloads/02_iterative --dry-run\n"
               "  raylab update ~/Downloads/02_iterative\n"
               "Files with tasks are never touched. In other files your changes and the release's "
               "are put together\n(by git) where they do not touch each other.");
    return [options, tree] { return run_update(tree, *options); };
}

} // namespace raylab::app
