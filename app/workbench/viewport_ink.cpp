#include "workbench/viewport_ink.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "view/outline.hpp"
#include "workbench/panels/panel.hpp"
#include "workbench/viewport_actions.hpp"

namespace percuss::app {
namespace {

constexpr render::Colour reference_colour = 0x3aa0ff,  // told from arrows and from viridis
    ghost_colour = 0x9aa0a8, failure_colour = 0xe02020;

/// Null when there is no reference beside this moment.
std::shared_ptr<const Snapshot> reference_at(const Workbench& w,
                                             const std::shared_ptr<const Snapshot>& shown) {
    if (!w.reference || w.reference->history == w.run.history()) return nullptr;
    const bool on_screen = shown == w.run.snapshot();
    const auto moment = on_screen ? w.reference->moment : w.reference->moments(shown->time);
    return moment ? moment : w.reference->moment;
}

/// The ghost is for whoever waits for a new design, not for films.
std::shared_ptr<const Snapshot> ghost_at(const Workbench& w, const std::shared_ptr<const Snapshot>& shown) {
    return shown == w.run.snapshot() ? w.ghost.moment : nullptr;
}

/// The element that a diverged run's message names.
void mark_failure(const render::LiveView& view, const Snapshot& shown, double scale, render::Canvas& canvas) {
    if (shown.status != RunStatus::diverged || shown.failed_cell < 0) return;
    std::vector<std::array<double, 2>> corners;
    for (const std::int32_t node : shown.setup->mesh.cells[static_cast<std::size_t>(shown.failed_cell)]) {
        if (node < 0) continue;
        const auto at = 2 * static_cast<std::size_t>(node);
        corners.push_back(view.fit()(view.plane()(shown.position[at], shown.position[at + 1])));
    }
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto& a = corners[i];
        const auto& b = corners[(i + 1) % corners.size()];
        canvas.line(a[0], a[1], b[0], b[1], failure_colour, 3 * scale);
    }
}

/// Words in a corner of the picture.
struct Note {
    std::string words;
    render::Colour colour;  // of the line before them
    render::Rect plate;     // beneath both
};

constexpr double plate_opacity = 0.75;

render::TextStyle time_style(double scale) {
    return {15 * scale, render::ink::text, render::Align::right, render::VerticalAlign::top, true};
}

std::string time_words(const Snapshot& shown) {
    const Scene& scene = shown.setup->scene;
    const DisplayUnit unit = scene.units.display(Quantity::time, scene.duration);
    const double largest = unit.scale * scene.duration;
    const int decimals =
        largest > 0 ? std::clamp(3 - static_cast<int>(std::floor(std::log10(largest))), 0, 6) : 1;
    return fmt::format("t = {:.{}f} {}", unit.scale * shown.time, decimals, unit.label);
}

render::TextStyle note_style(double scale) {
    return {13 * scale, render::ink::text, render::Align::left, render::VerticalAlign::centre, false};
}

/// Whose outlines they are, and when.
std::vector<Note> outline_notes(const Workbench& w, const render::LiveView& view,
                                const std::shared_ptr<const Snapshot>& shown, double scale,
                                render::Canvas& canvas) {
    const Units& units = shown->setup->scene.units;
    std::vector<Note> notes;
    if (const auto moment = reference_at(w, shown)) {
        const Curves& curves = w.reference->curves;
        const bool ended = moment->time < shown->time && curves.rows() > 0 &&
                           curves.times()[curves.rows() - 1] < shown->time;
        const std::string when = quantity_text(units, Quantity::time, moment->time);
        notes.push_back(
            {ended ? fmt::format("reference, ended at {}", when) : "reference", reference_colour, {}});
    }
    if (const auto moment = ghost_at(w, shown))
        notes.push_back(
            {fmt::format("design before, at {}", quantity_text(units, Quantity::time, moment->time)),
             ghost_colour,
             {}});
    const double left = view.model().x + 12 * scale, row = 20 * scale;
    const double time_left =
        view.model().right() - 18 * scale - canvas.text_size(time_words(*shown), time_style(scale))[0];
    double y = view.model().top() - (w.beside.empty() ? 18 : 42) * scale;  // under the label
    for (Note& note : notes)
        note.plate = {left - 4 * scale, 0, 36 * scale + canvas.text_size(note.words, note_style(scale))[0],
                      row};
    const bool clash = std::any_of(notes.begin(), notes.end(),
                                   [&](const Note& note) { return note.plate.right() > time_left; });
    if (clash && w.beside.empty()) y -= 24 * scale;  // under the time
    for (Note& note : notes) {
        note.plate.y = y - 0.5 * row;
        y -= row;
    }
    return notes;
}

void write_outlines(const std::vector<Note>& notes, double scale, render::Canvas& canvas) {
    for (const auto& [words, colour, plate] : notes) {
        const double left = plate.x + 4 * scale, y = plate.y + 0.5 * plate.height;
        canvas.rectangle(plate, render::ink::white, plate_opacity);
        canvas.line(left, y, left + 21 * scale, y, colour, 2 * scale);
        canvas.text(left + 28 * scale, y, words, note_style(scale));
    }
}

}  // namespace

void write_time(const render::LiveView& view, const Snapshot& shown, double scale, render::Canvas& canvas) {
    const std::string time = time_words(shown);
    const render::TextStyle style = time_style(scale);
    const double pad = 10.5 * scale, rim = 3 * scale;
    const double right = view.model().right() - pad, top = view.model().top() - pad;
    const auto [width, height] = canvas.text_size(time, style);
    canvas.rectangle({right - width - rim, top - height - rim, width + 2 * rim, height + 2 * rim},
                     render::ink::white, plate_opacity);
    canvas.text(right, top, time, style);
}

std::vector<render::Rect> places_of_words(const Workbench& w, const render::LiveView& view,
                                          const std::shared_ptr<const Snapshot>& shown, double scale,
                                          render::Canvas& canvas) {
    std::vector<render::Rect> places;
    for (const Note& note : outline_notes(w, view, shown, scale, canvas)) places.push_back(note.plate);
    return places;
}

void write_label(const render::LiveView& view, const std::string& label, double scale,
                 render::Canvas& canvas) {
    const double pad = 10.5 * scale;
    canvas.text(view.model().x + pad, view.model().top() - pad, label,
                {15 * scale, render::ink::text, render::Align::left, render::VerticalAlign::top, true});
}

void paint_beneath(const Workbench& w, const render::LiveView& view,
                   const std::shared_ptr<const Snapshot>& shown, double scale, render::Canvas& canvas) {
    const auto outline = [&](const Snapshot& moment, render::Colour colour, double width) {
        render::paint_outline(canvas, moment, view.plane(), view.fit(), view.model(), colour, width * scale);
    };
    if (const auto moment = ghost_at(w, shown)) outline(*moment, ghost_colour, 1.2);
    if (const auto moment = reference_at(w, shown)) outline(*moment, reference_colour, 1.5);
    mark_failure(view, *shown, scale, canvas);
}

void paint_above(const Workbench& w, const render::LiveView& view,
                 const std::shared_ptr<const Snapshot>& shown, double scale, render::Canvas& canvas) {
    paint_marks(w, view, *shown, scale, canvas);
    write_time(view, *shown, scale, canvas);
    if (!w.beside.empty()) write_label(view, label_of(w.run), scale, canvas);
    write_outlines(outline_notes(w, view, shown, scale, canvas), scale, canvas);
}

}  // namespace percuss::app
