#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "run/history.hpp"
#include "run/probes.hpp"
#include "run/snapshot.hpp"

namespace percuss {

class Solver;

/// A probe that was set while the run went on, and what it has read since: a row a step, as a probe of the
/// scene has in the histories of the run.
struct SetProbe {
    Probe probe;
    std::shared_ptr<const History> rows;  ///< "time", then "probe.NAME.QUANTITY" for each quantity
};

/// Reads the probes that were set while a run goes on; each has rows of its own, from the step that follows.
class ProbeRecorder {
  public:
    /// @param history_memory of the rows of each probe [bytes]; 0: no bound.
    explicit ProbeRecorder(std::size_t history_memory = 0) : history_memory_(history_memory) {}
    /// @throws std::invalid_argument when the scene lacks its body or a quantity, or its name is taken.
    void add(const RunSetup& setup, const Probe& probe);
    void remove(std::string_view name);  ///< nothing happens when there is none
    [[nodiscard]] bool none() const { return entries_.empty(); }
    [[nodiscard]] std::vector<SetProbe> probes() const;

    void before_step(const Solver& solver);
    /// @param time at which the step began [time]
    void after_step(const Solver& solver, double time);
    /// The run goes on from an earlier moment: what was read there or later is dropped. Who holds the former
    /// rows keeps them whole [time].
    void branch(double time);

  private:
    struct Entry {
        Probe probe;
        std::vector<ProbeReading> readings;
        std::vector<double> row;   // of the step that is being made: time, then the values of cells
        std::vector<Node> before;  // of the nodes, when the step began
        std::shared_ptr<History> rows;
    };
    std::size_t history_memory_;
    std::vector<Entry> entries_;
};

}  // namespace percuss
