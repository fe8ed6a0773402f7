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

template <class T>
bool ready(const std::future<T>& future) {
    return future.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

}  // namespace

LiveRun::~LiveRun() {
    if (building_) building_->wait();
}

LiveRun::Request LiveRun::present() const {
    Request same = next_ ? *next_ : building_ ? being_built_ : Request{file_, overrides_, settings_, false};
    // What has begun goes on with the new design; a run that waits at its beginning waits on.
    if (snapshot_ && snapshot_->step > 0) same.start = true;
    return same;
}

void LiveRun::open(std::filesystem::path file, const std::vector<std::string>& overrides) {
    request({std::move(file), overrides, {}, false});
}

void LiveRun::reload() {
    if (refused_ && !building_)
        request(Request(being_built_));
    else
        request(present());
}

void LiveRun::dismiss_messages() {
    messages_.clear();
    refused_ = false;
}

void LiveRun::set(const std::string& key, const std::string& value) {
    if (effect_of_change(key) == ChangeEffect::next_step && engine_ && !building_) {
        engine_->post(command::Set{key, value});
        settings_[key] = value;
        return;
    }
    Request wanted = present();
    wanted.settings[key] = value;
    request(std::move(wanted));
}

void LiveRun::forget(const std::string& key) {
    Request wanted = present();
    wanted.settings.erase(key);
    request(std::move(wanted));
}

void LiveRun::forget_settings() {
    Request wanted = present();
    wanted.settings.clear();
    request(std::move(wanted));
}

std::optional<std::string> LiveRun::setting(const std::string& key) const {
    const auto& newest = next_ ? next_->settings : building_ ? being_built_.settings : settings_;
    const auto found = newest.find(key);
    if (found == newest.end()) return std::nullopt;
    return found->second;
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
    building_ = std::async(std::launch::async, [this, request = being_built_] { return build(request); });
}

LiveRun::Built LiveRun::build(const Request& wanted) const {
    Built built;
    try {
        std::vector<std::string> overrides = wanted.overrides;
        for (const auto& [key, value] : wanted.settings) overrides.push_back(key + "=" + value);
        Scene scene = load_scene(wanted.file, overrides);
        built.warnings = scene.warnings;
        built.engine = std::make_unique<Engine>(std::move(scene), options_);
    } catch (const SceneError& error) {
        built.messages = error.messages();
    } catch (const std::exception& error) {
        built.messages = {wanted.file.string() + ": " + error.what()};
    }
    return built;
}

void LiveRun::take_over(Built built) {
    messages_ = std::move(built.messages);
    refused_ = built.engine == nullptr;
    if (refused_) return;
    read_at_ = tried_at_;
    retire(std::exchange(engine_, std::move(built.engine)));
    ++builds_;
    warnings_ = std::move(built.warnings);
    if (file_ != being_built_.file) probes_.clear();
    for (const Probe& probe : probes_) engine_->post(command::AddProbe{probe});
    file_ = being_built_.file;
    overrides_ = being_built_.overrides;
    settings_ = being_built_.settings;
    if (being_built_.start) engine_->post(command::Run{});
}

/// An engine ends its present step before it is gone: that is waited for elsewhere.
void LiveRun::retire(std::unique_ptr<Engine> engine) {
    std::erase_if(retired_, [](const auto& future) { return ready(future); });
    if (engine)
        retired_.push_back(
            std::async(std::launch::async, [old = std::move(engine)]() mutable { old.reset(); }));
}

void LiveRun::add_probe(Probe probe) {
    if (!engine_) return;
    engine_->post(command::AddProbe{probe});
    probes_.push_back(std::move(probe));
}

void LiveRun::remove_probe(const std::string& name) {
    if (engine_) engine_->post(command::RemoveProbe{name});
    std::erase_if(probes_, [&](const Probe& probe) { return probe.name == name; });
}

std::vector<SetProbe> LiveRun::probe_rows() const {
    return engine_ ? engine_->probes() : std::vector<SetProbe>{};
}

void LiveRun::run(std::optional<double> until) {
    if (!engine_) return;
    if (status_ == RunStatus::finished || status_ == RunStatus::diverged) reset();
    engine_->post(command::Run{until});
}

void LiveRun::pause() {
    if (engine_) engine_->post(command::Pause{});
}

void LiveRun::step(std::int64_t count) {
    if (engine_) engine_->post(command::Steps{count});
}

void LiveRun::reset() {
    if (engine_) engine_->post(command::Reset{});
}

void LiveRun::update() {
    if (building_ && ready(*building_)) {
        Built built = building_->get();
        building_.reset();
        take_over(std::move(built));
        if (next_) begin(*std::exchange(next_, std::nullopt));
    }
    if (!engine_) return;
    // The status first: it is never ahead of the snapshot.
    status_ = engine_->status();
    snapshot_ = engine_->snapshot();
    history_ = engine_->history();
    statistics_ = engine_->statistics();
    for (std::string& message : engine_->take_messages()) messages_.push_back(std::move(message));
    speed_ = engine_->progress().speed;
}

std::shared_ptr<const Snapshot> LiveRun::frame_at(double time) const {
    return engine_ ? engine_->frame_at(time) : nullptr;
}

Timeline LiveRun::timeline() const { return engine_ ? engine_->timeline() : Timeline{}; }

bool LiveRun::file_changed() const {
    if (building_ || (file_.empty() && !refused_)) return false;
    const auto time = time_of(refused_ ? being_built_.file : file_);
    return time != std::filesystem::file_time_type{} && time != (refused_ ? tried_at_ : read_at_);
}

}  // namespace percuss::app
