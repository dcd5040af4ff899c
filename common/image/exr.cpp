// OpenEXR: float channels R, G, B, and variance.R, variance.G, variance.B (of the mean) where
// known. Provenance is in attributes of the header, so that `exrheader` and other programs show it.
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

#include <charconv>
#include <cstring>

namespace raylab::formats {
namespace {

constexpr const char* mean_channels[] = {"R", "G", "B"};
constexpr const char* variance_channels[] = {"variance.R", "variance.G", "variance.B"};

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
Imf::Slice slice(const Vec3* pixels, int c, int width, Imath::V2i origin) {
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

    Imf::FrameBuffer frame;
    for (int c = 0; c < 3; ++c) {
        header.channels().insert(mean_channels[c], Imf::Channel(Imf::FLOAT));
        frame.insert(mean_channels[c], slice(image.mean.data(), c, image.width, {0, 0}));
        if (image.variance.empty()) continue;
        header.channels().insert(variance_channels[c], Imf::Channel(Imf::FLOAT));
        frame.insert(variance_channels[c], slice(image.variance.data(), c, image.width, {0, 0}));
    }
    std::string bytes;
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
    const bool with_variance = has_channels(header, variance_channels);
    if (with_variance) image.variance.resize(image.pixels());

    Imf::FrameBuffer frame;
    for (int c = 0; c < 3; ++c) {
        frame.insert(mean_channels[c], slice(image.mean.data(), c, image.width, window.min));
        if (with_variance)
            frame.insert(variance_channels[c],
                         slice(image.variance.data(), c, image.width, window.min));
    }
    file.setFrameBuffer(frame);
    file.readPixels(window.min.y, window.max.y);

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
