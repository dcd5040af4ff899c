// What the watch counts and knows, against counts by hand: sectors and bank conflicts of known
// patterns, and the order that barriers, fences and atomics make between threads, and streams and
// events between launches.
#include "common/simt/watch/block_clock.h"
#include "common/simt/watch/stream_order.h"
#include "common/simt/watch/traffic.h"

#include <gtest/gtest.h>

namespace raylab::simt::watch {
namespace {

// One warp, lane l at first + stride * l.
Traffic one_request(Memory memory, uintptr_t first, uintptr_t stride, unsigned bytes,
                    int lanes = 32) {
    TrafficCounter counter;
    for (int lane = 0; lane < lanes; ++lane)
        counter.add(1, lane, first + stride * uintptr_t(lane), bytes, false, memory);
    counter.end_block();
    return counter.by_site().at(1);
}

TEST(Traffic, SectorsOfKnownPatterns) {
    EXPECT_EQ(one_request(Memory::global, 4096, 4, 4).sectors, 4u) << "32 floats side by side";
    EXPECT_EQ(one_request(Memory::global, 4100, 4, 4).sectors, 5u) << "shifted by one float";
    EXPECT_EQ(one_request(Memory::global, 4096, 32, 4).sectors, 32u) << "one float of each struct";
    EXPECT_EQ(one_request(Memory::global, 4096, 12, 4).sectors, 12u) << "x of float3";
    EXPECT_EQ(one_request(Memory::global, 4096, 16, 16).sectors, 16u) << "float4";
    EXPECT_EQ(one_request(Memory::global, 4096, 0, 4).sectors, 1u) << "all read one float";
}

TEST(Traffic, ThreadsOfAWarpThatTakePart) {
    const Traffic half = one_request(Memory::global, 4096, 4, 4, 16);
    EXPECT_EQ(half.requests, 1u);
    EXPECT_DOUBLE_EQ(half.active_threads(), 16);
    // A loop of l rounds in lane l: request r has the lanes above r.
    TrafficCounter counter;
    for (int lane = 0; lane < 32; ++lane)
        for (int round = 0; round < lane; ++round)
            counter.add(1, lane, 4096, 4, false, Memory::global);
    counter.end_block();
    EXPECT_EQ(counter.by_site().at(1).requests, 31u);
    EXPECT_DOUBLE_EQ(counter.by_site().at(1).active_threads(), 16) << "(1 + ... + 31) / 31";
}

TEST(Traffic, BankConflictsOfKnownPatterns) {
    const auto conflicts = [](uintptr_t stride, unsigned bytes = 4) {
        return one_request(Memory::shared, 4096, stride, bytes).bank_conflicts();
    };
    EXPECT_EQ(conflicts(4), 0u);
    EXPECT_EQ(conflicts(8), 1u) << "every second word: two words a bank";
    EXPECT_EQ(conflicts(128), 31u) << "a column of 32 floats";
    EXPECT_EQ(conflicts(132), 0u) << "a column of 33 floats";
    EXPECT_EQ(conflicts(0), 0u) << "a broadcast";
}

struct Order : testing::Test {
    BlockClock clock;
    Order() {
        clock.begin_launch();
        clock.begin_block(3, 64);
    }
    bool knows(int thread, int other, Time time) {
        return clock.knows(thread, clock.task(other), time);
    }
};

TEST_F(Order, OnlyABarrierOrdersTheThreadsOfABlock) {
    const Time time = clock.now(40);
    EXPECT_TRUE(knows(40, 40, time));
    EXPECT_FALSE(knows(0, 40, time));
    clock.barrier();
    EXPECT_TRUE(knows(0, 40, time));
    EXPECT_FALSE(knows(0, 40, clock.now(40))) << "what comes after the barrier";
}

TEST_F(Order, LanesThatMeetKnowWhatEachOtherKnew) {
    const Time of_one = clock.now(1), of_two = clock.now(2), of_four = clock.now(4);
    clock.meet(0, 0b00110); // lanes 1 and 2
    EXPECT_TRUE(knows(1, 2, of_two) && knows(2, 1, of_one));
    EXPECT_FALSE(knows(4, 1, of_one));
    clock.meet(0, 0b10100); // lanes 2 and 4
    EXPECT_TRUE(knows(4, 1, of_one)) << "by way of lane 2";
    EXPECT_FALSE(knows(1, 4, of_four));
}

TEST_F(Order, AFlagPublishesWhatWasFencedBefore) {
    const Task writer = clock.task(5);
    const Time before = clock.now(5);
    clock.publish(5, 4096); // without a fence: nothing
    clock.fence(5);
    const Time after_fence = clock.now(5);
    clock.publish(5, 8192);
    clock.begin_block(4, 64);
    clock.pick_up(0, 4096);
    EXPECT_FALSE(clock.knows(0, writer, before));
    clock.pick_up(0, 8192);
    EXPECT_TRUE(clock.knows(0, writer, before));
    EXPECT_FALSE(clock.knows(0, writer, after_fence)) << "not fenced";
    EXPECT_FALSE(clock.knows(1, writer, before)) << "thread 1 has not looked";
    clock.barrier();
    EXPECT_TRUE(clock.knows(1, writer, before)) << "a barrier hands it on";
}

TEST_F(Order, AFenceOfAllThreadsBeforeABarrierCountsForTheBlock) {
    const Task other = clock.task(63);
    const Time time = clock.now(63);
    for (int thread = 0; thread < 64; ++thread) clock.fence(thread);
    clock.barrier();
    clock.publish(0, 4096);
    clock.begin_block(4, 64);
    clock.pick_up(0, 4096);
    EXPECT_TRUE(clock.knows(0, other, time));
}

// A read that was looked at once is not looked at again under one stamp: whatever lets others know
// of it, or lets its thread know more, must give a new one.
TEST_F(Order, AStampLastsUntilSomethingNewCanBeKnown) {
    const auto renews = [&](int thread, const auto& event) {
        const Stamp before = clock.stamp(thread);
        event();
        return clock.stamp(thread) != before;
    };
    EXPECT_NE(clock.stamp(0), clock.stamp(1));
    EXPECT_FALSE(renews(0, [&] { clock.meet(1, ~0u); })) << "the other warp's lanes";
    EXPECT_TRUE(renews(0, [&] { clock.meet(0, 0b11); }));
    EXPECT_TRUE(renews(0, [&] { clock.fence(0); }));
    EXPECT_FALSE(renews(1, [&] { clock.publish(0, 4096); }));
    EXPECT_FALSE(renews(1, [&] { clock.pick_up(1, 8192); })) << "nothing is published there";
    EXPECT_TRUE(renews(1, [&] { clock.pick_up(1, 4096); }));
    EXPECT_TRUE(renews(63, [&] { clock.barrier(); }));
    EXPECT_TRUE(renews(63, [&] { clock.begin_block(4, 64); }));
}

TEST_F(Order, AWarpHasAStampWhileItsLanesKnowTheSame) {
    EXPECT_NE(clock.warp_stamp(0), clock.warp_stamp(32));
    EXPECT_EQ(clock.warp_stamp(0), clock.warp_stamp(31));
    const Stamp first = clock.warp_stamp(0);
    clock.meet(0, 0b11);
    EXPECT_EQ(clock.warp_stamp(0), no_stamp) << "lane 2 does not know what lanes 0 and 1 do";
    EXPECT_NE(clock.warp_stamp(32), no_stamp);
    clock.meet(0, ~0u);
    EXPECT_TRUE(clock.warp_stamp(0) != no_stamp && clock.warp_stamp(0) != first);
    clock.fence(7);
    EXPECT_EQ(clock.warp_stamp(0), no_stamp) << "what lane 7 did can be known, lane 8's cannot";
    clock.barrier();
    EXPECT_NE(clock.warp_stamp(0), no_stamp);
    clock.fence(40);
    clock.publish(40, 4096);
    clock.pick_up(3, 4096);
    EXPECT_EQ(clock.warp_stamp(0), no_stamp);
}

struct Streams : testing::Test {
    StreamOrder order;
    const char handles[4] = {};
    StreamOrder::Stream one = handles, two = handles + 1, apart = handles + 2;
    StreamOrder::Event event = handles + 3;
    Streams() {
        order.create(one, true);
        order.create(two, true);
        order.create(apart, false); // non-blocking
    }
    Operation issue(StreamOrder::Stream stream) { return order.issue(stream, {"k", "f.cu", 1}); }
};

TEST_F(Streams, KeepTheirOwnOrderAndNoOther) {
    const Operation first = issue(one);
    EXPECT_FALSE(order.host_knows(first) || order.host_knows_all());
    issue(one);
    EXPECT_TRUE(order.running_knows(first) && order.running_knows_all());
    issue(two);
    EXPECT_FALSE(order.running_knows(first) || order.running_knows_all());
}

TEST_F(Streams, TheDefaultStreamAndTheOthersWaitForEachOtherUnlessNonBlocking) {
    const Operation in_one = issue(one), in_apart = issue(apart);
    const Operation in_default = issue(nullptr);
    EXPECT_TRUE(order.running_knows(in_one));
    EXPECT_FALSE(order.running_knows(in_apart));
    issue(two);
    EXPECT_TRUE(order.running_knows(in_default) && order.running_knows(in_one));
    issue(apart);
    EXPECT_FALSE(order.running_knows(in_default));
}

TEST_F(Streams, AnEventOrdersWhatWasBeforeItAlone) {
    const Operation before = issue(one);
    order.record(event, one);
    const Operation behind = issue(one);
    order.wait(two, event);
    issue(two);
    EXPECT_TRUE(order.running_knows(before));
    EXPECT_FALSE(order.running_knows(behind));
    order.host_waits_for_event(event);
    EXPECT_TRUE(order.host_knows(before));
    EXPECT_FALSE(order.host_knows(behind));
}

TEST_F(Streams, WhatHostCodeWaitedForEverybodyKnows) {
    const Operation in_one = issue(one), in_apart = issue(apart);
    order.host_waits_for_stream(one);
    EXPECT_TRUE(order.host_knows(in_one));
    EXPECT_FALSE(order.host_knows(in_apart));
    issue(two);
    EXPECT_TRUE(order.running_knows(in_one));
    order.host_waits_for_all();
    EXPECT_TRUE(order.host_knows_all() && order.host_knows(in_apart));
    const Operation later = issue(apart); // numbers go on
    EXPECT_GT(later, in_apart);
    EXPECT_TRUE(order.running_knows_all());
    EXPECT_EQ(order.name(later).file, "f.cu");
}

} // namespace
} // namespace raylab::simt::watch
