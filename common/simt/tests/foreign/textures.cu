// Textures and surfaces, against the formulas of the programming guide's appendix "Texture
// Fetching".
#include "common/simt/tests/settings.h"

using namespace raylab::simt;

#include <cmath>

namespace {

// A texture of the given numbers, in an array of one to three dimensions.
template <class T> class Texture {
  public:
    Texture(const std::vector<T>& texels, size_t width, size_t height, size_t depth,
            cudaTextureDesc description) {
        auto channels = cudaCreateChannelDesc<T>();
        check(cudaMalloc3DArray(&array_, &channels, make_cudaExtent(width, height, depth)),
              "array");
        cudaMemcpy3DParms copy = {};
        height = std::max<size_t>(height, 1);
        copy.srcPtr =
            make_cudaPitchedPtr(const_cast<T*>(texels.data()), width * sizeof(T), width, height);
        copy.dstArray = array_;
        copy.extent = make_cudaExtent(width, height, std::max<size_t>(depth, 1));
        copy.kind = cudaMemcpyHostToDevice;
        check(cudaMemcpy3D(&copy), "copy");
        cudaResourceDesc resource = {};
        resource.resType = cudaResourceTypeArray;
        resource.res.array.array = array_;
        check(cudaCreateTextureObject(&object, &resource, &description, nullptr), "texture");
    }
    ~Texture() {
        cudaDestroyTextureObject(object);
        cudaFreeArray(array_);
    }
    Texture(const Texture&) = delete;
    Texture& operator=(const Texture&) = delete;

    cudaTextureObject_t object = 0;

  private:
    cudaArray_t array_ = nullptr;
};

cudaTextureDesc described(cudaTextureFilterMode filter, cudaTextureAddressMode mode,
                          bool normalised) {
    cudaTextureDesc description = {};
    for (auto& axis : description.addressMode) axis = mode;
    description.filterMode = filter;
    description.readMode = cudaReadModeElementType;
    description.normalizedCoords = normalised;
    return description;
}

__global__ void read_line(cudaTextureObject_t texture, const float* at, float* out, int n) {
    int i = blockIdx.x * blockDim.x + threadIdx.x;
    if (i < n) out[i] = tex1D<float>(texture, at[i]);
}

std::vector<float> line(const Texture<float>& texture, const std::vector<float>& at) {
    DeviceArray<float> positions(at), out(at.size());
    read_line<<<1, 256>>>(texture.object, positions.data(), out.data(), int(at.size()));
    return out.host();
}

__global__ void read_plane(cudaTextureObject_t texture, float* out, float step) {
    float x = threadIdx.x * step, y = threadIdx.y * step;
    out[threadIdx.y * blockDim.x + threadIdx.x] = tex2D<float>(texture, x, y);
}

__global__ void read_box(cudaTextureObject_t texture, float* out) {
    *out = tex3D<float>(texture, 1.25f, 1.5f, 1.0f);
}

__global__ void read_bytes(cudaTextureObject_t texture, float4* normalised) {
    *normalised = tex2D<float4>(texture, 0.5f, 0.5f);
}

__global__ void read_elements(cudaTextureObject_t texture, int* out) {
    out[threadIdx.x] = tex1Dfetch<int>(texture, int(threadIdx.x) - 1);
}

__global__ void turn(cudaSurfaceObject_t from, cudaSurfaceObject_t to, int width, int height) {
    int x = threadIdx.x, y = threadIdx.y;
    if (x >= width || y >= height) return;
    uchar4 v = surf2Dread<uchar4>(from, x * 4, y);
    uchar4 again;
    surf2Dread(&again, from, x * 4, y);
    uchar4 none = surf2Dread<uchar4>(from, width * 4, y, cudaBoundaryModeZero);
    v.w = (unsigned char)(again.x + none.x);
    surf2Dwrite(v, to, y * 4, x);
}

} // namespace

TEST(Textures, PointsGiveTheTexelThatHoldsThem) {
    const std::vector<float> texels = {10, 20, 30, 40};
    const float x[] = {-5, -0.1f, 0, 0.99f, 1, 2.5f, 3.99f, 4, 9};
    std::vector<float> at(x, x + 9);
    for (auto mode : {cudaAddressModeClamp, cudaAddressModeWrap}) { // wrap needs normalised ones
        Texture<float> texture(texels, 4, 0, 0, described(cudaFilterModePoint, mode, false));
        EXPECT_EQ(line(texture, at), (std::vector<float>{10, 10, 10, 10, 20, 30, 40, 40, 40}));
    }
    Texture<float> border(texels, 4, 0, 0,
                          described(cudaFilterModePoint, cudaAddressModeBorder, false));
    EXPECT_EQ(line(border, at), (std::vector<float>{0, 0, 10, 10, 20, 30, 40, 0, 0}));
}

TEST(Textures, NormalisedCoordinatesWrapAndMirror) {
    const std::vector<float> texels = {10, 20, 30, 40};
    const std::vector<float> at = {-0.1f, 0.1f, 0.3f, 0.6f, 0.9f, 1.1f, 1.4f, 2.1f, -1.1f};
    Texture<float> wrap(texels, 4, 0, 0, described(cudaFilterModePoint, cudaAddressModeWrap, true));
    EXPECT_EQ(line(wrap, at), (std::vector<float>{40, 10, 20, 30, 40, 10, 20, 10, 40}));
    Texture<float> mirror(texels, 4, 0, 0,
                          described(cudaFilterModePoint, cudaAddressModeMirror, true));
    EXPECT_EQ(line(mirror, at), (std::vector<float>{10, 10, 20, 30, 40, 40, 30, 10, 40}));
    Texture<float> clamp(texels, 4, 0, 0,
                         described(cudaFilterModePoint, cudaAddressModeClamp, true));
    EXPECT_EQ(line(clamp, at), (std::vector<float>{10, 10, 20, 30, 40, 40, 40, 40, 10}));
}

// tex(x) = (1 - a) T[i] + a T[i + 1], i = floor(x - 0.5), a = frac(x - 0.5) in 8 bits.
TEST(Textures, LinearFilteringMixesWithEightBits) {
    const std::vector<float> texels = {0, 256, 1024, 512};
    Texture<float> texture(texels, 4, 0, 0,
                           described(cudaFilterModeLinear, cudaAddressModeClamp, false));
    std::vector<float> at;
    for (int i = 0; i < 240; ++i) at.push_back(i / 53.0f);
    auto got = line(texture, at);
    for (size_t i = 0; i < at.size(); ++i) {
        double x = at[i] - 0.5, first = std::floor(x), a = x - first;
        auto texel = [&](double index) { return texels[size_t(std::clamp(index, 0.0, 3.0))]; };
        double exact = (1 - a) * texel(first) + a * texel(first + 1);
        double slope = std::abs(texel(first + 1) - texel(first));
        ASSERT_NEAR(got[i], exact, slope / 512 + 1e-3) << at[i]; // half of the last bit
        double steps = got[i] - texel(first);
        if (slope > 0) {
            ASSERT_EQ(std::fmod(std::abs(steps) / slope * 256, 1), 0) << at[i];
        }
    }
}

TEST(Textures, PlanesAndBoxesAreFilteredInEveryDirection) {
    // A linear function is its own interpolation, inside of the texels' centres.
    std::vector<float> plane(16), box(27);
    for (int y = 0; y < 4; ++y)
        for (int x = 0; x < 4; ++x) plane[y * 4 + x] = float(3 * x + 5 * y);
    for (int i = 0; i < 27; ++i) box[i] = float(i % 3 + 10 * (i / 3 % 3) + 100 * (i / 9));
    Texture<float> texture(plane, 4, 4, 0,
                           described(cudaFilterModeLinear, cudaAddressModeClamp, false));
    DeviceArray<float> out(64);
    read_plane<<<1, dim3(8, 8)>>>(texture.object, out.data(), 0.5f);
    auto got = out.host();
    for (int y = 0; y < 8; ++y)
        for (int x = 0; x < 8; ++x)
            EXPECT_EQ(got[y * 8 + x], 3 * std::clamp(x * 0.5f - 0.5f, 0.0f, 3.0f) +
                                          5 * std::clamp(y * 0.5f - 0.5f, 0.0f, 3.0f));
    Texture<float> solid(box, 3, 3, 3,
                         described(cudaFilterModeLinear, cudaAddressModeClamp, false));
    read_box<<<1, 1>>>(solid.object, out.data());
    EXPECT_EQ(out.host()[0], 0.75f + 10 * 1.0f + 100 * 0.5f);
}

TEST(Textures, BytesMayBeReadAsFractions) {
    auto description = described(cudaFilterModeLinear, cudaAddressModeClamp, false);
    description.readMode = cudaReadModeNormalizedFloat;
    Texture<uchar4> texture({make_uchar4(0, 51, 255, 128)}, 1, 1, 0, description);
    DeviceArray<float4> out(1);
    read_bytes<<<1, 1>>>(texture.object, out.data());
    float4 v = out.host()[0];
    EXPECT_EQ(v.x, 0);
    EXPECT_EQ(v.y, 0.2f);
    EXPECT_EQ(v.z, 1);
    EXPECT_EQ(v.w, 128 / 255.0f);
}

TEST(Textures, LinearMemoryIsFetchedByIndex) {
    DeviceArray<int> memory({5, 6, 7});
    cudaResourceDesc resource = {};
    resource.resType = cudaResourceTypeLinear;
    resource.res.linear.devPtr = memory.data();
    resource.res.linear.desc = cudaCreateChannelDesc<int>();
    resource.res.linear.sizeInBytes = 12;
    cudaTextureDesc description = {};
    cudaTextureObject_t texture = 0;
    ASSERT_EQ(cudaCreateTextureObject(&texture, &resource, &description, nullptr), cudaSuccess);
    DeviceArray<int> out(5);
    read_elements<<<1, 5>>>(texture, out.data());
    EXPECT_EQ(out.host(), (std::vector<int>{0, 5, 6, 7, 0}));
    EXPECT_EQ(cudaDestroyTextureObject(texture), cudaSuccess);
}

TEST(Surfaces, AreReadAndWrittenByBytes) {
    constexpr int width = 3, height = 2;
    std::vector<uchar4> in(width * height), out(width * height);
    for (int i = 0; i < width * height; ++i) in[i] = make_uchar4(i, 10 + i, 20 + i, 30 + i);
    auto channels = cudaCreateChannelDesc<uchar4>();
    cudaArray_t arrays[2];
    cudaSurfaceObject_t surfaces[2];
    for (int i = 0; i < 2; ++i) {
        size_t w = i ? height : width, h = i ? width : height;
        ASSERT_EQ(cudaMallocArray(&arrays[i], &channels, w, h, cudaArraySurfaceLoadStore),
                  cudaSuccess);
        cudaResourceDesc resource = {};
        resource.resType = cudaResourceTypeArray;
        resource.res.array.array = arrays[i];
        ASSERT_EQ(cudaCreateSurfaceObject(&surfaces[i], &resource), cudaSuccess);
    }
    ASSERT_EQ(cudaMemcpy2DToArray(arrays[0], 0, 0, in.data(), width * 4, width * 4, height,
                                  cudaMemcpyHostToDevice),
              cudaSuccess);
    turn<<<1, dim3(4, 4)>>>(surfaces[0], surfaces[1], width, height);
    ASSERT_EQ(cudaMemcpy2DFromArray(out.data(), height * 4, arrays[1], 0, 0, height * 4, width,
                                    cudaMemcpyDeviceToHost),
              cudaSuccess);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            uchar4 v = out[x * height + y];
            EXPECT_EQ(v.y, 10 + y * width + x);
            EXPECT_EQ(v.w, y * width + x);
        }
    for (int i = 0; i < 2; ++i) {
        EXPECT_EQ(cudaDestroySurfaceObject(surfaces[i]), cudaSuccess);
        EXPECT_EQ(cudaFreeArray(arrays[i]), cudaSuccess);
    }
}

namespace {

texture<float> line_reference;
texture<float, 2> plane_reference;
texture<uchar4, cudaTextureType2D, cudaReadModeNormalizedFloat> bytes_reference;

__global__ void read_references(float* out) {
    out[0] = tex1Dfetch(line_reference, 2);
    out[1] = tex2D(plane_reference, 1, 1);
    out[2] = tex2D(bytes_reference, 0.5f, 0.5f).y;
}

} // namespace

// As the programming guide of CUDA 4 and the books have them.
TEST(Textures, ReferencesAreBoundToMemory) {
    DeviceArray<float> memory({1, 2, 3, 4}), out(3);
    auto channels = cudaCreateChannelDesc<float>();
    ASSERT_EQ(cudaBindTexture(nullptr, line_reference, memory.data(), 16), cudaSuccess);
    ASSERT_EQ(cudaBindTexture2D(nullptr, plane_reference, memory.data(), channels, 2, 2, 8),
              cudaSuccess);
    auto bytes = cudaCreateChannelDesc<uchar4>();
    cudaArray_t array;
    uchar4 texel = make_uchar4(0, 255, 0, 0);
    ASSERT_EQ(cudaMallocArray(&array, &bytes, 1, 1), cudaSuccess);
    ASSERT_EQ(cudaMemcpyToArray(array, 0, 0, &texel, 4, cudaMemcpyHostToDevice), cudaSuccess);
    ASSERT_EQ(cudaBindTextureToArray(bytes_reference, array), cudaSuccess);
    read_references<<<1, 1>>>(out.data());
    EXPECT_EQ(out.host(), (std::vector<float>{3, 4, 1}));
    EXPECT_EQ(cudaUnbindTexture(line_reference), cudaSuccess);
    EXPECT_EQ(cudaUnbindTexture(plane_reference), cudaSuccess);
    EXPECT_EQ(cudaUnbindTexture(bytes_reference), cudaSuccess);
    EXPECT_EQ(cudaFreeArray(array), cudaSuccess);
}
