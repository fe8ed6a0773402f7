#include "view/force_scale.hpp"

#include <algorithm>
#include <cmath>

#include "figures/ticks.hpp"

namespace percuss::render {

double ForceScaling::decades() const { return -std::log10(cut_off); }

double ForceScaling::length(double force) const {
    if (!(reference > 0) || !(force > 0)) return 0;
    const double ratio = force / reference;
    if (kind == ForceScale::logarithmic)
        return std::max(0.0, reference_length * (1 + std::log10(ratio) / decades()));
    return ratio < cut_off ? 0 : reference_length * ratio;
}

ForceScaling make_force_scaling(const ViewOptions& options, double largest, double longest) {
    ForceScaling scaling;
    scaling.kind = options.force_scale;
    scaling.cut_off = options.force_cut_off.value_or(scaling.kind == ForceScale::logarithmic ? 0.001 : 0.01);
    if (options.force_scale == ForceScale::fixed && options.force_reference) {
        scaling.reference = *options.force_reference;
        scaling.reference_length = longest;
        return scaling;
    }
    if (!(largest > 0)) return scaling;
    scaling.reference = options.force_reference ? *options.force_reference : round_below(largest);
    if (scaling.kind == ForceScale::logarithmic)
        scaling.reference_length =
            longest / std::max(1.0, 1 + std::log10(largest / scaling.reference) / scaling.decades());
    else
        scaling.reference_length = longest * scaling.reference / largest;
    return scaling;
}

}  // namespace percuss::render
