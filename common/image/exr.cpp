// OpenEXR: float channels R, G, B, and variance.R, variance.G, variance.B (of the mean) where
// known. Where a variance does not fit into float, because radiance is above 1e19 or below 1e-19,
// the channels are standard_error.R, .G and .B instead. Provenance is in attributes of the header,
// so that `exrheader` and other programs show it.
#include "common/image/formats.h"

#include <ImfArray.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>
#include <ImfIntAttribute.h>
#include <ImfOutputFile.h>
#include <ImfStringAttribute.h>

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

namespace raylab::formats {
namespace {

constexpr const char* mean_channels[] = {"R", "G", "B"};
constexpr const char* variance_channels[] = {"variance.R", "variance.G", "variance.B"};
constexpr const char* error_channels[] = {"standard_error.R", "standard_error.G",
                                          "standard_error.B"};

// OpenEXR's streams over bytes in memory: files are read and written whole, in one place.
class MemoryOut : public Imf::OStream {
  public:
    explicit MemoryOut(std::string& bytes) : OStream("memory"), bytes_(bytes) {}
    void write(const char* data, int n) override {
        const std::size_t end = at_ + static_cast<std::size_t>(n);
        if (bytes_.size() < end) bytes_.resize(end);
        std::memcpy(bytes_.data() + at_, data, static_cast<std::size_t>(n));
        at_ = end;
    }
    decltype(std::declval<Imf::OStream>().tellp()) tellp() override { return at_; }
    void seekp(decltype(std::declval<Imf::OStream>().tellp()) at) override { at_ = at; }

  private:
    std::string& bytes_;
    std::size_t at_ = 0;
};

class MemoryIn : public Imf::IStream {
  public:
    explicit MemoryIn(const std::string& bytes) : IStream("memory"), bytes_(bytes) {}
    bool read(char* data, int n) override {
        if (n < 0 || at_ > bytes_.size() || static_cast<std::size_t>(n) > bytes_.size() - at_)
            throw std::runtime_error("it ends too early");
        std::memcpy(data, bytes_.data() + at_, static_cast<std::size_t>(n));
        at_ += static_cast<std::size_t>(n);
        return at_ < bytes_.size();
    }
    decltype(std::declval<Imf::IStream>().tellg()) tellg() override { return at_; }
    void seekg(decltype(std::declval<Imf::IStream>().tellg()) at) override { at_ = at; }

  private:
    const std::string& bytes_;
    std::size_t at_ = 0;
};

// Where OpenEXR finds channel c of an array of Vec3 that starts at pixel (0, 0) = `origin`.
Imf::Slice slice(const Vec3* pixels, int c, int width, const Imath::V2i& origin) {
    const std::ptrdiff_t before =
        (std::ptrdiff_t(origin.y) * width + origin.x) * std::ptrdiff_t(sizeof(Vec3));
    char* base = reinterpret_cast<char*>(const_cast<Vec3*>(pixels)) +
                 sizeof(float) * static_cast<std::size_t>(c);
    return Imf::Slice(Imf::FLOAT, base - before, sizeof(Vec3),
                      sizeof(Vec3) * static_cast<std::size_t>(width));
}

void put(Imf::Header& header, const char* name, const std::string& value) {
    if (!value.empty()) header.insert(name, Imf::StringAttribute(value));
}

std::string get_string(const Imf::Header& header, const char* name) {
    const auto* found = header.findTypedAttribute<Imf::StringAttribute>(name);
    return found ? found->value() : "";
}

int get_int(const Imf::Header& header, const char* name) {
    const auto* found = header.findTypedAttribute<Imf::IntAttribute>(name);
    return found ? found->value() : 0;
}

// Whether the file has all three channels, each at every pixel.
bool has_channels(const Imf::Header& header, const char* const (&names)[3]) {
    for (const char* name : names) {
        const Imf::Channel* channel = header.channels().findChannel(name);
        if (!channel || channel->xSampling != 1 || channel->ySampling != 1) return false;
    }
    return true;
}

// f(v) of every channel of every pixel.
template <class F> std::vector<Vec3> each(const std::vector<Vec3>& pixels, F f) {
    std::vector<Vec3> result;
    result.reserve(pixels.size());
    for (const Vec3& v : pixels) result.emplace_back(f(v.x), f(v.y), f(v.z));
    return result;
}

float square(float v) { return v * v; }
float root(float v) { return std::sqrt(v); }

// Whether the roots of the squares are the same bits: so they are unless a square leaves the range
// of float, because both operations round correctly.
bool squares_tell_all(const std::vector<Vec3>& error) {
    const auto same = [](float v) {
        return std::bit_cast<std::uint32_t>(root(square(v))) == std::bit_cast<std::uint32_t>(v);
    };
    return std::all_of(error.begin(), error.end(),
                       [&](const Vec3& v) { return same(v.x) && same(v.y) && same(v.z); });
}

} // namespace

std::string encode_exr(const Image& image) {
    Imf::Header header(image.width, image.height);
    header.compression() = Imf::ZIP_COMPRESSION;
    const Provenance& from = image.provenance;
    put(header, "scene", from.scene);
    put(header, "scene_hash", from.scene_hash);
    put(header, "integrator", from.integrator);
    put(header, "renderer", from.renderer);
    put(header, "seed", fmt::format("{}", from.seed)); // unsigned: EXR's own integers are signed
    header.insert("spp", Imf::IntAttribute(from.spp));
    header.insert("max_depth", Imf::IntAttribute(from.max_depth));

    const bool as_variance = squares_tell_all(image.error);
    const std::vector<Vec3> variance =
        as_variance ? each(image.error, square) : std::vector<Vec3>();
    const std::vector<Vec3>& noise = as_variance ? variance : image.error;
    const auto& noise_channels = as_variance ? variance_channels : error_channels;
    Imf::FrameBuffer frame;
    for (int c = 0; c < 3; ++c) {
        header.channels().insert(mean_channels[c], Imf::Channel(Imf::FLOAT));
        frame.insert(mean_channels[c], slice(image.mean.data(), c, image.width, {0, 0}));
        if (noise.empty()) continue;
        header.channels().insert(noise_channels[c], Imf::Channel(Imf::FLOAT));
        frame.insert(noise_channels[c], slice(noise.data(), c, image.width, {0, 0}));
    }
    std::string bytes;
    bytes.reserve((image.error.empty() ? 12 : 24) * image.pixels() + (1 << 16)); // never grows
    MemoryOut out(bytes);
    {
        Imf::OutputFile file(out, header);
        file.setFrameBuffer(frame);
        file.writePixels(image.height);
    } // the destructor writes the line offset table
    return bytes;
}

Image decode_exr(const std::string& bytes) {
    // A limit inside OpenEXR itself: it sizes its buffers from the header before we can look.
    Imf::Header::setMaxImageSize(max_image_side, max_image_side);
    Imf::Header::setMaxTileSize(max_image_side, max_image_side);
    MemoryIn in(bytes);
    Imf::InputFile file(in);
    const Imf::Header& header = file.header();
    if (!has_channels(header, mean_channels))
        throw std::runtime_error("it has no channels R, G and B");

    const Imath::Box2i window = header.dataWindow();
    Image image = allocate(std::int64_t(window.max.x) - window.min.x + 1,
                           std::int64_t(window.max.y) - window.min.y + 1, bytes.size());
    const bool with_error = has_channels(header, error_channels);
    const bool with_variance = !with_error && has_channels(header, variance_channels);
    if (with_error || with_variance) image.error.resize(image.pixels());

    Imf::FrameBuffer frame;
    for (int c = 0; c < 3; ++c) {
        frame.insert(mean_channels[c], slice(image.mean.data(), c, image.width, window.min));
        if (with_error || with_variance)
            frame.insert(with_error ? error_channels[c] : variance_channels[c],
                         slice(image.error.data(), c, image.width, window.min));
    }
    file.setFrameBuffer(frame);
    file.readPixels(window.min.y, window.max.y);
    if (with_variance) image.error = each(image.error, root);

    Provenance& from = image.provenance;
    from.scene = get_string(header, "scene");
    from.scene_hash = get_string(header, "scene_hash");
    from.integrator = get_string(header, "integrator");
    from.renderer = get_string(header, "renderer");
    const std::string seed = get_string(header, "seed");
    std::from_chars(seed.data(), seed.data() + seed.size(), from.seed);
    from.spp = get_int(header, "spp");
    from.max_depth = get_int(header, "max_depth");
    return image;
}

} // namespace raylab::formats
