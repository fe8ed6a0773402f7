#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "mesh/mesh.hpp"
#include "scene/place.hpp"

namespace percuss {

enum class FigureKind {
    history,         ///< history columns against time
    mesh,            ///< the deformed mesh at some times, side by side
    space_time,      ///< a field along a line through a body, over time
    surface_forces,  ///< contact force per length along an edge of a body, over time
    clamping,        ///< forces between bodies: peaks and what remains
    energy,          ///< where the energy is, over time
};

/// One figure of a run, as [[figure]] declares it. Numbers are in scene units; what is absent follows from
/// the run.
struct FigureSpec {
    std::string name;  ///< of its file
    FigureKind kind = FigureKind::history;
    std::string title;
    std::optional<std::array<double, 2>> time;   ///< shown times [time]
    std::optional<std::array<double, 2>> range;  ///< shown values, after `factor` [unit of the value]

    // history, clamping
    std::vector<std::string> columns;  ///< history columns, or pairs for clamping (empty: all)
    std::vector<std::string> labels;   ///< of the columns in the legend; as many, or none
    std::string value_title;           ///< of the value axis, without unit
    double factor = 1;                 ///< multiplies the values: -1 turns the sign
    double window = 0;                 ///< of the moving average; 0: none [time]

    // mesh, and `times` for profiles of surface_forces
    std::vector<double> times;                    ///< [time]
    std::optional<std::array<double, 4>> region;  ///< shown {min, min, max, max} [length]
    std::string field;                            ///< "" draws the bodies in plain colours
    std::string colour_map = "viridis";

    // space_time, surface_forces
    std::string body, edge;  ///< edge: surface_forces only
    std::optional<std::array<Vec2, 2>>
        line;                        ///< ends, in the undeformed body; absent: its longer middle line
    std::optional<double> interval;  ///< simulated time between samples [time]; absent: duration / 400
    std::size_t direction = 1;       ///< surface_forces: component of the force that is drawn
    std::optional<std::size_t>
        along;      ///< coordinate along which forces are counted; absent: arc length of the edge
    int bins = 40;  ///< surface_forces: parts of that length

    Place place;
    bool operator==(const FigureSpec&) const = default;
};

/// What [analysis] asks to be computed beside the histories.
struct Analysis {
    double residual = 0.1;         ///< last part of the run over which residual forces are means, 0 to 1
    std::optional<double> window;  ///< of the moving average of peak forces [time]; absent: duration / 200
    /// An estimate of the force that pulls a body out: friction times the residual normal forces on it.
    struct PullOut {
        std::string body;
        double friction = 0;             ///< Coulomb's coefficient
        std::vector<std::string> pairs;  ///< contacts counted; empty: all of the body
        bool operator==(const PullOut&) const = default;
    };
    std::optional<PullOut> pull_out;
    bool operator==(const Analysis&) const = default;
};

}  // namespace percuss
