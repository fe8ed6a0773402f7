#include "view/motion_labels.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "view/bodies.hpp"
#include "view/legend.hpp"

namespace percuss::render {

namespace {

/// Speeds of one run with one number of decimals: three digits for the fastest.
std::string speed_text(double speed, double fastest, const Units& units) {
    const DisplayUnit unit = units.display(Quantity::velocity, fastest);
    const double largest = unit.scale * fastest;
    const int decimals =
        largest > 0 ? std::clamp(2 - static_cast<int>(std::floor(std::log10(largest))), 0, 6) : 0;
    return fmt::format("{:.{}f} {}", unit.scale * speed, decimals, unit.label);
}

/// Places for a label of this size around a box, nearest first, then further off.
std::vector<Rect> places_around(const Rect& box, const std::array<double, 2>& size, double gap) {
    std::vector<Rect> places;
    const double x = box.x + 0.5 * (box.width - size[0]), y = box.y + 0.5 * (box.height - size[1]);
    const auto above_and_below = [&](double away) {
        for (const double shift : {0.0, -0.3, 0.3}) {
            places.push_back({x + shift * box.width, box.top() + away, size[0], size[1]});
            places.push_back({x + shift * box.width, box.y - away - size[1], size[0], size[1]});
        }
    };
    const auto beside = [&](double away) {
        for (const double shift : {0.0, -0.3, 0.3}) {
            places.push_back({box.right() + away, y + shift * box.height, size[0], size[1]});
            places.push_back({box.x - away - size[0], y + shift * box.height, size[0], size[1]});
        }
    };
    const bool upright =
        box.height > 1.5 * box.width;  // the nearest place is the one with the shortest leader
    for (int ring = 0; ring < 4; ++ring) {
        const double away = gap + ring * 1.4 * size[1];
        if (upright) beside(away);
        above_and_below(away);
        if (!upright) beside(away);
    }
    return places;
}

/// Places along both sides of the picture, from the height of the box on up and down: the last resort, with a
/// long leader.
void add_places_at_sides(const Rect& box, const std::array<double, 2>& size, const Rect& area, double gap,
                         std::vector<Rect>& places) {
    const double middle = box.y + 0.5 * (box.height - size[1]), row = size[1] + gap;
    for (int ring = 0; ring < 8; ++ring)
        for (const double y : {middle + ring * row, middle - ring * row})
            for (const double x : {area.right() - gap - size[0], area.x + gap})
                places.push_back({x, y, size[0], size[1]});
}

/// Both ends of the line that ties a label to the body's centre: x, y, x, y.
std::array<double, 4> leader_of(const Rect& place, double cx, double cy, double scale) {
    const bool beside = cy > place.y && cy < place.top();
    const double away = 4 * scale;
    const double from_x = beside ? (cx < place.x ? place.x - away : place.right() + away)
                                 : std::round(std::clamp(cx, place.x, place.right())) + 0.5;
    const double from_y = beside             ? std::round(cy) + 0.5
                          : cy > place.top() ? place.top() + away
                                             : place.y - away;
    const double to_x = beside ? cx : std::round(cx) + 0.5, to_y = beside ? std::round(cy) + 0.5 : cy;
    return {from_x, from_y, to_x, to_y};
}

/// Whether a line passes through a rectangle: what is left of it between the four sides (Liang and Barsky).
bool crosses(const std::array<double, 4>& line, const Rect& rect) {
    double begin = 0, end = 1;
    const auto clip = [&](double from, double to, double low, double high) {
        if (from == to) return from > low && from < high;
        const double a = (low - from) / (to - from), b = (high - from) / (to - from);
        begin = std::max(begin, std::min(a, b));
        end = std::min(end, std::max(a, b));
        return begin < end;
    };
    return clip(line[0], line[2], rect.x, rect.right()) && clip(line[1], line[3], rect.y, rect.top());
}

}  // namespace

void paint_motion(Canvas& canvas, const Snapshot& snapshot, const Plane& plane, const Fit& fit,
                  const Rect& area, double scale, double fastest, double longest, std::vector<Rect> taken,
                  std::vector<Rect> words) {
    // Words over words cannot be read, over a body or an arrow they can.
    constexpr std::size_t weight = 8;
    for (const Rect& rect : words) taken.insert(taken.end(), weight, rect);
    std::vector<Rect> boxes;
    for (const auto& box : body_boxes(snapshot, plane)) {
        const auto low = fit({box[0], box[1]}), high = fit({box[2], box[3]});
        boxes.push_back({low[0], low[1], high[0] - low[0], high[1] - low[1]});
        taken.push_back(boxes.back());
    }
    const Rect inside{area.x, area.y, area.width, area.height};
    // A narrow picture has more room for smaller letters.
    const double letters = std::clamp(area.width / (400 * scale), 0.8, 1.0);
    const TextStyle style{15 * scale * letters, velocity_colour, Align::left, VerticalAlign::bottom, true};
    for (std::size_t b = 0; b < boxes.size(); ++b) {
        const Rect& box = boxes[b];
        const double cx = box.x + 0.5 * box.width, cy = box.y + 0.5 * box.height;
        if (!area.contains({cx, cy, 0, 0})) continue;  // outside the chosen window
        const auto velocity = drawn_velocity(snapshot, b, plane);
        const double speed = std::hypot(velocity[0], velocity[1]);
        const std::string label = snapshot.setup->mesh.bodies[b].name + "  " +
                                  speed_text(speed, fastest, snapshot.setup->scene.units);
        const auto [width, height] = canvas.text_size(label, style);
        const auto over_words = [&](const Rect& candidate) {
            return std::any_of(words.begin(), words.end(),
                               [&](const Rect& rect) { return rect.overlaps(candidate); });
        };
        const auto leads_over_words = [&](const Rect& candidate) {
            const auto leader = leader_of(candidate, cx, cy, scale);
            return std::any_of(words.begin(), words.end(),
                               [&](const Rect& rect) { return crosses(leader, rect); });
        };
        auto places = places_around(box, {width, height}, 12 * scale);
        Rect place = places[choose_place(places, inside, taken)];
        if (letters < 1 || over_words(place)) {
            const auto near = static_cast<std::ptrdiff_t>(places.size());
            add_places_at_sides(box, {width, height}, area, 6 * scale, places);
            places.erase(std::remove_if(places.begin() + near, places.end(), leads_over_words), places.end());
            place = places[choose_place(places, inside, taken)];
        }
        const bool readable = !over_words(place);
        const Rect plate{place.x - 4 * scale, place.y - 2 * scale, width + 8 * scale, height + 4 * scale};
        if (readable) {
            const auto [from_x, from_y, to_x, to_y] = leader_of(place, cx, cy, scale);
            canvas.line(from_x, from_y, to_x, to_y, ink::white, 2.6 * scale);
            canvas.line(from_x, from_y, to_x, to_y, velocity_colour, 1.3 * scale);
        }
        if (speed > 0.005 * fastest)
            canvas.arrow(cx, cy, longest * velocity[0] / fastest, longest * velocity[1] / fastest,
                         velocity_colour, 3.2 * scale);
        canvas.disc(cx, cy, 3.5 * scale, velocity_colour);
        if (!readable) continue;
        taken.insert(taken.end(), weight, plate);
        words.push_back(plate);
        canvas.rectangle(plate, ink::white, 0.75);
        canvas.text(place.x, place.y, label, style);
    }
}

}  // namespace percuss::render
