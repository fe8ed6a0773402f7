#pragma once

#include <condition_variable>
#include <deque>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "image.hpp"

namespace percuss::app {

/// Takes pictures, one after another, into a film (a file .mp4) or numbered PNGs (any other name: a folder),
/// on a thread of its own. They are made aside: the name appears when all is there.
class PictureStream {
  public:
    /// @param target a name that nothing has yet. @param frames_per_second of a film.
    PictureStream(std::filesystem::path target, double frames_per_second);
    ~PictureStream();  ///< as cancel(), when finish() was not called; waits
    PictureStream(const PictureStream&) = delete;
    PictureStream& operator=(const PictureStream&) = delete;

    /// Whether as many pictures wait as memory is given to; add() one later then.
    [[nodiscard]] bool full() const;
    void add(render::Image image);  ///< all of one size
    void finish();                  ///< that was the last one; what waits is still written
    void cancel();                  ///< nothing is to remain

    struct Outcome {
        bool written = false;   ///< the whole of it
        std::string fault;      ///< why not; "" after cancel()
        std::size_t count = 0;  ///< pictures
    };
    /// Nothing while it goes on. A fault ends it early.
    [[nodiscard]] std::optional<Outcome> outcome() const;
    [[nodiscard]] const std::filesystem::path& target() const { return target_; }

  private:
    void work();
    std::size_t write_pictures();
    [[nodiscard]] std::optional<render::Image> next();

    std::filesystem::path target_, aside_;
    double frames_per_second_;
    mutable std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<render::Image> queue_;
    bool last_ = false, cancelled_ = false;
    std::optional<Outcome> outcome_;
    std::thread thread_;
};

}  // namespace percuss::app
