#include "dynamics/quiet_regions.hpp"

#include <algorithm>
#include <numeric>

namespace percuss {
namespace {

bool moves(const Node& node) { return node.v[0] != 0 || node.v[1] != 0; }

/// Lists of `count` items from pairs (item, entry): the range of each in the entries, in the order of the
/// pairs.
void group(const std::vector<std::pair<std::int32_t, std::int32_t>>& pairs, std::size_t count,
           std::vector<std::int32_t>& begin, std::vector<std::int32_t>& entries) {
    begin.assign(count + 1, 0);
    for (const auto& [item, entry] : pairs) ++begin[static_cast<std::size_t>(item) + 1];
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    entries.resize(pairs.size());
    std::vector<std::int32_t> next(begin.begin(), begin.end() - 1);
    for (const auto& [item, entry] : pairs)
        entries[static_cast<std::size_t>(next[static_cast<std::size_t>(item)]++)] = entry;
}

std::span<const std::int32_t> range_of(const std::vector<std::int32_t>& begin,
                                       const std::vector<std::int32_t>& entries, std::size_t item) {
    return {entries.data() + begin[item], entries.data() + begin[item + 1]};
}

}  // namespace

QuietRegions::QuietRegions(std::vector<Chunk> blocks, std::vector<Chunk> nodes) {
    for (const Chunk& chunk : blocks) blocks_.push_back({chunk, {}, false});
    for (const Chunk& chunk : nodes) nodes_.push_back({chunk, {}, false});
    visit_all();
}

void QuietRegions::visit_all() {
    for (auto* parts : {&blocks_, &nodes_})
        for (Part& part : *parts) part.visited.assign(1, {part.chunk.begin, part.chunk.end});
    QuietRegions all;
    all.blocks_ = std::move(blocks_);
    all.nodes_ = std::move(nodes_);
    *this = std::move(all);
}

void QuietRegions::find(const std::vector<Batch>& batches, const std::vector<char>& busy,
                        const std::vector<char>& visited) {
    visit_all();
    first_block_.assign(1, 0);
    for (const Batch& batch : batches) first_block_.push_back(first_block_.back() + batch.blocks());
    const auto count = static_cast<std::size_t>(first_block_.back());

    std::vector<std::pair<std::int32_t, std::int32_t>> pairs;  // block, node
    for (std::size_t b = 0; b < batches.size(); ++b) {
        const Batch& batch = batches[b];
        for (std::int32_t block = 0; block < batch.blocks(); ++block)
            for (int corner = 0; corner < batch.corners; ++corner)
                for (int lane = 0; lane < batch.filled(block); ++lane)
                    pairs.emplace_back(first_block_[b] + block,
                                       batch.nodes[static_cast<std::size_t>(
                                           (block * batch.corners + corner) * block_lanes + lane)]);
    }
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    group(pairs, count, block_begin_, nodes_of_);
    for (auto& [block, node] : pairs) std::swap(block, node);
    group(pairs, busy.size(), node_begin_, blocks_of_);

    block_part_.resize(count);
    node_part_.resize(busy.size());
    for (std::size_t k = 0; k < blocks_.size(); ++k) {
        const auto& [body, begin, end] = blocks_[k].chunk;
        const auto first = block_part_.begin() + first_block_[static_cast<std::size_t>(body)];
        std::fill(first + begin, first + end, static_cast<std::int32_t>(k));
    }
    for (std::size_t k = 0; k < nodes_.size(); ++k) {
        const Chunk& chunk = nodes_[k].chunk;
        std::fill(node_part_.begin() + chunk.begin, node_part_.begin() + chunk.end,
                  static_cast<std::int32_t>(k));
    }
    visited_.assign(count, 0);
    watched_.assign(count, 0);
    visited_node_.assign(busy.size(), 0);
    watch_.reserve(count);
    quiet_ = static_cast<std::int32_t>(count);
    for (Part& part : blocks_) part.changed = true;
    for (Part& part : nodes_) part.changed = true;
    for (std::size_t block = 0; block < count; ++block) {
        const auto nodes = range_of(block_begin_, nodes_of_, block);
        const bool reached = std::any_of(nodes.begin(), nodes.end(), [&](std::int32_t node) {
            return busy[static_cast<std::size_t>(node)] != 0;
        });
        if (reached || (!visited.empty() && visited[block])) visit(static_cast<std::int32_t>(block));
    }
    list_changed();
    if (none()) visit_all();
}

void QuietRegions::visit(std::int32_t block) {
    const auto b = static_cast<std::size_t>(block);
    if (visited_[b]) return;
    visited_[b] = 1;
    --quiet_;
    blocks_[static_cast<std::size_t>(block_part_[b])].changed = true;
    for (const std::int32_t node : range_of(block_begin_, nodes_of_, b)) {
        const auto n = static_cast<std::size_t>(node);
        if (visited_node_[n]) continue;
        visited_node_[n] = 1;
        nodes_[static_cast<std::size_t>(node_part_[n])].changed = true;
        for (const std::int32_t neighbour : range_of(node_begin_, blocks_of_, n)) {
            char& watched = watched_[static_cast<std::size_t>(neighbour)];
            if (watched || visited_[static_cast<std::size_t>(neighbour)]) continue;
            watched = 1;
            watch_.push_back(neighbour);
        }
    }
}

void QuietRegions::take_in_moving(std::span<const Node> nodes, std::span<const std::int32_t> touched) {
    for (const std::int32_t node : touched) {
        const auto n = static_cast<std::size_t>(node);
        if (n >= visited_node_.size() || visited_node_[n] || !moves(nodes[n])) continue;
        for (const std::int32_t block : range_of(node_begin_, blocks_of_, n)) visit(block);
    }
    // Blocks that join the watch meanwhile have no moving node yet, or they would have been on it.
    for (std::size_t k = 0; k < watch_.size();) {
        const std::int32_t block = watch_[k];
        const auto of = range_of(block_begin_, nodes_of_, static_cast<std::size_t>(block));
        if (std::any_of(of.begin(), of.end(),
                        [&](std::int32_t node) { return moves(nodes[static_cast<std::size_t>(node)]); }))
            visit(block);
        if (visited_[static_cast<std::size_t>(block)]) {
            watch_[k] = watch_.back();
            watch_.pop_back();
        } else {
            ++k;
        }
    }
    if (none())
        visit_all();
    else
        list_changed();
}

void QuietRegions::list_changed() {
    const auto list = [](Part& part, auto&& is_visited) {
        part.visited.clear();
        for (std::int32_t k = part.chunk.begin; k < part.chunk.end; ++k) {
            if (!is_visited(k)) continue;
            if (part.visited.empty() || part.visited.back().end < k)
                part.visited.push_back({k, k + 1});
            else
                part.visited.back().end = k + 1;
        }
        part.changed = false;
    };
    for (Part& part : blocks_) {
        if (!part.changed) continue;
        const std::int32_t first = first_block_[static_cast<std::size_t>(part.chunk.body)];
        list(part,
             [&](std::int32_t block) { return visited_[static_cast<std::size_t>(first + block)] != 0; });
    }
    for (Part& part : nodes_)
        if (part.changed)
            list(part, [&](std::int32_t node) { return visited_node_[static_cast<std::size_t>(node)] != 0; });
}

}  // namespace percuss
