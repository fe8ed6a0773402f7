#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "run/probe_recorder.hpp"
#include "run/snapshot.hpp"

namespace percuss::app {

/// Probes of a recorded run: it has no rows of them, so that they are read off its frames, one after the
/// other. Whoever reads the frames hands them over in the order that next() asks for. For one thread at a
/// time; the rows are read by any (History).
class FrameSurvey {
  public:
    /// Begins at the first frame. @pre the scene of `setup` has the probe's body and quantities.
    void add(const RunSetup& setup, const Probe& probe);
    void remove(const std::string& name);
    /// The frame that is to be taken next; -1: every probe has all `frames`.
    [[nodiscard]] std::int64_t next(std::int64_t frames) const;
    /// A frame for the probes that wait for it. @param frame null: it cannot be read and is left out.
    void take(std::int64_t index, const Snapshot* frame);
    /// "time", then "probe.NAME.QUANTITY" for each quantity, a row a frame.
    [[nodiscard]] std::vector<SetProbe> probes() const;

  private:
    struct Reader {
        Probe probe;
        std::vector<ProbeReading> readings;
        std::shared_ptr<History> rows;
        std::int64_t next = 0;
    };
    std::vector<Reader> readers_;
};

}  // namespace percuss::app
