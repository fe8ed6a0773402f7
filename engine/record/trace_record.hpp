#pragma once

#include "record/hdf5.hpp"
#include "run/trace.hpp"

namespace percuss {

/// Writes one trace into /traces as it grows: points, then rows as they come. Private to engine/record.
class TraceWriter {
  public:
    /// Creates the trace's group below `traces`.
    TraceWriter(hid_t traces, const Trace& trace, const Units& units);
    /// Appends the rows that came since the last call, without counting them.
    void append();
    /// Counts what was appended, after it was flushed.
    void count();

  private:
    Trace trace_;
    hdf5::Handle group_;
    hdf5::Rows time_, value_;
    hdf5::Counter rows_;
    std::size_t written_ = 0;
};

/// All traces of a run; none when it was recorded without.
[[nodiscard]] std::vector<Trace> read_traces(hid_t file);

}  // namespace percuss
