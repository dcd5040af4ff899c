// The driver of builders that work from the root down, by cuts: of the KD-tree's and of the boxes'.
//
// It cuts what the tree is built of in two parts, and each part again, until the builder makes a
// leaf of it. Nodes come depth first: a node, then all below its first half, then all below its
// second half. Several threads share the work in pieces (builder/tasks.h): each piece grows a
// subtree with numbers of its own, and at the end the driver appends the subtrees to one another in
// the order in which one thread makes nodes. So the tree has the same bytes from any number of
// threads, as long as what happens to a part depends on the part alone. What subtrees may spend
// together, such as references that cuts add, a cut must share out between its halves.
//
// A Builder is a type with
//     Tree   what is built
//     Part   what a subtree is built of
//     Cut    a cut, with the parts on both sides: half[0], half[1]
//     Root   what a finished subtree tells the node above
//     size(part)             of the work
//     cut(part)              a Cut, or nothing if the part is to be a leaf
//     leaf(part, tree, place)           makes it a leaf; its Root
//     take(cut, k)           a Builder for half k, with what it needs in its own memory, and the
//                            half's Part there: a std::pair
// and, static, with functions that say how the tree is written (place: an int, where a node goes):
//     begin(tree)            the root's place in an empty tree
//     open(tree, place, cut)            begins an inner node; its number
//     place_in(node, k)      where half k of this node goes
//     close(tree, node, cut, first, second)  ends it, with its halves' Roots; its own Root
//     append(tree, place, subtree, root)     a whole subtree; its Root in the tree
#pragma once

#include "labs/04_accel/builder/tasks.h"

#include <memory>
#include <optional>
#include <utility>

namespace raylab::lab04 {

// Builds all of a part on this thread.
template <class Builder>
typename Builder::Root grow(Builder& builder, const typename Builder::Part& part,
                            typename Builder::Tree& tree, int place) {
    const std::optional<typename Builder::Cut> cut = builder.cut(part);
    if (!cut) return builder.leaf(part, tree, place);
    const int node = Builder::open(tree, place, *cut);
    const auto first = grow(builder, cut->half[0], tree, Builder::place_in(node, 0));
    const auto second = grow(builder, cut->half[1], tree, Builder::place_in(node, 1));
    return Builder::close(tree, node, *cut, first, second);
}

// A node at the top of the tree that is cut, or a subtree that one thread builds.
template <class Builder> class Piece {
  public:
    Piece(Builder builder, typename Builder::Part part)
        : builder_(std::move(builder)), part_(std::move(part)) {}

    std::size_t size() const { return builder_->size(part_); }

    bool cut() {
        cut_ = builder_->cut(part_);
        if (!cut_) return false;
        for (int k = 0; k < 2; ++k) {
            auto [builder, part] = builder_->take(*cut_, k);
            half[k] = std::make_unique<Piece>(std::move(builder), std::move(part));
        }
        builder_.reset();
        return true;
    }

    void build() {
        const int place = Builder::begin(tree_);
        root_ = grow(*builder_, part_, tree_, place);
        builder_.reset();
    }

    typename Builder::Root append_to(typename Builder::Tree& tree, int place) const {
        if (!half[0]) return Builder::append(tree, place, tree_, root_);
        const int node = Builder::open(tree, place, *cut_);
        const auto first = half[0]->append_to(tree, Builder::place_in(node, 0));
        const auto second = half[1]->append_to(tree, Builder::place_in(node, 1));
        return Builder::close(tree, node, *cut_, first, second);
    }

    std::unique_ptr<Piece> half[2]; // of a node that is cut

  private:
    std::optional<Builder> builder_; // until it has done its work
    typename Builder::Part part_;
    std::optional<typename Builder::Cut> cut_;
    typename Builder::Tree tree_; // the subtree,
    typename Builder::Root root_; // and its root
};

// Builds `part` into the empty tree, on so many threads; 0: one per core.
template <class Builder>
typename Builder::Root build_tree(Builder builder, typename Builder::Part part, int threads,
                                  typename Builder::Tree& tree) {
    Piece<Builder> root(std::move(builder), std::move(part));
    build_in_pieces(root, threads);
    return root.append_to(tree, Builder::begin(tree));
}

} // namespace raylab::lab04
