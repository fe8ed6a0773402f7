#pragma once

#include <array>
#include <chrono>
#include <filesystem>
#include <functional>
#include <future>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "live/playhead.hpp"
#include "live/recording.hpp"
#include "run/design_values.hpp"
#include "run/engine.hpp"
#include "scene/named_schemes.hpp"

namespace percuss::app {

/// The run that a window shows: an engine that steps a scene, or a recorded run; and what is being built to
/// replace it. Neither waits for the other: scenes are read and meshed on a thread of their own, what the
/// engine publishes is taken as it is, and a scene that cannot be used leaves the present one as it was.
///
/// What is shown is the newest moment, or an earlier one that is looked back at: then the engine goes on, or
/// waits, undisturbed. A recorded run is always looked back at.
class LiveRun {
  public:
    /// @param options for all engines. @param open_run reads recorded runs; without it they are refused.
    explicit LiveRun(EngineOptions options = {}, OpenRun open_run = {})
        : options_(std::move(options)), open_run_(std::move(open_run)) {}
    ~LiveRun();
    LiveRun(const LiveRun&) = delete;
    LiveRun& operator=(const LiveRun&) = delete;

    /// Begins to read a scene, or a recorded run: run.h5 or the directory that holds it; the result is taken
    /// by update(). @param overrides "key=value", as --set; of scenes.
    void open(std::filesystem::path file, const std::vector<std::string>& overrides = {});
    /// The same file anew, with the values set here; after a refusal, what was refused.
    void reload();
    /// Sets a value of the scene ("parameters.bore", "4.5"). The scene is read anew, aside; when the run can
    /// go on with it from its next step on (effect_of_change), it does; anything else builds a new run, which
    /// starts when the old one had. Calls during a build wait for it, the last one for each key counts.
    void set(const std::string& key, const std::string& value);
    /// Several at once, "key=value": the scene is read when all are set.
    void set_all(const std::vector<std::string>& settings);
    void forget(const std::string& key);  ///< its value is that of the file again
    void forget_settings();               ///< all values as they are in the file
    /// What the run shown has been given beside its file, "key=value" in the order in which it acts.
    [[nodiscard]] std::vector<std::string> overrides() const;
    /// The value set for a key, if any.
    [[nodiscard]] std::optional<std::string> setting(const std::string& key) const;

    /// Reads quantities at a place from now on (command::AddProbe); in a recorded run in all its frames, one
    /// after the other. Runs that replace this one of the same file read it, too, from their start.
    void add_probe(Probe probe);
    void remove_probe(const std::string& name);
    /// Those that were added, in this order.
    [[nodiscard]] const std::vector<Probe>& probes() const { return probes_; }
    /// What they have read; one that was added just now may be missing.
    [[nodiscard]] std::vector<SetProbe> probe_rows() const;

    // Run control; nothing happens while nothing is there. What goes on goes on from the newest moment, never
    // from one that is looked back at. A recorded run goes to the moment asked for instead.
    void run(std::optional<double> until = std::nullopt);  ///< after the end: from the beginning
    void pause();
    void step(std::int64_t count);
    void reset();
    /// Simulated time per second of wall time, of this run and those after it; absent: as fast as can be.
    /// What is played is played at this speed; absent: the whole of it in ten seconds.
    void set_speed(std::optional<double> speed);
    [[nodiscard]] std::optional<double> wanted_speed() const { return wanted_speed_; }

    // Time travel.
    void look_at(double time);  ///< shows the newest kept moment that is not later [time]
    /// To be called when look_at has come to rest: an engine that waits goes to that very step, so that it
    /// can be shown; it can go back to where it was. What runs or is recorded stays at the kept moment.
    void settle();
    void look_step(
        std::int64_t count);  ///< to the count-th kept moment after (before, when negative) the one shown
    void go_live();           ///< shows the newest moment again
    [[nodiscard]] bool live() const { return playhead_.live(); }
    [[nodiscard]] double looked_time() const { return playhead_.time(); }  ///< @pre not live() [time]
    void play();  ///< what is looked back at, up to the newest moment
    void stop_playing() { playhead_.pause(); }
    [[nodiscard]] bool playing() const { return playhead_.playing(); }

    /// Prepares to go on from the moment that is looked at: the engine is set back to it and waits. Nothing
    /// is dropped before confirm_branch(); anything else that is done means no.
    void ask_branch();
    /// What confirm_branch() would drop: from, to [time]; absent until the engine is there, or nothing was
    /// asked.
    [[nodiscard]] std::optional<std::array<double, 2>> branch_drops() const;
    [[nodiscard]] bool branch_asked() const { return branch_.has_value(); }
    void confirm_branch();
    void cancel_branch();  ///< what ran before the question runs on

    /// Takes over what was built and the newest that the engine has published. Never waits.
    void update();

    [[nodiscard]] bool has_engine() const { return engine_ != nullptr; }
    /// Whether a recorded run is shown.
    [[nodiscard]] bool recorded() const { return recording_ != nullptr; }
    /// Whether a frame that is to be shown is still being read from the disk.
    [[nodiscard]] bool reading() const { return recording_ && recording_->reading(); }
    /// Whether probes of a recorded run have frames yet to come.
    [[nodiscard]] bool reading_probes() const { return recording_ && recording_->reading_probes(); }
    [[nodiscard]] bool building() const { return building_.has_value(); }
    [[nodiscard]] const std::filesystem::path& file() const { return file_; }
    /// The moment that is shown, as of the last update(); null before the first scene is there.
    [[nodiscard]] const std::shared_ptr<const Snapshot>& snapshot() const { return snapshot_; }
    /// The newest moment of the run, which is shown unless an earlier one is looked back at; of a recorded
    /// run the one that is shown.
    [[nodiscard]] const std::shared_ptr<const Snapshot>& newest() const { return newest_; }
    [[nodiscard]] const std::shared_ptr<const History>& history() const { return history_; }
    [[nodiscard]] const RunStatistics& statistics() const { return statistics_; }
    /// Of the run, whatever moment is looked at.
    [[nodiscard]] RunStatus status() const { return status_; }
    /// The newest kept moment that is not later than `time`; null when there is none, or while it is read
    /// from the disk (reading()): ask again then [time].
    [[nodiscard]] std::shared_ptr<const Snapshot> frame_at(double time) const;
    /// The same of the present run, also after another one has replaced it.
    [[nodiscard]] std::function<std::shared_ptr<const Snapshot>(double time)> moments() const;
    [[nodiscard]] std::vector<Trace> traces() const;  ///< what the scene's figures sample
    /// As of the last update(); of recorded runs all frames.
    [[nodiscard]] const Timeline& timeline() const { return timeline_; }
    [[nodiscard]] double speed() const { return speed_; }  ///< as RunProgress::speed
    /// Why the last scene or value was refused, one line a fault; empty when it was not.
    [[nodiscard]] const std::vector<std::string>& messages() const { return messages_; }
    [[nodiscard]] const std::vector<std::string>& warnings() const { return warnings_; }
    /// Forgets the refusal: reload() means the scene that is shown again.
    void dismiss_messages();
    /// Whether the file that reload() would read has changed on disk since it was last read.
    [[nodiscard]] bool file_changed() const;
    [[nodiscard]] int builds() const { return builds_; }  ///< engines taken over so far
    /// When the change was asked for that the present engine was built for.
    [[nodiscard]] std::chrono::steady_clock::time_point built_for() const { return built_for_; }
    /// What can be varied in the scene, with the values that are set; empty before there is one.
    [[nodiscard]] const std::vector<DesignValue>& design() const { return design_; }
    /// Which named contact schemes the scene can take, and which it has; empty before there is one.
    [[nodiscard]] const std::vector<SchemeChoice>& schemes() const { return schemes_; }
    [[nodiscard]] const DesignValue* design_value(const std::string& key) const;

  private:
    struct Request {
        std::filesystem::path file;
        std::vector<std::string> overrides{};
        std::map<std::string, std::string> settings{};
        bool start = false;
        bool anew = true;  // whatever the present run could go on with
        std::chrono::steady_clock::time_point asked = std::chrono::steady_clock::now();
    };
    struct Built {
        std::shared_ptr<const Scene> scene;
        std::unique_ptr<Engine> engine;  // null: the present one can go on with the scene
        std::shared_ptr<Recording> recording;
        std::vector<DesignValue> design;
        std::vector<SchemeChoice> schemes;
        std::vector<std::string> messages, warnings;
    };

    void request(Request wanted);
    void begin(Request wanted);
    void take_over(Built built);
    void retire(std::unique_ptr<Engine> engine, std::shared_ptr<Recording> recording);
    void update_engine();
    void update_recording();
    /// The moment that is looked at.
    [[nodiscard]] std::shared_ptr<const Snapshot> looked_at() const;
    void return_to_end();  // an engine that was set back
    [[nodiscard]] double playing_speed() const;
    [[nodiscard]] Request present(bool anew) const;
    [[nodiscard]] Built build(const Request& wanted, const Scene* present) const;

    struct Branch {
        double from = 0;  // the moment asked for [time]
        bool was_running = false;
        bool confirmed = false;
    };

    EngineOptions options_;
    OpenRun open_run_;
    std::unique_ptr<Engine> engine_;        // this,
    std::shared_ptr<Recording> recording_;  // or this, or none yet
    std::shared_ptr<const Scene> scene_;    // of the engine, newer than what its thread has taken up
    std::vector<DesignValue> design_;
    std::vector<SchemeChoice> schemes_;
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
    std::vector<std::future<void>>
        retired_;         // engines that end their last step, files that end their last read
    bool begun_ = false;  // told to run, whether its first step is made or not
    int builds_ = 0;
    std::chrono::steady_clock::time_point built_for_{};

    Playhead playhead_;
    bool set_back_ = false;  // asked of the engine, and not taken back
    std::optional<Branch> branch_;
    std::optional<double> wanted_speed_;

    std::shared_ptr<const Snapshot> snapshot_, newest_;
    std::shared_ptr<const Snapshot> sought_;  // where the engine is, when it is set back
    Timeline timeline_;
    std::shared_ptr<const History> history_;
    RunStatistics statistics_;
    RunStatus status_ = RunStatus::paused;
    std::vector<std::string> messages_, warnings_;
    double speed_ = 0;
};

}  // namespace percuss::app
