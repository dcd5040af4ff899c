// What a program prints, cut in the middle: its head and its tail.
#pragma once

#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>

namespace raylab::sandbox {

class Capture {
  public:
    // `whole`: nothing is cut; the caller limits what is printed.
    explicit Capture(bool whole = false) : kept_(whole ? ~std::size_t(0) / 4 : 32 << 10) {}
    void add(std::string_view bytes) {
        total_ += bytes.size();
        const std::size_t room = std::min(bytes.size(), kept_ - head_.size());
        head_ += bytes.substr(0, room);
        tail_ += bytes.substr(room);
        if (tail_.size() > 2 * kept_) tail_.erase(0, tail_.size() - kept_);
    }
    std::uint64_t total() const { return total_; }
    std::string text() const {
        if (total_ <= 2 * kept_) return head_ + tail_;
        return head_ + "\n[... cut here ...]\n" + tail_.substr(tail_.size() - kept_);
    }

  private:
    std::size_t kept_; // of the head, and of the tail
    std::string head_, tail_;
    std::uint64_t total_ = 0;
};

} // namespace raylab::sandbox
