#pragma once

#include <string>

#include "workbench/workbench.hpp"

namespace percuss::app {

// What can be done at a place of the picture.

/// Puts a probe of a field into the picked cell or at the picked node. @pre something is picked.
void add_probe_at(Workbench& workbench, const render::Picked& place, const std::string& field);
void remove_all_probes(Workbench& workbench);
/// The picture moves with a node, which stays where it is in it.
void follow_node(Workbench& workbench, std::int32_t node);
void stop_following(Workbench& workbench);
void zoom_to(Workbench& workbench, std::size_t body);
/// Pans and zooms; a node that is followed is followed from there.
void move_camera(Workbench& workbench, const render::LiveCamera& camera);

/// Takes over what the run has come to: probes, another setup. Once a frame.
void follow_run(Workbench& workbench);
/// The picture's centre that keeps the followed node where it is in it, if one is followed [length].
[[nodiscard]] std::optional<std::array<double, 2>> centre_after_node(const Workbench& workbench,
                                                                     const Snapshot& shown);
/// Moves the picture after the node that it follows. @param shown the moment that is drawn next
void move_after_node(Workbench& workbench, const Snapshot& shown);

/// Pair surfaces, probes and the followed node. @param scale of ink: 1 is text of 15 pixels.
void paint_marks(const Workbench& workbench, const render::LiveView& view, const Snapshot& shown,
                 double scale, render::Canvas& canvas);

}  // namespace percuss::app
