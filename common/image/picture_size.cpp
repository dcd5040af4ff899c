// A damaged or hostile header must not ask for all memory.
#include "common/image/decode.h"

#include <fmt/format.h>

namespace raylab {

void check_picture_size(std::int64_t width, std::int64_t height, std::size_t bytes_in_file,
                        PictureLimits limits) {
    if (width < 1 || height < 1)
        throw DecodeError(fmt::format("its header says {} x {} pixels", width, height));
    if (width > limits.side || height > limits.side || width * height > limits.pixels)
        throw DecodeError(fmt::format("its header says {} x {} pixels, and raylab reads at most {} "
                                      "a side and {} million in all",
                                      width, height, limits.side, limits.pixels >> 20));
    constexpr std::int64_t best_compression = 10000;
    if (static_cast<std::size_t>(width * height / best_compression) > bytes_in_file)
        throw DecodeError(fmt::format("its header says {} x {} pixels, far more than its {} bytes "
                                      "can hold",
                                      width, height, bytes_in_file));
}

} // namespace raylab
