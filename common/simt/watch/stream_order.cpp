#include "common/simt/watch/stream_order.h"

#include <algorithm>

namespace raylab::simt::watch {

void StreamOrder::create(Stream stream, bool is_blocking) {
    numbers_[stream] = lanes_.size();
    lanes_.push_back({{}, 0, is_blocking});
}

void StreamOrder::destroy(Stream stream) { numbers_.erase(stream); }

size_t StreamOrder::lane_of(Stream stream) {
    const auto found = numbers_.find(stream);
    if (found != numbers_.end()) return found->second;
    create(stream, true); // cudaStreamPerThread
    return lanes_.size() - 1;
}

void StreamOrder::learn(Clock& clock, const Clock& other) {
    if (clock.size() < other.size()) clock.resize(other.size(), 0);
    for (size_t i = 0; i < other.size(); ++i) clock[i] = std::max(clock[i], other[i]);
}

void StreamOrder::know_all_lanes(Clock& clock, bool also_non_blocking) const {
    for (const Lane& lane : lanes_)
        if (lane.is_blocking || also_non_blocking) learn(clock, lane.knows);
}

bool StreamOrder::knows(const Clock& clock, Operation operation) const {
    if (operation <= ended_) return true;
    const uint32_t lane = issued_[operation - ended_ - 1].lane;
    return lane < clock.size() && operation <= clock[lane];
}

bool StreamOrder::knows_all(const Clock& clock) const {
    for (size_t i = 0; i < lanes_.size(); ++i)
        if (lanes_[i].last > ended_ && (i >= clock.size() || clock[i] < lanes_[i].last))
            return false;
    return true;
}

Operation StreamOrder::issue(Stream stream, const OperationName& name) {
    const size_t number = lane_of(stream);
    Lane& lane = lanes_[number];
    learn(lane.knows, host_);
    if (number == 0)
        know_all_lanes(lane.knows, false);
    else if (lane.is_blocking)
        learn(lane.knows, lanes_[0].knows);
    running_knows_all_ = knows_all(lane.knows);
    issued_.push_back({uint32_t(number), name});
    lane.last = ended_ + Operation(issued_.size());
    if (lane.knows.size() <= number) lane.knows.resize(number + 1, 0);
    lane.knows[number] = lane.last;
    running_ = lane.knows;
    host_knows_all_ = false;
    return lane.last;
}

void StreamOrder::record(Event event, Stream stream) {
    const size_t number = lane_of(stream);
    Clock& clock = events_[event] = lanes_[number].knows;
    learn(clock, host_);
    if (number == 0) know_all_lanes(clock, false);
}

void StreamOrder::wait(Stream stream, Event event) {
    learn(lanes_[lane_of(stream)].knows, events_[event]);
}

void StreamOrder::streams_wait_for_each_other() {
    Clock all;
    know_all_lanes(all, true);
    for (Lane& lane : lanes_) lane.knows = all;
}

void StreamOrder::host_waits_for_stream(Stream stream) {
    const size_t number = lane_of(stream);
    learn(host_, lanes_[number].knows);
    if (number == 0) know_all_lanes(host_, false);
    host_has_waited();
}

void StreamOrder::host_waits_for_event(Event event) {
    learn(host_, events_[event]);
    host_has_waited();
}

void StreamOrder::host_waits_for_all() {
    know_all_lanes(host_, true);
    host_has_waited();
}

// What host code knows, everything knows that is issued later. So nothing need be kept of what has
// ended, nor of streams that were destroyed.
void StreamOrder::host_has_waited() {
    if (!knows_all(host_)) return;
    ended_ += Operation(issued_.size());
    issued_.clear();
    events_.clear();
    host_.clear();
    running_.clear();
    std::vector<Lane> lanes(1);
    for (auto& [stream, number] : numbers_) {
        if (!stream) continue;
        lanes.push_back({{}, 0, lanes_[number].is_blocking});
        number = lanes.size() - 1;
    }
    lanes_ = std::move(lanes);
    host_knows_all_ = true;
}

} // namespace raylab::simt::watch
