#include "live/live_run.hpp"

#include <algorithm>
#include <exception>
#include <utility>

#include "run/in_flight.hpp"
#include "scene/parse.hpp"

namespace percuss::app {
namespace {

std::filesystem::file_time_type time_of(const std::filesystem::path& file) {
    std::error_code missing;
    const auto time = std::filesystem::last_write_time(file, missing);
    return missing ? std::filesystem::file_time_type{} : time;
}

std::vector<std::string> together(std::vector<std::string> overrides,
                                  const std::map<std::string, std::string>& settings) {
    for (const auto& [key, value] : settings) overrides.push_back(key + "=" + value);
    return overrides;
}

template <class T>
bool ready(const std::future<T>& future) {
    return future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

/// The run file that a path means; empty when it means a scene.
std::filesystem::path run_file_of(const std::filesystem::path& path) {
    std::error_code unreadable;
    if (std::filesystem::is_directory(path, unreadable)) return path / "run.h5";
    return path.extension() == ".h5" ? path : std::filesystem::path();
}

}  // namespace

LiveRun::~LiveRun() {
    if (building_) building_->wait();
}

LiveRun::Request LiveRun::present(bool anew) const {
    Request same = next_ ? *next_ : building_ ? being_built_ : Request{file_, overrides_, settings_};
    same.anew = anew || (next_ && next_->anew);
    same.asked = std::chrono::steady_clock::now();
    // What has begun goes on with the new design; a run that waits at its beginning waits on.
    if (begun_ || (engine_ && history_ && history_->rows() > 0)) same.start = true;
    return same;
}

void LiveRun::open(std::filesystem::path file, const std::vector<std::string>& overrides) {
    request({std::move(file), overrides});
}

void LiveRun::reload() {
    if (refused_ && !building_)
        request(Request(being_built_));
    else
        request(present(true));
}

void LiveRun::dismiss_messages() {
    messages_.clear();
    refused_ = false;
}

void LiveRun::set(const std::string& key, const std::string& value) {
    if (recording_ && !building_) {
        messages_ = {key + ": a recorded run stays as it was; open its scene to change it"};
        return;
    }
    if (effect_of_change(key) == ChangeEffect::next_step && engine_ && !building_) {
        engine_->post(command::Set{key, value});
        settings_[key] = value;
        return;
    }
    Request wanted = present(false);
    wanted.settings[key] = value;
    request(std::move(wanted));
}

void LiveRun::set_all(const std::vector<std::string>& settings) {
    if (recording_ && !building_) {
        messages_ = {"a recorded run stays as it was; open its scene to change it"};
        return;
    }
    Request wanted = present(false);
    for (const std::string& setting : settings) {
        const std::size_t equals = setting.find('=');
        wanted.settings[setting.substr(0, equals)] = setting.substr(equals + 1);
    }
    request(std::move(wanted));
}

void LiveRun::forget(const std::string& key) {
    Request wanted = present(false);
    wanted.settings.erase(key);
    request(std::move(wanted));
}

void LiveRun::forget_settings() {
    Request wanted = present(false);
    wanted.settings.clear();
    request(std::move(wanted));
}

std::optional<std::string> LiveRun::setting(const std::string& key) const {
    const auto& newest = next_ ? next_->settings : building_ ? being_built_.settings : settings_;
    const auto found = newest.find(key);
    if (found == newest.end()) return std::nullopt;
    return found->second;
}

std::vector<std::string> LiveRun::overrides() const { return together(overrides_, settings_); }

const DesignValue* LiveRun::design_value(const std::string& key) const {
    const auto found = std::find_if(design_.begin(), design_.end(),
                                    [&](const DesignValue& value) { return value.key == key; });
    return found == design_.end() ? nullptr : &*found;
}

void LiveRun::request(Request wanted) {
    if (building_)
        next_ = std::move(wanted);
    else
        begin(std::move(wanted));
}

void LiveRun::begin(Request wanted) {
    being_built_ = std::move(wanted);
    tried_at_ = time_of(being_built_.file);
    const bool same = engine_ && being_built_.file == file_ && !being_built_.anew;
    building_ =
        std::async(std::launch::async, [this, request = being_built_, scene = same ? scene_ : nullptr] {
            return build(request, scene.get());
        });
}

LiveRun::Built LiveRun::build(const Request& wanted, const Scene* present) const {
    Built built;
    try {
        if (const std::filesystem::path file = run_file_of(wanted.file); !file.empty()) {
            if (!std::filesystem::exists(file)) throw std::runtime_error("there is no run in it");
            if (!open_run_) throw std::runtime_error("recorded runs cannot be read here");
            built.recording = std::make_shared<Recording>(file, open_run_, options_.frame_memory);
            return built;
        }
        Scene scene = load_scene(wanted.file, together(wanted.overrides, wanted.settings));
        built.warnings = scene.warnings;
        if (!present || effect_of_change(*present, scene) == ChangeEffect::rebuild)
            built.engine = std::make_unique<Engine>(scene, options_);
        built.design = design_values(scene);
        if (!scene.contacts.empty()) built.schemes = scheme_choices(scene);
        built.scene = std::make_shared<const Scene>(std::move(scene));
    } catch (const SceneError& error) {
        built.messages = error.messages();
    } catch (const std::exception& error) {
        const std::string name = wanted.file.string(), what = error.what();
        built.messages = {what.starts_with(name) ? what : name + ": " + what};
    }
    return built;
}

void LiveRun::take_over(Built built) {
    messages_ = std::move(built.messages);
    refused_ = !built.scene && !built.recording;
    if (refused_) return;
    read_at_ = tried_at_;
    warnings_ = std::move(built.warnings);
    if (file_ != being_built_.file) probes_.clear();
    file_ = being_built_.file;
    overrides_ = being_built_.overrides;
    settings_ = being_built_.settings;
    scene_ = std::move(built.scene);
    design_ = std::move(built.design);
    schemes_ = std::move(built.schemes);
    if (!built.engine && !built.recording) {  // the present run goes on with the scene
        engine_->post(command::Change{scene_});
        return;
    }
    retire(std::exchange(engine_, std::move(built.engine)),
           std::exchange(recording_, std::move(built.recording)));
    ++builds_;
    built_for_ = being_built_.asked;
    begun_ = being_built_.start;
    playhead_.go_live();
    set_back_ = false;
    branch_.reset();
    timeline_ = {};
    status_ = RunStatus::paused;
    if (recording_) {
        history_ = recording_->history();
        statistics_ = {};
        timeline_.frames = recording_->times();
        timeline_.end = timeline_.frames.back();
        newest_ = snapshot_ = recording_->last_read();
        for (const Probe& probe : probes_) recording_->add_probe(probe);
        playhead_.look_at(timeline_.frames.front());
        return;
    }
    if (wanted_speed_) engine_->post(command::SetSpeed{wanted_speed_});
    for (const Probe& probe : probes_) engine_->post(command::AddProbe{probe});
    if (being_built_.start) engine_->post(command::Run{});
}

/// An engine ends its present step before it is gone, a file its present read: that is waited for elsewhere.
void LiveRun::retire(std::unique_ptr<Engine> engine, std::shared_ptr<Recording> recording) {
    std::erase_if(retired_, [](const auto& future) { return ready(future); });
    if (engine)
        retired_.push_back(
            std::async(std::launch::async, [old = std::move(engine)]() mutable { old.reset(); }));
    if (recording)
        retired_.push_back(
            std::async(std::launch::async, [old = std::move(recording)]() mutable { old.reset(); }));
}

void LiveRun::update() {
    if (building_ && ready(*building_)) {
        Built built = building_->get();
        building_.reset();
        take_over(std::move(built));
        if (next_) begin(*std::exchange(next_, std::nullopt));
    }
    if (engine_) update_engine();
    if (recording_) update_recording();
}

void LiveRun::update_engine() {
    // The status first: it is never ahead of the snapshot.
    const RunStatus status = engine_->status();
    newest_ = engine_->snapshot();
    history_ = engine_->history();
    statistics_ = engine_->statistics();
    timeline_ = engine_->timeline();
    std::vector<std::string> messages = engine_->take_messages();
    if (branch_ && branch_->confirmed && !timeline_.branch_drops) {
        branch_.reset();
        playhead_.go_live();
    } else if (branch_ && branch_->confirmed && !messages.empty()) {  // refused
        branch_.reset();
        set_back_ = true;
    }
    for (std::string& message : messages) messages_.push_back(std::move(message));
    speed_ = engine_->progress().speed;
    sought_.reset();
    // Set back, the engine is paused at some moment before; the run is still what it was at its end.
    if (timeline_.branch_drops) {
        sought_ = std::exchange(newest_, engine_->frame_at(timeline_.end));
        if (status_ == RunStatus::running) status_ = RunStatus::paused;
    } else if (status == engine_->status()) {
        status_ = status;
    }
    if (!newest_) newest_ = sought_;  // no moments are kept
    if (playhead_.advance(Playhead::Clock::now(), playing_speed(), timeline_.end)) go_live();
    snapshot_ = live() ? newest_ : looked_at();
}

void LiveRun::update_recording() {
    playhead_.advance(Playhead::Clock::now(), playing_speed(), timeline_.end);
    if (auto frame = recording_->frame_at(playhead_.time()))
        snapshot_ = std::move(frame);
    else
        snapshot_ = recording_->last_read();
    newest_ = snapshot_;
    status_ = playing() ? RunStatus::running
              : playhead_.time() >= timeline_.end && snapshot_->status == RunStatus::diverged
                  ? RunStatus::diverged
                  : RunStatus::paused;
    speed_ = playing() ? playing_speed() : 0;
    timeline_.present = snapshot_->time;
    timeline_.frame_bytes = recording_->bytes();
    for (std::string& message : recording_->take_messages()) messages_.push_back(std::move(message));
}

std::vector<Trace> LiveRun::traces() const {
    if (recording_) return recording_->traces();
    return engine_ ? engine_->traces() : std::vector<Trace>{};
}

bool LiveRun::file_changed() const {
    if (building_ || (file_.empty() && !refused_)) return false;
    const auto& file = refused_ ? being_built_.file : file_;
    if (!run_file_of(file).empty()) return false;  // one that is still being recorded changes all the time
    const auto time = time_of(file);
    return time != std::filesystem::file_time_type{} && time != (refused_ ? tried_at_ : read_at_);
}

}  // namespace percuss::app
