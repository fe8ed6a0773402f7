#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "live/live_run.hpp"
#include "live/reference.hpp"

namespace percuss::app {

/// A run of the same scene that goes beside the one that a window shows, by another scheme or with other
/// values. It has an engine of its own, which never runs ahead of the time that the window's run has reached,
/// and shows the moment that the window shows.
class BesideRun {
  public:
    /// @param overrides "key=value", as --set: all that the run is given. @param label tells it from others
    BesideRun(const std::filesystem::path& file, const std::vector<std::string>& overrides, std::string label,
              int threads);

    /// Once a frame. @param reached newest time of the window's run. @param shown the time that is looked at
    /// [time]
    void follow(double reached, double shown);

    [[nodiscard]] const std::string& label() const { return label_; }
    [[nodiscard]] const LiveRun& run() const { return run_; }
    /// The moment to be shown beside the window's; null before the scene is built.
    [[nodiscard]] const std::shared_ptr<const Snapshot>& moment() const { return moment_; }
    /// Whether it is still on its way to the time that the window's run has reached.
    [[nodiscard]] bool busy() const { return busy_; }
    /// Its history, and what plots read of it.
    [[nodiscard]] Curves& curves() { return curves_; }
    [[nodiscard]] std::optional<std::size_t> column(const std::string& name) const;

  private:
    LiveRun run_;
    std::string label_;
    Curves curves_;
    std::shared_ptr<const Snapshot> moment_;
    bool busy_ = true;
};

/// What tells a run from others of its scene: its named scheme, and what else was set: "joint, courant 0.5".
[[nodiscard]] std::string label_of(const LiveRun& run);

}  // namespace percuss::app
