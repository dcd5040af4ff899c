// Trees built on several threads are, byte for byte, those that one thread builds.
#include "labs/04_accel/builder/tasks.h"

#include "common/load/procedural/procedural.h"
#include "labs/04_accel/bvh/sah.h"
#include "labs/04_accel/kd/build.h"
#include "labs/04_accel/tests/cases.h"
#include "labs/04_accel/wide/tree.h"

#include <gtest/gtest.h>

#include <atomic>
#include <cstring>
#include <limits>
#include <memory>
#include <new>

namespace raylab::lab04 {

namespace {

struct NamedMesh {
    std::string name;
    std::vector<Triangle> triangles;
};

std::vector<NamedMesh> meshes() {
    std::vector<NamedMesh> all;
    for (const ProceduralMesh& kind : procedural_meshes()) {
        const Mesh mesh = kind.make(8000, 1);
        NamedMesh& made = all.emplace_back(NamedMesh{kind.name, {}});
        for (const MeshTriangle& t : mesh.triangles)
            add(made.triangles, mesh.positions[t.position[0]], mesh.positions[t.position[1]],
                mesh.positions[t.position[2]]);
    }
    // Here cuts make as many references as they may: no thread may take another's share.
    std::vector<Triangle> beams;
    Dice dice(3);
    for (int i = 0; i < 8000; ++i) {
        const Vec3 a = dice.point(-1, 1);
        add(beams, a, dice.point(-1, 1), a + dice.point(-0.01f, 0.01f));
    }
    all.push_back({"beams", beams});
    std::vector<Triangle> broken = hills(80);
    for (std::size_t i = 0; i < broken.size(); i += 7)
        broken[i].v[i % 3].y = std::numeric_limits<float>::quiet_NaN();
    all.push_back({"hills, every seventh triangle without a place", broken});
    return all;
}

template <class T> bool same_bytes(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

constexpr int thread_counts[] = {2, 3, 8};

TEST(Threads, BoxesAreTheSameFromAnyNumber) {
    for (const auto& [name, triangles] : meshes()) {
        const BvhTree one = build_bvh_sah(triangles, 1);
        for (const int threads : thread_counts) {
            SCOPED_TRACE(name + ", threads: " + std::to_string(threads));
            const BvhTree tree = build_bvh_sah(triangles, threads);
            EXPECT_TRUE(same_bytes(one.nodes, tree.nodes));
            EXPECT_TRUE(same_bytes(one.packs, tree.packs));
            EXPECT_EQ(one.depth, tree.depth);
        }
    }
}

TEST(Threads, KdTreesAreTheSameFromAnyNumber) {
    for (const auto& [name, triangles] : meshes()) {
        const KdTree one = build_kd_tree(triangles, {.threads = 1});
        for (const int threads : thread_counts) {
            SCOPED_TRACE(name + ", threads: " + std::to_string(threads));
            const KdTree tree = build_kd_tree(triangles, {.threads = threads});
            EXPECT_TRUE(same_bytes(one.nodes, tree.nodes));
            EXPECT_TRUE(same_bytes(one.packs, tree.packs));
            EXPECT_EQ(std::memcmp(&one.bounds, &tree.bounds, sizeof one.bounds), 0);
        }
    }
}

// A range of numbers as a tree: cut in halves, and at the numbers themselves something happens.
struct Range {
    int begin, end;
    const std::function<void(int)>* visit;
    std::unique_ptr<Range> half[2] = {};

    std::size_t size() const { return end - begin; }
    bool cut() {
        const int middle = begin + (end - begin) / 3;
        half[0].reset(new Range{begin, middle, visit});
        half[1].reset(new Range{middle, end, visit});
        return true;
    }
    void build() {
        for (int i = begin; i < end; ++i) (*visit)(i);
    }
};

TEST(Threads, EveryPieceIsBuiltOnce) {
    for (const int threads : {1, 2, 5}) {
        std::vector<std::atomic<int>> visits(100000);
        const std::function<void(int)> visit = [&](int i) { ++visits[i]; };
        Range all{0, 100000, &visit};
        build_in_pieces(all, threads);
        for (const auto& n : visits) ASSERT_EQ(n, 1);
        EXPECT_EQ(all.half[0] != nullptr, threads > 1);
    }
}

// Who meets it: the caller, or one of the other threads.
TEST(Threads, WhatATaskThrowsArrives) {
    for (const int threads : {1, 2, 5}) {
        for (const int bad : {0, 55555, 99999}) {
            const std::function<void(int)> visit = [&](int i) {
                if (i == bad) throw std::bad_alloc();
            };
            Range all{0, 100000, &visit};
            EXPECT_THROW(build_in_pieces(all, threads), std::bad_alloc);
        }
    }
}

TEST(Threads, TheLargestTaskIsBegunFirst) {
    BuildTasks tasks;
    std::vector<int> begun;
    for (const int size : {3, 9, 1, 7}) tasks.add(size, [&begun, size] { begun.push_back(size); });
    tasks.run(1);
    EXPECT_EQ(begun, (std::vector{9, 7, 3, 1}));
}

} // namespace

} // namespace raylab::lab04
