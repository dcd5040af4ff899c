// cooperative_groups: groups of lanes of one warp, that exchange values: tiles, and coalesced
// groups.
//
// Members are numbered by rank. What a group gives as a set of members, has one bit for each rank.
#pragma once

#include "common/simt/groups/thread_group.h"

#include <cstdint>
#include <cstring>
#include <type_traits>

namespace cooperative_groups {

class Lanes : public thread_group {
  public:
    unsigned size() const { return unsigned(__popc(mask_)); }
    unsigned num_threads() const { return size(); }
    unsigned thread_rank() const { return unsigned(thread_group::thread_rank()); }

    // Which of its parent's parts this group is, and how many there are.
    unsigned meta_group_rank() const { return part_; }
    unsigned meta_group_size() const { return parts_; }

    template <class T> T shfl(T value, int rank, Where where = Where::here()) const {
        return from(site("shfl()", where), value, unsigned(rank) % size());
    }
    // A source outside of the group means the caller itself.
    template <class T> T shfl_up(T value, unsigned delta, Where where = Where::here()) const {
        unsigned rank = thread_rank();
        return from(site("shfl_up()", where), value, delta <= rank ? rank - delta : rank);
    }
    template <class T> T shfl_down(T value, unsigned delta, Where where = Where::here()) const {
        unsigned rank = thread_rank();
        return from(site("shfl_down()", where), value, rank + delta < size() ? rank + delta : rank);
    }

    unsigned ballot(int predicate, Where where = Where::here()) const {
        return pack(raylab::simt::vote(site("ballot()", where), mask_, predicate != 0));
    }
    int any(int predicate, Where where = Where::here()) const {
        return raylab::simt::vote(site("any()", where), mask_, predicate != 0) != 0;
    }
    int all(int predicate, Where where = Where::here()) const {
        return raylab::simt::vote(site("all()", where), mask_, predicate == 0) == 0;
    }
    template <class T> unsigned match_any(T value, Where where = Where::here()) const {
        return pack(raylab::simt::match_any(site("match_any()", where), mask_, value));
    }
    template <class T> unsigned match_all(T value, int& equal, Where where = Where::here()) const {
        return pack(raylab::simt::match_all(site("match_all()", where), mask_, value, &equal));
    }

    // Calls use(value) with what each member brought, in the order of their ranks.
    template <class T, class Use>
    void for_each(const char* operation, Where where, T value, Use use) const {
        constexpr size_t words = (sizeof(T) + 7) / 8;
        uint64_t mine[words] = {}, all[words][32];
        std::memcpy(mine, &value, sizeof(T));
        for (size_t word = 0; word < words; ++word)
            raylab::simt::gather(site(operation, where), mask_, mine[word], all[word]);
        for (unsigned rest = mask_ & raylab::simt::existing_lanes(); rest; rest &= rest - 1) {
            uint64_t its[words];
            for (size_t word = 0; word < words; ++word) its[word] = all[word][__ffs(int(rest)) - 1];
            std::memcpy(&value, its, sizeof(T));
            use(value);
        }
    }

    unsigned lane_mask() const { return mask_; }

  protected:
    Lanes(unsigned mask, unsigned part, unsigned parts)
        : thread_group(Kind::lanes, mask), part_(part), parts_(parts) {}

    static const raylab::simt::Site& site(const char* operation, Where where) {
        return raylab::simt::site_of(operation, where);
    }

    // What the member with this rank brings; any size goes 8 bytes at a time.
    template <class T> T from(const raylab::simt::Site& site, T value, unsigned rank) const {
        int lane = int(__fns(mask_, 0, int(rank) + 1));
        constexpr size_t words = (sizeof(T) + 7) / 8;
        uint64_t bits[words] = {};
        std::memcpy(bits, &value, sizeof(T));
        for (uint64_t& word : bits) word = raylab::simt::shuffle(site, mask_, word, lane);
        std::memcpy(&value, bits, sizeof(T));
        return value;
    }

    // From lanes to ranks.
    unsigned pack(unsigned lanes) const {
        unsigned packed = 0, rank = 0;
        for (unsigned rest = mask_; rest; rest &= rest - 1, ++rank)
            if (lanes & rest & -rest) packed |= 1u << rank;
        return packed;
    }

    unsigned part_, parts_;
};

// Those lanes of the warp that are here together.
class coalesced_group : public Lanes {
  public:
    explicit coalesced_group(unsigned mask, unsigned part = 0, unsigned parts = 1)
        : Lanes(mask, part, parts) {}
};

inline coalesced_group coalesced_threads(Where where = Where::here()) {
    return coalesced_group(
        raylab::simt::active_mask(raylab::simt::site_of("coalesced_threads()", where)));
}

// `Size` neighbouring threads of a block.
template <unsigned Size, class Parent = void> class thread_block_tile : public Lanes {
    static_assert(Size <= 32, "the CPU machine has no tiles of more than one warp");
    static_assert((Size & (Size - 1)) == 0 && Size > 0, "a tile's size is a power of two");

  public:
    thread_block_tile(unsigned mask, unsigned part, unsigned parts) : Lanes(mask, part, parts) {}
    // A tile that does not say of what it is a part, is made of any of its size.
    template <class Other>
    requires std::is_void_v<Parent> thread_block_tile(const thread_block_tile<Size, Other>& tile)
        : Lanes(tile) {}

    template <class T> T shfl_xor(T value, unsigned bits, Where where = Where::here()) const {
        return from(site("shfl_xor()", where), value, (thread_rank() ^ bits) % Size);
    }
    static constexpr unsigned size() { return Size; }
    static constexpr unsigned num_threads() { return Size; }
};

namespace detail {

// The lanes of the tile of this size that the caller's lane belongs to.
inline unsigned tile_mask(unsigned size) {
    unsigned first = unsigned(raylab::simt::lane_index()) & ~(size - 1);
    return (size == 32 ? ~0u : (1u << size) - 1) << first;
}

// The members of `mask` whose rank is that of the caller but for a rest below `size`.
inline unsigned ranks_mask(unsigned mask, unsigned rank, unsigned size) {
    unsigned part = 0, at = 0;
    for (unsigned rest = mask; rest; rest &= rest - 1, ++at)
        if (at / size == rank / size) part |= rest & -rest;
    return part;
}

} // namespace detail

template <unsigned Size>
inline thread_block_tile<Size, thread_block> tiled_partition(const thread_block& block) {
    return {detail::tile_mask(Size), block.thread_rank() / Size, (block.size() + Size - 1) / Size};
}
template <unsigned Size, unsigned ParentSize, class GrandParent>
inline thread_block_tile<Size, thread_block_tile<ParentSize, GrandParent>>
tiled_partition(const thread_block_tile<ParentSize, GrandParent>& parent) {
    static_assert(Size <= ParentSize, "a part is not larger than the whole");
    return {detail::tile_mask(Size), parent.thread_rank() / Size, ParentSize / Size};
}
inline coalesced_group tiled_partition(const coalesced_group& parent, unsigned size) {
    return coalesced_group(detail::ranks_mask(parent.lane_mask(), parent.thread_rank(), size),
                           parent.thread_rank() / size, (parent.size() + size - 1) / size);
}
template <unsigned Size> inline coalesced_group tiled_partition(const coalesced_group& parent) {
    return tiled_partition(parent, Size);
}
inline thread_group tiled_partition(const thread_group& parent, unsigned size) {
    if (parent.kind_ == thread_group::Kind::lanes)
        return {thread_group::Kind::lanes,
                detail::ranks_mask(parent.mask_, unsigned(parent.thread_rank()), size)};
    return {thread_group::Kind::lanes, detail::tile_mask(size)};
}

// The members that bring the same label.
template <class Label>
inline coalesced_group labeled_partition(const Lanes& parent, Label label,
                                         Where where = Where::here()) {
    return coalesced_group(raylab::simt::match_any(
        raylab::simt::site_of("labeled_partition()", where), parent.lane_mask(), label));
}
inline coalesced_group binary_partition(const Lanes& parent, bool predicate,
                                        Where where = Where::here()) {
    return labeled_partition(parent, int(predicate), where);
}

} // namespace cooperative_groups
