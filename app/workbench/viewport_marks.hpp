#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "live/probe_curves.hpp"
#include "view/contact_sides.hpp"
#include "view/pick.hpp"

namespace percuss::app {

/// A node that the picture follows.
struct FollowedNode {
    std::int32_t node = 0;
    std::string body;
    std::array<double, 2> start{0,
                                0};  ///< its place in the undeformed body, to find it in a new mesh [length]
    std::array<double, 2> offset{0, 0};  ///< of the picture's centre from it, in picture coordinates [length]
};

/// What is drawn over the mesh beside arrows and labels, and what is done at places of it.
struct ViewportMarks {
    enum class Pairs { none, all, one } pairs = Pairs::none;
    std::size_t pair = 0;                     ///< of Pairs::one
    std::optional<std::size_t> hovered_pair;  ///< pointed at in a list in this frame: shown alone
    std::shared_ptr<const RunSetup> setup;    // what the rest is for
    std::vector<render::ContactSides> sides;  // per pair, once they are asked for
    std::vector<ProbeCurve> scene_probes;     ///< places of the scene's own; their curves are the run's
    ProbeCurves probes;                       ///< of the window
    int probe_changes = 0;                    ///< how often others have come
    bool list_probes = false;                 ///< the first one has come: the list opens
    std::string hovered_probe;                ///< pointed at in a list in this frame
    std::optional<FollowedNode> followed;
    render::Picked menu;            ///< what the menu of the picture is about
    std::optional<double> clicked;  ///< when a body was clicked that may yet be a double click [s]
    std::array<float, 2> click_at{0, 0};
};

}  // namespace percuss::app
