// Archives for tests, hostile ones too: libarchive writes what it is told.
#pragma once

#include "grader/submissions/utf8_locale.h"

#include <archive.h>
#include <archive_entry.h>

#include <filesystem>
#include <stdexcept>
#include <string>

namespace raylab {

class MadeArchive {
  public:
    // format: "zip", "gnutar" or "pax"; filter: "", "gzip", "bzip2", "xz" or "zstd".
    MadeArchive(const std::filesystem::path& file, const char* format, const char* filter = "")
        : archive_(archive_write_new()) {
        const Utf8Locale names;
        const bool packed = *filter != '\0';
        expect(archive_write_set_format_by_name(archive_, format));
        if (packed) expect(archive_write_add_filter_by_name(archive_, filter));
        if (std::string(format) == "zip") archive_write_set_options(archive_, "hdrcharset=UTF-8");
        expect(archive_write_open_filename(archive_, file.c_str()));
    }
    ~MadeArchive() { archive_write_free(archive_); }
    MadeArchive(const MadeArchive&) = delete;
    MadeArchive& operator=(const MadeArchive&) = delete;

    MadeArchive& file(const std::string& name, const std::string& bytes) {
        return add(name, AE_IFREG, bytes, "");
    }
    MadeArchive& folder(const std::string& name) { return add(name, AE_IFDIR, "", ""); }
    MadeArchive& symlink(const std::string& name, const std::string& to) {
        return add(name, AE_IFLNK, "", to);
    }
    MadeArchive& device(const std::string& name) { return add(name, AE_IFCHR, "", ""); }
    MadeArchive& hardlink(const std::string& name, const std::string& to) {
        archive_entry* entry = archive_entry_new();
        archive_entry_copy_pathname(entry, name.c_str());
        archive_entry_copy_hardlink(entry, to.c_str());
        archive_entry_set_filetype(entry, AE_IFREG);
        expect(archive_write_header(archive_, entry));
        archive_entry_free(entry);
        return *this;
    }
    void close() { expect(archive_write_close(archive_)); }

  private:
    MadeArchive& add(const std::string& name, unsigned type, const std::string& bytes,
                     const std::string& to) {
        const Utf8Locale names;
        archive_entry* entry = archive_entry_new();
        archive_entry_copy_pathname(entry, name.c_str());
        archive_entry_set_filetype(entry, type);
        archive_entry_set_perm(entry, 0644);
        archive_entry_set_size(entry, static_cast<la_int64_t>(bytes.size()));
        if (!to.empty()) archive_entry_copy_symlink(entry, to.c_str());
        expect(archive_write_header(archive_, entry));
        if (!bytes.empty() && archive_write_data(archive_, bytes.data(), bytes.size()) < 0)
            expect(ARCHIVE_FATAL);
        archive_entry_free(entry);
        return *this;
    }
    void expect(int status) {
        if (status < ARCHIVE_WARN) throw std::runtime_error(archive_error_string(archive_));
    }

    archive* archive_;
};

} // namespace raylab
