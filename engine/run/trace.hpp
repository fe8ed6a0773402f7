#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "run/fields.hpp"
#include "run/history.hpp"
#include "run/snapshot.hpp"

namespace percuss {

class Solver;

/// A quantity recorded over time at a chain of points of a body, for one figure of the scene.
struct Trace {
    std::string name;  ///< of the figure
    Quantity quantity = Quantity::stress;
    std::size_t components = 1;  ///< numbers a point: 1 of a field, 2 of a force (first, second direction)
    std::vector<Vec2> points;    ///< in the undeformed body [length]
    std::vector<double>
        along;  ///< per point: distance from the line's start, or arc length of the edge [length]
    std::shared_ptr<const History> rows;  ///< column "time", then `components` for each point
};

/// Columns of the trace's rows.
[[nodiscard]] std::vector<HistoryColumn> trace_columns(const Trace& trace);

/// Samples the traces that a scene's figures need while the solver steps.
///
/// A space-time figure gives a field trace: the cells that its line crosses, each at the middle of its
/// stretch; a field of nodes is the mean of the cell's corners. Rows hold the state at the first step that
/// reaches each multiple of the interval.
///
/// A surface-forces figure gives a force trace: contact forces on the nodes of its edge [force], full ring
/// when axisymmetric. A row is the mean over one interval and stands at its middle: no step's impulse is
/// lost.
class TraceRecorder {
  public:
    /// @throws SceneError when a line does not cross its body.
    explicit TraceRecorder(const RunSetup& setup);

    [[nodiscard]] const std::vector<Trace>& traces() const { return traces_; }
    [[nodiscard]] bool none() const { return traces_.empty(); }
    void before_step(const Solver& solver);
    /// How far the sampling has come, to go back to.
    struct Progress {
        std::size_t rows = 0;
        std::int64_t next = 0;
        std::vector<double> impulse;
        double begin = 0;
    };
    [[nodiscard]] std::vector<Progress> progress() const;  ///< per trace
    /// A recorder that goes on from an earlier moment of this one: it shares the rows up to then, and those
    /// that it appends are its own.
    [[nodiscard]] TraceRecorder from(const std::vector<Progress>& progress) const;
    /// @param time of the state that the step began with, which its contact forces belong to
    void after_step(const Solver& solver, double time);

  private:
    struct Line {
        FieldInfo field;
        std::int32_t body = 0;
        std::vector<std::int32_t> cells;
    };
    struct Surface {
        std::vector<std::int32_t> place_of_node;  // per node of the mesh: its place in the edge, or -1
        std::vector<double> impulse;              // since `begin`, 2 a point
        double begin = 0;
    };
    struct Recording {
        std::shared_ptr<History> rows;
        double interval = 0;
        std::int64_t next = 0;  // multiples of the interval done
        Line line;              // one of the two has points
        Surface surface;
    };

    void add_line(const RunSetup& setup, const FigureSpec& figure);
    void add_surface(const RunSetup& setup, const FigureSpec& figure);
    void add(const FigureSpec& figure, double duration, Trace trace, Recording recording);
    void sample_line(const Line& line, const Solver& solver);

    std::vector<Trace> traces_;
    std::vector<Recording> recordings_;
    Snapshot scratch_;  // its contact forces
    std::vector<double> row_;
};

}  // namespace percuss
