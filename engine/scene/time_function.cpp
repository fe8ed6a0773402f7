#include <algorithm>

#include "scene/scene.hpp"

namespace percuss {

double TimeFunction::operator()(double time) const {
    if (points.empty()) return 0;
    const auto later = std::upper_bound(points.begin(), points.end(), time,
                                        [](double t, const auto& point) { return t < point.first; });
    if (later == points.begin()) return points.front().second;
    if (later == points.end()) return points.back().second;
    const auto [t0, v0] = *(later - 1);
    const auto [t1, v1] = *later;
    return v0 + (v1 - v0) * (time - t0) / (t1 - t0);
}

}  // namespace percuss
