#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace percuss {

/// Places in a matrix that couple with no others.
struct PlaceGroup {
    std::int32_t begin, end;
};

/// Puts things that couple with each other into breadth-first order from the first thing of each connected
/// group (Cuthill & McKee 1969, without sorting by degree), so that the profile of their matrix is narrow
/// whatever the order they come in.
class BreadthFirst {
  public:
    void reserve(std::size_t count) {
        order_.reserve(count);
        seen_.reserve(count);
        groups_.reserve(count);
    }

    /// @param count of the things @param neighbours (thing, take): calls take(other) for all that couple
    /// with it @param further (take): asked when nothing nearer is left; calls take until one is taken, or
    /// not. take tells whether the thing was not there yet.
    template <class Neighbours, class Further>
    void sort(std::size_t count, const Neighbours& neighbours, const Further& further) {
        order_.clear();
        groups_.clear();
        seen_.assign(count, 0);
        const auto take = [this](std::int32_t thing) {
            char& seen = seen_[static_cast<std::size_t>(thing)];
            if (seen) return false;
            seen = 1;
            order_.push_back(thing);
            return true;
        };
        for (std::size_t start = 0; start < count; ++start) {
            const std::size_t begin = order_.size();
            if (!take(static_cast<std::int32_t>(start))) continue;
            for (std::size_t at = begin; at < order_.size(); ++at) {
                neighbours(order_[at], take);
                if (at + 1 == order_.size()) further(take);
            }
            groups_.push_back({static_cast<std::int32_t>(begin), static_cast<std::int32_t>(order_.size())});
        }
    }

    [[nodiscard]] const std::vector<std::int32_t>& order() const { return order_; }
    [[nodiscard]] const std::vector<PlaceGroup>& groups() const { return groups_; }

  private:
    std::vector<std::int32_t> order_;
    std::vector<char> seen_;
    std::vector<PlaceGroup> groups_;
};

}  // namespace percuss
