#include "mesh/spacing.hpp"

#include <algorithm>
#include <numeric>
#include <stdexcept>

#include <fmt/format.h>

namespace percuss {
namespace {

constexpr std::size_t most_cells = 1'000'000;

std::vector<double> growing_sizes(const Spacing& spacing, double length) {
    std::vector<double> sizes;
    double size = spacing.first, sum = 0;
    while (sum < length) {
        if (sizes.size() == most_cells)
            throw std::invalid_argument(fmt::format("makes more than {} cells; enlarge them", most_cells));
        sizes.push_back(size);
        sum += size;
        size = std::min(size * spacing.ratio, spacing.largest);
    }
    if (sizes.size() > 1 && length - (sum - sizes.back()) < sum - length) sizes.pop_back();
    if (spacing.from_end) std::reverse(sizes.begin(), sizes.end());
    return sizes;
}

}  // namespace

std::vector<double> cell_sizes(const Spacing& spacing, double length) {
    auto sizes = spacing.sizes.empty() ? growing_sizes(spacing, length) : spacing.sizes;
    const double sum = std::accumulate(sizes.begin(), sizes.end(), 0.0);
    for (double& size : sizes) size *= length / sum;
    return sizes;
}

std::vector<double> spaced_fractions(const std::vector<Spacing>& stretches, double length) {
    if (!(length > 0))
        throw std::invalid_argument("gives sizes to a side without length; write a number of cells");
    if (stretches.empty()) throw std::invalid_argument("is empty; write a number of cells or their sizes");
    std::vector<double> fractions{0};
    double begin = 0;
    for (std::size_t i = 0; i < stretches.size(); ++i) {
        const bool last = i + 1 == stretches.size();
        if (!last && !stretches[i].length)
            throw std::invalid_argument("has a stretch without 'length'; only the last may leave it out");
        const double rest = length - begin, own = stretches[i].length.value_or(rest);
        const double slack = 1e-9 * length;
        if (last ? own > rest + slack || own < rest - slack : !(own < rest - slack))
            throw std::invalid_argument(fmt::format(
                "has stretches that do not add up to the side, of length {:.9g}: {:.9g} {} after {:.9g}",
                length, own, last ? "ends" : "leaves nothing", begin));
        if (last && !(rest > slack)) throw std::invalid_argument("leaves nothing to its last stretch");
        double at = begin;
        for (const double size : cell_sizes(stretches[i], last ? rest : own)) {
            at += size;
            fractions.push_back(at / length);
        }
        if (fractions.size() > most_cells)
            throw std::invalid_argument(fmt::format("makes more than {} cells; enlarge them", most_cells));
        begin += own;
        fractions.back() = last ? 1 : begin / length;
    }
    return fractions;
}

}  // namespace percuss
