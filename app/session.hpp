#pragma once

#include <memory>
#include <thread>

#include "frame_queue.hpp"
#include "run/engine.hpp"

namespace percuss::app {

/// One run of a scene from start to end on the engine's thread, its frames queued for the caller's thread.
class Session {
  public:
    /// Builds the solver; nothing runs yet. @throws SceneError.
    Session(Scene scene, double frame_interval, int threads);
    ~Session();  ///< ends a run that still goes on
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    void start();
    void interrupt();  ///< the run ends after its present step
    [[nodiscard]] Engine& engine() { return *engine_; }
    [[nodiscard]] FrameQueue& frames() { return frames_; }

  private:
    FrameQueue frames_{std::size_t{256} << 20};
    std::unique_ptr<Engine> engine_;
    std::thread waiter_;  // closes the queue when the engine comes to rest
};

}  // namespace percuss::app
