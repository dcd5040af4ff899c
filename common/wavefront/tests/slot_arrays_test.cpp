// A pool's arrays: what they take is counted from their declarations, and each is an allocation of
// its own.
#include "common/wavefront/path_pool.h"

#include <gtest/gtest.h>

namespace raylab {

namespace {

struct Odd : SlotArrays {
    using SlotArrays::SlotArrays;
    std::uint8_t* one = deal();
    double* none = deal(0);
    Vec3* three = deal(3);
    int* last = deal();
};

TEST(SlotArrays, AreDealtInTheOrderOfTheirDeclarations) {
    SlotMemory memory(7);
    const Odd odd(&memory);
    EXPECT_EQ(odd.capacity, 7);
    EXPECT_EQ(odd.bytes_per_slot, 1 + 3 * sizeof(Vec3) + sizeof(int));
    EXPECT_EQ(odd.none, nullptr);
    EXPECT_TRUE(odd.one != nullptr && odd.three != nullptr && odd.last != nullptr);
    std::vector<std::uintptr_t> starts = {reinterpret_cast<std::uintptr_t>(odd.one),
                                          reinterpret_cast<std::uintptr_t>(odd.three),
                                          reinterpret_cast<std::uintptr_t>(odd.last)};
    for (const std::uintptr_t start : starts) EXPECT_EQ(start % alignof(double), 0u);
}

// All of each array is device memory, zero at first, and no two share a byte.
TEST(SlotArrays, HaveTheirSize) {
    constexpr int slots = 5;
    SlotMemory memory(slots);
    const Odd odd(&memory);
    const auto filled = [](void* array, std::size_t bytes, int value) {
        std::vector<unsigned char> host(bytes);
        check(cudaMemcpy(host.data(), array, bytes, cudaMemcpyDeviceToHost), "reading");
        for (const unsigned char byte : host) EXPECT_EQ(byte, value);
    };
    filled(odd.one, slots, 0);
    filled(odd.three, 3 * slots * sizeof(Vec3), 0);
    check(cudaMemset(odd.one, 1, slots), "ones");
    check(cudaMemset(odd.three, 2, 3 * slots * sizeof(Vec3)), "twos");
    check(cudaMemset(odd.last, 3, slots * sizeof(int)), "threes");
    filled(odd.one, slots, 1);
    filled(odd.three, 3 * slots * sizeof(Vec3), 2);
    filled(odd.last, slots * sizeof(int), 3);
    EXPECT_NE(cudaMemset(odd.three, 2, 3 * slots * sizeof(Vec3) + 1), cudaSuccess)
        << "an array ends where its allocation does";
}

TEST(SlotArrays, WithoutMemoryTheyAreCountedOnly) {
    constexpr Odd odd(nullptr);
    static_assert(odd.bytes_per_slot == 1 + 3 * sizeof(Vec3) + sizeof(int));
    static_assert(odd.capacity == 0 && odd.three == nullptr);
}

// Every array of the pool, by what it takes.
TEST(PathPool, APathTakesWhatIsStated) {
    const PathPoolView p(0);
    const std::size_t path =
        sizeof *p.pixel + sizeof *p.bounce + sizeof *p.throughput + sizeof *p.radiance +
        sizeof *p.bsdf_pdf + sizeof *p.alive + sizeof *p.record + sizeof *p.origin +
        sizeof *p.direction + sizeof *p.hit + sizeof *p.shadow_ray_origin +
        sizeof *p.shadow_ray_direction + sizeof *p.shadow_ray_t_max + sizeof *p.shadow_ray_light;
    EXPECT_EQ(p.bytes_per_slot, path);
    EXPECT_EQ(PathPoolView(7).bytes_per_slot,
              path + sizeof *p.node + sizeof *p.pending + 7 * sizeof *p.stack);
    static_assert(std::is_trivially_copyable_v<PathPoolView>, "kernels get its bytes");
}

TEST(PathPool, OnlyTreesHaveAStack) {
    SlotMemory memory(3);
    EXPECT_EQ(PathPoolView(0, &memory).stack, nullptr);
    EXPECT_NE(PathPoolView(1, &memory).stack, nullptr);
}

} // namespace

} // namespace raylab
