// The order of launches and copies that streams, events and the waits of host code make.
//
// An operation, a launch or a copy, has a number, in the order of the calls. What a stream knows to
// have ended before its next operation begins is, for each stream, the number of an operation: that
// one and all before it in that stream (Lamport 1978, as in knowledge.h). The default stream waits
// for all streams but the non-blocking ones, and they for it (CUDA C++ Programming Guide, "Default
// Stream").
#pragma once

#include <atomic>
#include <cstdint>
#include <string>
#include <unordered_map>
#include <vector>

namespace raylab::simt::watch {

using Operation = uint32_t; // 0: none

// What findings say of an operation.
struct OperationName {
    std::string kernel; // empty: a copy
    std::string file;   // where it was called
    int line = 0;
};

class StreamOrder {
  public:
    using Stream = const void*; // null: the default stream
    using Event = const void*;

    void create(Stream stream, bool is_blocking);
    void destroy(Stream stream); // what it was given goes on

    // Gives a stream an operation, which runs from now on until the next one is issued.
    Operation issue(Stream stream, const OperationName& name);
    void record(Event event, Stream stream);
    void wait(Stream stream, Event event);
    void streams_wait_for_each_other(); // what is issued later comes after all that was before
    void host_waits_for_stream(Stream stream);
    void host_waits_for_event(Event event);
    void host_waits_for_all();

    bool host_knows_all() const { return host_knows_all_; }
    bool host_knows(Operation operation) const { return knows(host_, operation); }
    bool running_knows_all() const { return running_knows_all_; }
    bool running_knows(Operation operation) const { return knows(running_, operation); }

    // Of an operation that host code does not know to have ended.
    const OperationName& name(Operation operation) const {
        return issued_[operation - ended_ - 1].name;
    }

  private:
    using Clock = std::vector<Operation>; // by stream's number; what is missing is 0
    struct Lane {                         // a stream
        Clock knows;
        Operation last = 0;
        bool is_blocking = true;
    };
    struct Issued {
        uint32_t lane;
        OperationName name;
    };

    size_t lane_of(Stream stream);
    void know_all_lanes(Clock& clock, bool also_non_blocking) const;
    static void learn(Clock& clock, const Clock& other);
    bool knows(const Clock& clock, Operation operation) const;
    bool knows_all(const Clock& clock) const;
    void host_has_waited();

    std::vector<Lane> lanes_ = std::vector<Lane>(1); // 0: the default stream
    std::unordered_map<Stream, size_t> numbers_{{nullptr, 0}};
    std::unordered_map<Event, Clock> events_;
    Clock host_, running_;
    std::vector<Issued> issued_; // after `ended_`
    Operation ended_ = 0;        // up to here everybody knows all
    std::atomic<bool> host_knows_all_{true};
    bool running_knows_all_ = true;
};

} // namespace raylab::simt::watch
