// Writes Radiance HDR by stb.
#include "common/image/formats.h"

#include <stb/stb_image_write.h>

#include <cmath>

namespace raylab::formats {

// RGBE holds neither negative nor non-finite values: both become 0.
std::string encode_hdr(const Image& image) {
    std::vector<Vec3> clean = image.mean;
    for (Vec3& v : clean)
        for (int c = 0; c < 3; ++c) v[c] = std::isfinite(v[c]) && v[c] > 0 ? v[c] : 0.0f;
    std::string bytes;
    const auto append = [](void* out, void* data, int size) {
        static_cast<std::string*>(out)->append(static_cast<char*>(data),
                                               static_cast<std::size_t>(size));
    };
    stbi_write_hdr_to_func(append, &bytes, image.width, image.height, 3, &clean[0].x);
    return bytes;
}

} // namespace raylab::formats
