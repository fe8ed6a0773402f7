#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "dynamics/node.hpp"
#include "elements/batch.hpp"

namespace percuss {

/// Which elements and nodes a step has to visit. What no wave has reached yet is at rest in its first place,
/// without stress or load: its forces are exactly zero (initial volumes are made so, initial_volume.hpp), and
/// a step that leaves it out gives the same bits. Motion spreads from element to element through their nodes,
/// so only elements next to the ones visited have to be watched. What has once moved is visited for good.
class QuietRegions {
  public:
    /// Blocks of elements, or nodes.
    struct Range {
        std::int32_t begin = 0, end = 0;
    };
    /// A part of one body that a thread takes at a time.
    struct Chunk {
        std::int32_t body = 0, begin = 0, end = 0;
    };

    QuietRegions() = default;
    /// Every block and node is visited. @param blocks,nodes the parts of all bodies, body after body, in
    /// order.
    QuietRegions(std::vector<Chunk> blocks, std::vector<Chunk> nodes);

    /// Leaves out every block none of whose nodes is `busy` (per node: it moves, has moved, or something
    /// other than its elements may move it) and that is not in `visited` (as below).
    void find(const std::vector<Batch>& batches, const std::vector<char>& busy,
              const std::vector<char>& visited);
    void visit_all();

    /// Nothing is left out: there is nothing to watch either.
    [[nodiscard]] bool none() const { return quiet_ == 0; }
    /// Blocks that are left out.
    [[nodiscard]] std::int32_t quiet() const { return quiet_; }
    /// Takes in the neighbours that motion has reached, and elements of the nodes that contact has moved.
    void take_in_moving(std::span<const Node> nodes, std::span<const std::int32_t> touched);

    /// What to visit of a chunk, in order.
    [[nodiscard]] std::span<const Range> blocks(std::size_t chunk) const { return blocks_[chunk].visited; }
    [[nodiscard]] std::span<const Range> nodes(std::size_t chunk) const { return nodes_[chunk].visited; }
    /// Per block of all batches, whether it is visited; empty when all are.
    [[nodiscard]] const std::vector<char>& visited() const { return visited_; }

  private:
    struct Part {
        Chunk chunk;
        std::vector<Range> visited;
        bool changed = false;
    };
    void visit(std::int32_t block);
    void list_changed();

    std::vector<Part> blocks_, nodes_;
    // Only while something is quiet. Blocks are counted over all batches.
    std::vector<std::int32_t> first_block_;               // per batch
    std::vector<std::int32_t> node_begin_, blocks_of_;    // per node: its range of the blocks that have it
    std::vector<std::int32_t> block_begin_, nodes_of_;    // per block: its range of its nodes
    std::vector<std::int32_t> block_part_, node_part_;    // where each is listed
    std::vector<char> visited_, visited_node_, watched_;  // per block; per node; per block
    std::vector<std::int32_t> watch_;                     // quiet blocks with a visited node
    std::int32_t quiet_ = 0;                              // blocks
};

}  // namespace percuss
