#include "view/layout.hpp"

#include <algorithm>
#include <limits>

namespace percuss::render {

Layout make_layout(int width, int height, double aspect, std::size_t charts) {
    Layout layout;
    const double w = width, h = height;
    const double s = layout.scale = std::min(h / 720, w / 960);
    const double pad = 22 * s, title = 48 * s, legend = 70 * s;
    layout.title = {pad, h - title, w - 2 * pad, title};
    const double body = h - title;  // what is left for model, legend and charts
    const auto n = static_cast<double>(charts);
    if (charts == 0) {
        layout.legend = {pad, 0, w - 2 * pad, legend};
        layout.model = {pad, legend, w - 2 * pad, body - legend};
    } else if (aspect > 1.8) {
        // The free height goes to the charts, but the model keeps room for labels above and below it.
        const double wanted = (w - 2 * pad) / aspect + 130 * s;
        const double model = std::clamp(wanted, 0.24 * h, 0.46 * h);
        layout.model = {pad, h - title - model, w - 2 * pad, model};
        layout.legend = {pad, layout.model.y - legend, w - 2 * pad, legend};
        const double each = (w - 2 * pad - (n - 1) * pad) / n;
        for (std::size_t i = 0; i < charts; ++i)
            layout.charts.push_back(
                {pad + static_cast<double>(i) * (each + pad), 0.4 * pad, each, layout.legend.y - 0.9 * pad});
    } else {
        const double side = std::clamp(w - 2 * pad - 1.1 * aspect * (body - legend), 0.36 * w, 0.5 * w);
        const double left = w - 3 * pad - side;
        layout.legend = {pad, 0, left, legend};
        layout.model = {pad, legend, left, body - legend};
        const double each = (body - 0.4 * pad - (n - 1) * 0.5 * pad) / n;
        for (std::size_t i = 0; i < charts; ++i)
            layout.charts.push_back(
                {w - pad - side, h - title - each - static_cast<double>(i) * (each + 0.5 * pad), side, each});
    }
    return layout;
}

Fit fit_box(const std::array<double, 4>& box, const Rect& rect, const std::array<double, 2>& margin) {
    const double width = std::max(box[2] - box[0], 1e-300), height = std::max(box[3] - box[1], 1e-300);
    Fit fit;
    fit.pixels_per_unit = std::min(std::max(rect.width - 2 * margin[0], 1.0) / width,
                                   std::max(rect.height - 2 * margin[1], 1.0) / height);
    fit.offset = {rect.x + 0.5 * rect.width - 0.5 * fit.pixels_per_unit * (box[0] + box[2]),
                  rect.y + 0.5 * rect.height - 0.5 * fit.pixels_per_unit * (box[1] + box[3])};
    return fit;
}

std::array<double, 4> grown(const std::array<double, 4>& box, const std::array<double, 4>& needed) {
    std::array<double, 4> result = box;
    // A step of 5 % of the larger side: growing by hairs would rescale every frame.
    const double step = 0.05 * std::max(box[2] - box[0], box[3] - box[1]);
    for (std::size_t k = 0; k < 2; ++k) {
        if (needed[k] < box[k]) result[k] = needed[k] - step;
        if (needed[k + 2] > box[k + 2]) result[k + 2] = needed[k + 2] + step;
    }
    return result;
}

std::size_t choose_place(const std::vector<Rect>& candidates, const Rect& area,
                         const std::vector<Rect>& taken) {
    std::size_t best = 0, fewest = std::numeric_limits<std::size_t>::max();
    for (std::size_t i = 0; i < candidates.size(); ++i) {
        auto clashes = static_cast<std::size_t>(std::count_if(
            taken.begin(), taken.end(), [&](const Rect& rect) { return rect.overlaps(candidates[i]); }));
        if (!area.contains(candidates[i])) clashes += taken.size() + 1;
        if (clashes < fewest) {
            fewest = clashes;
            best = i;
        }
    }
    return best;
}

}  // namespace percuss::render
