#pragma once

#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include "live/frame_survey.hpp"
#include "run/history.hpp"
#include "run/snapshot.hpp"
#include "run/trace.hpp"

namespace percuss::app {

/// A recorded run as its file gives it. Asked by one thread at a time; throws std::exception, naming file and
/// reason, for what cannot be read.
class RunSource {
  public:
    virtual ~RunSource() = default;
    RunSource() = default;
    RunSource(const RunSource&) = delete;
    RunSource& operator=(const RunSource&) = delete;
    [[nodiscard]] virtual std::vector<double> frame_times() = 0;  ///< ascending [time]
    [[nodiscard]] virtual std::shared_ptr<const Snapshot> frame(std::int64_t index) = 0;
    [[nodiscard]] virtual std::shared_ptr<const History> history() = 0;
    [[nodiscard]] virtual std::vector<Trace> traces() = 0;  ///< what the scene's figures sampled
};
/// Opens run.h5. @throws std::exception naming file and reason.
using OpenRun = std::function<std::unique_ptr<RunSource>(const std::filesystem::path&)>;

/// A recorded run to look at: its frames are read as they are asked for, on a thread of its own, so that
/// whoever shows them never waits for the disk. Those asked for last are kept, within a bound of memory.
class Recording {
  public:
    /// Reads what is needed for a first picture, histories and traces: not for a thread that must not wait.
    /// @param bound of the frames that are kept [bytes]; the one that was asked for last is kept in any case.
    /// @throws std::exception, for a run without a frame, too.
    Recording(const std::filesystem::path& file, const OpenRun& open, std::size_t bound);
    ~Recording();  ///< waits for the frame that is being read
    Recording(const Recording&) = delete;
    Recording& operator=(const Recording&) = delete;

    [[nodiscard]] const std::vector<double>& times() const { return times_; }  ///< of the frames [time]
    [[nodiscard]] const std::shared_ptr<const History>& history() const { return history_; }
    [[nodiscard]] const std::vector<Trace>& traces() const { return traces_; }
    /// Index of the newest frame that is not later than `time`; 0 when all are [time].
    [[nodiscard]] std::int64_t index_at(double time) const;
    /// That frame; null while it is being read: ask again. A frame that is damaged gives the one before.
    [[nodiscard]] std::shared_ptr<const Snapshot> frame_at(double time);
    /// The frame that was read last, to show meanwhile.
    [[nodiscard]] std::shared_ptr<const Snapshot> last_read() const;
    [[nodiscard]] bool reading() const;  ///< whether a frame that was asked for is not there yet
    [[nodiscard]] std::size_t bytes() const;
    /// Reads a probe off all frames, from the first one on, while nothing is asked for that is to be shown.
    /// @pre the scene has its body and quantities.
    void add_probe(const Probe& probe);
    void remove_probe(const std::string& name);
    /// A row for each frame that was read so far.
    [[nodiscard]] std::vector<SetProbe> probes() const;
    [[nodiscard]] bool reading_probes() const;  ///< whether there are frames that a probe has not seen
    /// What could not be read, oldest first; emptied by the call.
    [[nodiscard]] std::vector<std::string> take_messages();

  private:
    struct Kept {
        std::shared_ptr<const Snapshot> frame;
        std::size_t bytes = 0;
        std::int64_t asked = 0;  // when, by count
    };
    void serve();
    [[nodiscard]] std::int64_t next_to_read() const;                      // to be kept; -1: nothing
    void survey(std::unique_lock<std::mutex>& lock, std::int64_t index);  // the lock is held before and after
    void keep(std::int64_t index, std::shared_ptr<const Snapshot> frame);
    [[nodiscard]] bool at_hand(std::int64_t index) const {
        return kept_.contains(index) || damaged_.contains(index);
    }

    std::unique_ptr<RunSource> source_;  // the thread's once that runs
    std::vector<double> times_;
    std::shared_ptr<const History> history_;
    std::vector<Trace> traces_;
    std::size_t bound_;

    mutable std::mutex mutex_;  // never held while the disk is read
    std::condition_variable asked_;
    std::vector<std::int64_t> wanted_;  // newest last
    std::map<std::int64_t, Kept> kept_;
    std::set<std::int64_t> damaged_;
    std::shared_ptr<const Snapshot> last_read_;
    std::size_t bytes_ = 0;
    std::int64_t asked_for_ = 0, asks_ = 0;
    std::vector<std::string> messages_;
    FrameSurvey survey_;
    bool stop_ = false;
    std::thread thread_;
};

}  // namespace percuss::app
