#include "run/trace.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "scene/parse.hpp"
#include "solver.hpp"

namespace percuss {
namespace {

constexpr double samples_by_default = 400;

const MeshBody& body_of(const Mesh& mesh, const std::string& name) {
    return *std::find_if(mesh.bodies.begin(), mesh.bodies.end(),
                         [&](const MeshBody& body) { return body.name == name; });
}

const Edge& edge_of(const MeshBody& body, const std::string& name) {
    return *std::find_if(body.edges.begin(), body.edges.end(),
                         [&](const Edge& edge) { return edge.name == name; });
}

/// The stretch of a line inside a convex cell, as parts of the line from 0 to 1 (Cyrus & Beck); a line along
/// a side is inside.
std::optional<std::array<double, 2>> stretch_in(const Mesh& mesh, const Cell& cell, const Vec2& from,
                                                const Vec2& along) {
    std::array<double, 2> stretch{0, 1};
    const auto corners = static_cast<std::size_t>(corner_count(cell));
    for (std::size_t i = 0; i < corners; ++i) {
        const Vec2& a = mesh.nodes[static_cast<std::size_t>(cell[i])];
        const Vec2 side = mesh.nodes[static_cast<std::size_t>(cell[(i + 1) % corners])] - a;
        const Vec2 inwards(-side.y(), side.x());
        const double depth = inwards.dot(from - a), change = inwards.dot(along);
        const double tolerance = 1e-9 * side.norm() * along.norm();
        if (std::abs(change) <= tolerance) {
            if (depth < -tolerance) return std::nullopt;
        } else if (change > 0) {
            stretch[0] = std::max(stretch[0], -depth / change);
        } else {
            stretch[1] = std::min(stretch[1], -depth / change);
        }
    }
    if (stretch[1] - stretch[0] <= 1e-9) return std::nullopt;
    return stretch;
}

/// The line along the longer direction of a body: on the axis when it has nodes there, else through the
/// middle of its box.
std::array<Vec2, 2> middle_line(const Mesh& mesh, const MeshBody& body, Geometry geometry) {
    Vec2 low = mesh.nodes[static_cast<std::size_t>(body.node_begin)], high = low;
    for (auto n = static_cast<std::size_t>(body.node_begin); n < static_cast<std::size_t>(body.node_end);
         ++n) {
        low = low.cwiseMin(mesh.nodes[n]);
        high = high.cwiseMax(mesh.nodes[n]);
    }
    const Eigen::Index longer = high.y() - low.y() >= high.x() - low.x() ? 1 : 0, other = 1 - longer;
    const bool on_axis = geometry == Geometry::axisymmetric && other == 0 && low.x() <= 0;
    std::array<Vec2, 2> line{low, high};
    for (Vec2& end : line) end[other] = on_axis ? 0 : 0.5 * (low[other] + high[other]);
    return line;
}

}  // namespace

std::vector<HistoryColumn> trace_columns(const Trace& trace) {
    std::vector<HistoryColumn> columns{{"time", Quantity::time}};
    for (std::size_t k = 0; k < trace.components * trace.points.size(); ++k)
        columns.push_back({std::to_string(k), trace.quantity});
    return columns;
}

TraceRecorder::TraceRecorder(const RunSetup& setup) {
    for (const FigureSpec& figure : setup.scene.figures) {
        if (figure.kind == FigureKind::space_time) add_line(setup, figure);
        if (figure.kind == FigureKind::surface_forces) add_surface(setup, figure);
    }
}

void TraceRecorder::add_line(const RunSetup& setup, const FigureSpec& figure) {
    const Mesh& mesh = setup.mesh;
    const MeshBody& body = body_of(mesh, figure.body);
    const auto line = figure.line ? *figure.line : middle_line(mesh, body, setup.scene.geometry);
    const Vec2 direction = line[1] - line[0];
    struct Crossing {
        std::int32_t cell;
        double begin, end;
        [[nodiscard]] double middle() const { return 0.5 * (begin + end); }
    };
    std::vector<Crossing> crossings;
    for (std::int32_t cell = body.cell_begin; cell < body.cell_end; ++cell) {
        const auto stretch = stretch_in(mesh, mesh.cells[static_cast<std::size_t>(cell)], line[0], direction);
        if (stretch) crossings.push_back({cell, (*stretch)[0], (*stretch)[1]});
    }
    if (crossings.empty())
        throw SceneError({fmt::format(
            "{}: the line of figure '{}' does not cross body '{}'; give ends 'from' and 'to' inside "
            "it, or leave both out",
            describe_place(setup.scene, figure.place), figure.name, figure.body)});
    std::stable_sort(crossings.begin(), crossings.end(),
                     [](const Crossing& a, const Crossing& b) { return a.middle() < b.middle(); });

    Trace trace;
    Recording recording;
    recording.line.field = find_field(setup.scene, figure.field);
    recording.line.body = static_cast<std::int32_t>(&body - mesh.bodies.data());
    trace.quantity = recording.line.field.quantity;
    double reached = 0;
    for (const Crossing& crossing : crossings) {
        // A line along the sides of cells is inside those on both sides of it.
        if (crossing.middle() <= reached && !trace.points.empty()) continue;
        reached = crossing.end;
        recording.line.cells.push_back(crossing.cell);
        trace.points.push_back(line[0] + crossing.middle() * direction);
        trace.along.push_back(crossing.middle() * direction.norm());
    }
    add(figure, setup.scene.duration, std::move(trace), std::move(recording));
}

void TraceRecorder::add_surface(const RunSetup& setup, const FigureSpec& figure) {
    const Mesh& mesh = setup.mesh;
    const Edge& edge = edge_of(body_of(mesh, figure.body), figure.edge);
    Trace trace;
    Recording recording;
    trace.quantity = Quantity::force;
    trace.components = 2;
    recording.surface.place_of_node.assign(mesh.nodes.size(), -1);
    recording.surface.impulse.assign(2 * edge.nodes.size(), 0);
    for (std::size_t k = 0; k < edge.nodes.size(); ++k) {
        const auto node = static_cast<std::size_t>(edge.nodes[k]);
        recording.surface.place_of_node[node] = static_cast<std::int32_t>(k);
        trace.along.push_back(k == 0 ? 0
                                     : trace.along.back() + (mesh.nodes[node] - trace.points.back()).norm());
        trace.points.push_back(mesh.nodes[node]);
    }
    add(figure, setup.scene.duration, std::move(trace), std::move(recording));
}

void TraceRecorder::add(const FigureSpec& figure, double duration, Trace trace, Recording recording) {
    recording.interval = figure.interval.value_or(duration / samples_by_default);
    recording.rows = std::make_shared<History>(trace_columns(trace));
    trace.name = figure.name;
    trace.rows = recording.rows;
    traces_.push_back(std::move(trace));
    recordings_.push_back(std::move(recording));
}

void TraceRecorder::before_step(const Solver& solver) {
    for (Recording& recording : recordings_) {
        if (recording.line.cells.empty()) continue;
        const auto due = [&] {
            return solver.time() >= static_cast<double>(recording.next) * recording.interval * (1 - 1e-12);
        };
        if (!due()) continue;
        row_.assign(1, solver.time());
        sample_line(recording.line, solver);
        recording.rows->append(row_);
        while (due()) ++recording.next;
    }
}

void TraceRecorder::after_step(const Solver& solver, double time) {
    const bool wanted = std::any_of(recordings_.begin(), recordings_.end(),
                                    [](const Recording& r) { return !r.surface.impulse.empty(); });
    if (!wanted) return;
    scratch_.contact_forces.clear();
    scratch_.pairs.clear();
    solver.add_contacts(&scratch_);
    const double now = solver.time(), dt = now - time;
    for (Recording& recording : recordings_) {
        Surface& surface = recording.surface;
        if (surface.impulse.empty()) continue;
        for (const ContactForce& contact : scratch_.contact_forces) {
            const std::int32_t place = surface.place_of_node[static_cast<std::size_t>(contact.node)];
            if (place < 0) continue;
            for (std::size_t d = 0; d < 2; ++d)
                surface.impulse[2 * static_cast<std::size_t>(place) + d] += dt * contact.force[d];
        }
        const double end = static_cast<double>(recording.next + 1) * recording.interval;
        if (now < end * (1 - 1e-12)) continue;
        row_.assign(1, 0.5 * (surface.begin + now));
        for (double& impulse : surface.impulse) {
            row_.push_back(impulse / (now - surface.begin));
            impulse = 0;
        }
        recording.rows->append(row_);
        surface.begin = now;
        while (now >= static_cast<double>(recording.next + 1) * recording.interval * (1 - 1e-12))
            ++recording.next;
    }
}

std::vector<TraceRecorder::Progress> TraceRecorder::progress() const {
    std::vector<Progress> all;
    for (const Recording& r : recordings_)
        all.push_back({r.rows->rows(), r.next, r.surface.impulse, r.surface.begin});
    return all;
}

TraceRecorder TraceRecorder::from(const std::vector<Progress>& progress) const {
    TraceRecorder recorder = *this;
    for (std::size_t k = 0; k < recordings_.size(); ++k) {
        Recording& recording = recorder.recordings_[k];
        recording.rows = recording.rows->first(progress[k].rows);
        recording.next = progress[k].next;
        recording.surface.impulse = progress[k].impulse;
        recording.surface.begin = progress[k].begin;
        recorder.traces_[k].rows = recording.rows;
    }
    return recorder;
}

void TraceRecorder::sample_line(const Line& line, const Solver& solver) {
    const Mesh& mesh = solver.setup()->mesh;
    const Node* nodes = solver.nodes().data();
    const Batch& batch = solver.batches()[static_cast<std::size_t>(line.body)];
    for (const std::int32_t cell : line.cells) {
        if (line.field.per_cell) {
            row_.push_back(line.field.of_cell(cell_values(batch, nodes, cell - batch.cell_begin)));
            continue;
        }
        const Cell& corners = mesh.cells[static_cast<std::size_t>(cell)];
        const auto count = static_cast<std::size_t>(corner_count(corners));
        double sum = 0;
        for (std::size_t i = 0; i < count; ++i) {
            const auto n = static_cast<std::size_t>(corners[i]);
            sum += line.field.of_node(nodes[n].x, nodes[n].v, mesh.nodes[n].data());
        }
        row_.push_back(sum / static_cast<double>(count));
    }
}

}  // namespace percuss
