#include "grader/submissions/archive.h"

#include "grader/results/text.h"
#include "grader/submissions/submission_error.h"
#include "grader/submissions/utf8_locale.h"

#include <archive.h>
#include <archive_entry.h>
#include <fmt/format.h>

#include <algorithm>
#include <memory>

namespace raylab {

namespace fs = std::filesystem;

namespace {

using Handle = std::unique_ptr<archive, decltype(&archive_read_free)>;

// No other format: the fewer parsers read hostile bytes, the better.
Handle reader() {
    Handle handle(archive_read_new(), archive_read_free);
    archive_read_support_format_zip(handle.get());
    archive_read_support_format_tar(handle.get());
    archive_read_support_filter_gzip(handle.get());
    archive_read_support_filter_bzip2(handle.get());
    archive_read_support_filter_xz(handle.get());
    archive_read_support_filter_zstd(handle.get());
    return handle;
}

// An archive that is open, with what has come out of it so far.
class Reading {
  public:
    Reading(archive* handle, std::string name, std::uint64_t packed, const UnpackLimits& limits)
        : handle_(handle), name_(std::move(name)), packed_(packed), limits_(limits) {}

    void expect(int status) const {
        if (status < ARCHIVE_WARN) fail_damaged();
    }

    void all(const TakeEntry& take) {
        archive_entry* header = nullptr;
        for (;;) {
            const int status = archive_read_next_header(handle_, &header);
            if (status == ARCHIVE_EOF) return;
            expect(status);
            if (++entries_ > limits_.entries)
                fail(fmt::format("it holds more than {} files; send only the lab's",
                                 limits_.entries));
            if (archive_entry_is_encrypted(header)) fail("it has a password; send it without one");
            one(header, take);
        }
    }

  private:
    void one(archive_entry* header, const TakeEntry& take) {
        Item item = item_of(header);
        // Where the header tells a size, a bomb ends before its first byte. Bytes that come are
        // counted as they come, whatever the header says.
        if (item.size > limits_.bytes - bytes_) fail_too_large();
        const Sink sink = take(item);
        if (!sink && archive_entry_size_is_set(header)) {
            count(item.size);
            expect(archive_read_data_skip(handle_));
            return;
        }
        const void* block = nullptr;
        std::size_t size = 0;
        la_int64_t offset = 0;
        for (;;) {
            const int status = archive_read_data_block(handle_, &block, &size, &offset);
            if (status == ARCHIVE_EOF) return;
            expect(status);
            count(size);
            if (!sink) continue;
            taken_ += size;
            if (taken_ > limits_.taken)
                fail(fmt::format("its sources and archives have more than {} bytes; send only the "
                                 "lab's files",
                                 limits_.taken));
            sink({static_cast<const char*>(block), size});
        }
    }

    Item item_of(archive_entry* header) const {
        const char* name = archive_entry_pathname_utf8(header);
        if (!name) name = archive_entry_pathname(header); // not UTF-8: its bytes as they are
        Item item = item_named(name ? name : "", limits_);
        if (item.kind == Item::Kind::hostile) return item;
        const auto type = archive_entry_filetype(header);
        if (type == AE_IFLNK || archive_entry_hardlink(header))
            item.kind = Item::Kind::link;
        else if (type == AE_IFDIR)
            item.kind = Item::Kind::folder;
        else if (type != AE_IFREG)
            item.kind = Item::Kind::special;
        item.size = static_cast<std::uint64_t>(std::max<la_int64_t>(0, archive_entry_size(header)));
        return item;
    }

    void count(std::uint64_t size) {
        bytes_ += size;
        if (bytes_ > limits_.bytes) fail_too_large();
        constexpr std::uint64_t anything_goes = 32u << 20;
        if (bytes_ > anything_goes && bytes_ / limits_.ratio > packed_)
            fail(fmt::format("it unpacks to more than {} times its size; send only the lab's files",
                             limits_.ratio));
    }

    [[noreturn]] void fail_too_large() const {
        fail(fmt::format("it unpacks to more than {} bytes; send only the lab's files",
                         limits_.bytes));
    }
    [[noreturn]] void fail_damaged() const {
        const char* words = archive_error_string(handle_);
        fail(fmt::format("it is damaged, or no zip or tar ({}); pack it again",
                         words ? clean_utf8(words) : "no further word"));
    }
    [[noreturn]] void fail(const std::string& why) const {
        throw SubmissionError(fmt::format("the archive '{}' is not read: {}", name_, why));
    }

    archive* handle_;
    std::string name_;
    std::uint64_t packed_, bytes_ = 0, taken_ = 0, entries_ = 0;
    UnpackLimits limits_;
};

} // namespace

void read_archive(const fs::path& file, const std::string& name, const UnpackLimits& limits,
                  const TakeEntry& take) {
    const Utf8Locale names;
    const Handle handle = reader();
    Reading reading(handle.get(), name, fs::file_size(file), limits);
    reading.expect(archive_read_open_filename(handle.get(), file.c_str(), 1 << 16));
    reading.all(take);
}

void read_archive_bytes(std::string_view bytes, const std::string& name, const UnpackLimits& limits,
                        const TakeEntry& take) {
    const Utf8Locale names;
    const Handle handle = reader();
    Reading reading(handle.get(), name, bytes.size(), limits);
    reading.expect(archive_read_open_memory(handle.get(), bytes.data(), bytes.size()));
    reading.all(take);
}

} // namespace raylab
