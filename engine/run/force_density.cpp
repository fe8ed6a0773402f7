#include "run/force_density.hpp"

#include <algorithm>
#include <cmath>

namespace percuss {

ForceDensity force_density(const Trace& trace, std::size_t component, std::optional<std::size_t> along,
                           int bins) {
    const std::size_t points = trace.points.size(), count = static_cast<std::size_t>(bins);
    std::vector<double> place = trace.along;
    if (along)
        for (std::size_t k = 0; k < points; ++k)
            place[k] = trace.points[k][static_cast<Eigen::Index>(*along)];
    const auto [least, most] = std::minmax_element(place.begin(), place.end());
    const double low = *least, width = (*most - *least) / bins;

    ForceDensity result;
    for (std::size_t b = 0; b <= count; ++b) result.edges.push_back(low + width * static_cast<double>(b));
    // The part of each node's force that each bin takes.
    struct Share {
        std::size_t point, bin;
        double part;
    };
    std::vector<Share> shares;
    const auto bin_of = [&](double at) {
        return width > 0 ? static_cast<std::size_t>(std::clamp((at - low) / width, 0.0, bins - 1.0)) : 0;
    };
    for (std::size_t k = 0; k < points; ++k) {
        const double before = k > 0 ? 0.5 * (place[k - 1] + place[k]) : place[k];
        const double after = k + 1 < points ? 0.5 * (place[k] + place[k + 1]) : place[k];
        const double from = std::min({before, after, place[k]}), to = std::max({before, after, place[k]});
        if (!(to > from)) {
            shares.push_back({k, bin_of(place[k]), 1});
            continue;
        }
        for (std::size_t b = bin_of(from); b <= bin_of(to); ++b) {
            const double part =
                (std::min(to, result.edges[b + 1]) - std::max(from, result.edges[b])) / (to - from);
            if (part > 0) shares.push_back({k, b, part});
        }
    }
    const std::size_t rows = trace.rows->rows();
    result.values.assign(rows * count, 0);
    for (std::size_t f = 0; f < rows; ++f) {
        const std::vector<double> row = trace.rows->table(f, f + 1);
        result.times.push_back(row[0]);
        for (const Share& share : shares)
            result.values[f * count + share.bin] +=
                share.part * row[1 + 2 * share.point + component] / (width > 0 ? width : 1);
    }
    return result;
}

}  // namespace percuss
