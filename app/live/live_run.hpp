#pragma once

#include <filesystem>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "run/engine.hpp"

namespace percuss::app {

/// The scene that a window shows: an engine that steps it, and the engine that is being built to replace it.
/// Neither waits for the other: scenes are read and meshed on a thread of their own, what the engine
/// publishes is taken as it is, and a scene that cannot be used leaves the present one as it was.
class LiveRun {
  public:
    /// @param options for all engines.
    explicit LiveRun(EngineOptions options = {}) : options_(std::move(options)) {}
    ~LiveRun();
    LiveRun(const LiveRun&) = delete;
    LiveRun& operator=(const LiveRun&) = delete;

    /// Begins to read a scene; the result is taken by update(). @param overrides "key=value", as --set.
    void open(std::filesystem::path file, const std::vector<std::string>& overrides = {});
    /// The same file anew, with the values set here; after a refusal, what was refused.
    void reload();
    /// Sets a value of the scene ("parameters.bore", "4.5"). What can act from the next step on does
    /// (effect_of_change); anything else builds a new run, which starts when the old one had. Calls during a
    /// build wait for it, the last one for each key counts.
    void set(const std::string& key, const std::string& value);
    void forget(const std::string& key);  ///< its value is that of the file again
    void forget_settings();               ///< all values as they are in the file
    /// The value set for a key, if any.
    [[nodiscard]] std::optional<std::string> setting(const std::string& key) const;

    /// Reads quantities at a place from now on (command::AddProbe). Runs that replace this one of the same
    /// file read it, too, from their start.
    void add_probe(Probe probe);
    void remove_probe(const std::string& name);
    /// Those that were added, in this order.
    [[nodiscard]] const std::vector<Probe>& probes() const { return probes_; }
    /// What they have read; one that was added just now may be missing.
    [[nodiscard]] std::vector<SetProbe> probe_rows() const;

    // Run control; nothing happens while there is no engine.
    void run(std::optional<double> until = std::nullopt);  ///< after the end: from the beginning
    void pause();
    void step(std::int64_t count);
    void reset();

    /// Takes over what was built and the newest that the engine has published. Never waits.
    void update();

    [[nodiscard]] bool has_engine() const { return engine_ != nullptr; }
    [[nodiscard]] bool building() const { return building_.has_value(); }
    [[nodiscard]] const std::filesystem::path& file() const { return file_; }
    /// As of the last update(); null before the first scene is there.
    [[nodiscard]] const std::shared_ptr<const Snapshot>& snapshot() const { return snapshot_; }
    [[nodiscard]] const std::shared_ptr<const History>& history() const { return history_; }
    [[nodiscard]] const RunStatistics& statistics() const { return statistics_; }
    [[nodiscard]] RunStatus status() const { return status_; }
    /// The newest kept moment that is not later than `time`; null when there is none [time].
    [[nodiscard]] std::shared_ptr<const Snapshot> frame_at(double time) const;
    [[nodiscard]] Timeline timeline() const;               ///< of the present run, newer than its snapshot
    [[nodiscard]] double speed() const { return speed_; }  ///< as RunProgress::speed
    /// Why the last scene or value was refused, one line a fault; empty when it was not.
    [[nodiscard]] const std::vector<std::string>& messages() const { return messages_; }
    [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }
    /// Forgets the refusal: reload() means the scene that is shown again.
    void dismiss_messages();
    /// Whether the file that reload() would read has changed on disk since it was last read.
    [[nodiscard]] bool file_changed() const;
    [[nodiscard]] int builds() const { return builds_; }  ///< engines taken over so far

  private:
    struct Request {
        std::filesystem::path file;
        std::vector<std::string> overrides;
        std::map<std::string, std::string> settings;
        bool start = false;
    };
    struct Built {
        std::unique_ptr<Engine> engine;
        std::vector<std::string> messages, warnings;
    };

    void request(Request wanted);
    void begin(Request wanted);
    void take_over(Built built);
    void retire(std::unique_ptr<Engine> engine);
    [[nodiscard]] Request present() const;
    [[nodiscard]] Built build(const Request& wanted) const;

    EngineOptions options_;
    std::unique_ptr<Engine> engine_;
    std::filesystem::path file_;
    std::vector<std::string> overrides_;           // of the command line
    std::map<std::string, std::string> settings_;  // made in the window
    std::vector<Probe> probes_;                    // likewise
    std::filesystem::file_time_type read_at_{};    // time of the file shown, when it was read
    std::filesystem::file_time_type tried_at_{};   // likewise of the last file that was tried
    bool refused_ = false;                         // the last request
    std::optional<std::future<Built>> building_;
    Request being_built_;
    std::optional<Request> next_;
    std::vector<std::future<void>> retired_;  // engines that end their last step
    int builds_ = 0;

    std::shared_ptr<const Snapshot> snapshot_;
    std::shared_ptr<const History> history_;
    RunStatistics statistics_;
    RunStatus status_ = RunStatus::paused;
    std::vector<std::string> messages_, warnings_;
    double speed_ = 0;
};

}  // namespace percuss::app
