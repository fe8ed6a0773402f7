#include "session.hpp"

namespace percuss::app {

Session::Session(Scene scene, double frame_interval, int threads) {
    EngineOptions options;
    options.threads = threads;
    options.frame_interval = frame_interval;
    options.state_memory = options.frame_memory = 0;  // nobody goes back
    options.on_frame = [this](std::shared_ptr<const Snapshot> frame) { frames_.push(std::move(frame)); };
    engine_ = std::make_unique<Engine>(std::move(scene), std::move(options));
}

Session::~Session() {
    frames_.close();  // an engine that waits for room goes on, and can hear the next command
    if (!waiter_.joinable()) return;
    engine_->post(command::Pause{});
    waiter_.join();
}

void Session::start() {
    engine_->post(command::Run{});
    waiter_ = std::thread([this] {
        engine_->wait();
        frames_.close();
    });
}

void Session::interrupt() { engine_->post(command::Pause{}); }

}  // namespace percuss::app
