#include "mesh/curve.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include <fmt/format.h>

#include "scene/bound_formula.hpp"

namespace percuss {
namespace {

double cross(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Evaluates one kind of side at a fraction of its length.
struct Evaluate {
    Vec2 from, to;
    const std::vector<double>& fractions;

    std::vector<Vec2> operator()(const Straight&) const {
        std::vector<Vec2> points;
        // std::lerp gives a coordinate that both ends share exactly: faces stay flat, the axis at r = 0.
        for (const double s : fractions) points.push_back(lerp(from, to, s));
        return points;
    }

    std::vector<Vec2> operator()(const Arc& arc) const {
        const Vec2 a = arc.through - from, b = to - from;
        const double twice_area = cross(a, b);
        if (!(std::abs(twice_area) > 1e-9 * a.norm() * b.norm()) || !((arc.through - to).norm() > 0))
            throw std::invalid_argument(
                "the point of the arc lies on the line of its ends; move it or write \"straight\"");
        // Circumcentre relative to `from`.
        const Vec2 centre = Vec2(b.y() * a.squaredNorm() - a.y() * b.squaredNorm(),
                                 a.x() * b.squaredNorm() - b.x() * a.squaredNorm()) /
                            (2 * twice_area);
        const Vec2 start = -centre, end = b - centre;
        double sweep = std::atan2(cross(start, end), start.dot(end));
        // Walked left-about when the point lies to the right of the chord.
        const bool left_about = twice_area > 0;
        if (left_about && sweep <= 0) sweep += 2 * std::numbers::pi;
        if (!left_about && sweep >= 0) sweep -= 2 * std::numbers::pi;
        std::vector<Vec2> points;
        for (const double s : fractions) {
            const double c = std::cos(s * sweep), d = std::sin(s * sweep);
            points.push_back(from + centre +
                             Vec2(c * start.x() - d * start.y(), d * start.x() + c * start.y()));
        }
        return points;
    }

    std::vector<Vec2> operator()(const Polyline& line) const {
        std::vector<Vec2> corners{from};
        corners.insert(corners.end(), line.points.begin(), line.points.end());
        corners.push_back(to);
        std::vector<double> length{0};
        for (std::size_t i = 1; i < corners.size(); ++i) {
            length.push_back(length.back() + (corners[i] - corners[i - 1]).norm());
            if (!(length[i] > length[i - 1]))
                throw std::invalid_argument("two points of the polyline coincide; leave one out");
        }
        std::vector<Vec2> points;
        std::size_t part = 1;
        for (const double s : fractions) {
            const double at = s * length.back();
            while (part + 1 < corners.size() && length[part] < at) ++part;
            points.push_back(lerp(corners[part - 1], corners[part],
                                  (at - length[part - 1]) / (length[part] - length[part - 1])));
        }
        return points;
    }

    std::vector<Vec2> operator()(const FormulaSide& side) const {
        std::vector<Vec2> points;
        for (const double s : fractions) points.push_back(lerp(from, to, s));
        const auto& [by, names] = side.of;
        for (std::size_t i = 0; i < 2; ++i) {
            if (!by[i]) continue;
            // With both formulas the variable is s, with one the other coordinate, still on its straight
            // line.
            const bool both = by[1 - i].has_value();
            const auto own = static_cast<Eigen::Index>(i);
            BoundFormula formula(*by[i]);
            for (std::size_t p = 0; p < points.size(); ++p) {
                formula.set(both ? "s" : names[1 - i], both ? fractions[p] : points[p][1 - own]);
                points[p][own] = formula.value();
            }
            require_end(*by[i], names[i], points.front()[own], from[own], "begins");
            require_end(*by[i], names[i], points.back()[own], to[own], "ends");
        }
        return points;
    }

    void require_end(const Formula& formula, const std::string& name, double found, double corner,
                     const char* verb) const {
        if (std::abs(found - corner) > 1e-6 * (to - from).norm())
            throw FormulaError(formula, fmt::format("{} at {} = {:.9g}, but the corner there has {} = {:.9g}",
                                                    verb, name, found, name, corner));
    }

    static Vec2 lerp(const Vec2& a, const Vec2& b, double s) {
        return {std::lerp(a.x(), b.x(), s), std::lerp(a.y(), b.y(), s)};
    }
};

struct Measure {
    Vec2 from, to;

    double operator()(const Straight&) const { return (to - from).norm(); }
    double operator()(const Polyline& line) const {
        double sum = 0;
        Vec2 last = from;
        for (const auto& point : line.points) sum += (point - last).norm(), last = point;
        return sum + (to - last).norm();
    }
    template <class Curved>
    double operator()(const Curved& curved) const {
        const auto points = points_along(curved, from, to, graded_fractions(1000, 1));
        return (*this)(Polyline{points});
    }
};

}  // namespace

double side_length(const EdgeShape& shape, const Vec2& from, const Vec2& to) {
    return std::visit(Measure{from, to}, shape);
}

std::vector<double> graded_fractions(int n, double ratio) {
    std::vector<double> fractions(static_cast<std::size_t>(n) + 1, 0.0);
    if (ratio == 1 || n == 1) {
        for (int i = 0; i <= n; ++i) fractions[static_cast<std::size_t>(i)] = static_cast<double>(i) / n;
        return fractions;
    }
    const double quotient = std::pow(ratio, 1.0 / (n - 1));
    double interval = 1;
    for (std::size_t i = 1; i < fractions.size(); ++i, interval *= quotient)
        fractions[i] = fractions[i - 1] + interval;
    const double sum = fractions.back();
    for (double& fraction : fractions) fraction /= sum;
    return fractions;
}

std::vector<Vec2> points_along(const EdgeShape& shape, const Vec2& from, const Vec2& to,
                               const std::vector<double>& fractions) {
    auto points = std::visit(Evaluate{from, to, fractions}, shape);
    points.front() = from;
    points.back() = to;
    return points;
}

}  // namespace percuss
