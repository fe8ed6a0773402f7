#include "workbench/export/picture_stream.hpp"

#include <exception>
#include <memory>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "film.hpp"
#include "output.hpp"

namespace percuss::app {
namespace {

constexpr std::size_t most_waiting = 4;

bool is_film(const std::filesystem::path& target) { return target.extension() == ".mp4"; }

}  // namespace

PictureStream::PictureStream(std::filesystem::path target, double frames_per_second)
    : target_(std::move(target)), aside_(target_), frames_per_second_(frames_per_second) {
    aside_.replace_filename(fmt::format(".{}.part{}", target_.stem().string(), target_.extension().string()));
    thread_ = std::thread([this] { work(); });
}

PictureStream::~PictureStream() {
    {
        const std::lock_guard lock(mutex_);
        if (!last_) cancelled_ = last_ = true;
    }
    changed_.notify_one();
    thread_.join();
}

bool PictureStream::full() const {
    const std::lock_guard lock(mutex_);
    return queue_.size() >= most_waiting;
}

void PictureStream::add(render::Image image) {
    {
        const std::lock_guard lock(mutex_);
        if (last_ || outcome_) return;
        queue_.push_back(std::move(image));
    }
    changed_.notify_one();
}

void PictureStream::finish() {
    {
        const std::lock_guard lock(mutex_);
        last_ = true;
    }
    changed_.notify_one();
}

void PictureStream::cancel() {
    {
        const std::lock_guard lock(mutex_);
        last_ = cancelled_ = true;
    }
    changed_.notify_one();
}

std::optional<PictureStream::Outcome> PictureStream::outcome() const {
    const std::lock_guard lock(mutex_);
    return outcome_;
}

std::optional<render::Image> PictureStream::next() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [this] { return last_ || !queue_.empty(); });
    if (cancelled_ || queue_.empty()) return std::nullopt;
    render::Image image = std::move(queue_.front());
    queue_.pop_front();
    return image;
}

std::size_t PictureStream::write_pictures() {
    if (target_.has_parent_path()) std::filesystem::create_directories(target_.parent_path());
    std::filesystem::remove_all(aside_);
    if (!is_film(target_)) std::filesystem::create_directory(aside_);
    std::unique_ptr<render::Film> film;
    std::size_t count = 0;
    for (auto image = next(); image; image = next()) {
        if (is_film(target_)) {
            if (!film)
                film =
                    std::make_unique<render::Film>(aside_, image->width, image->height, frames_per_second_);
            film->add(*image);
        } else {
            render::write_png(*image, aside_ / frame_name(static_cast<long long>(count)));
        }
        ++count;
    }
    if (film) film->finish();
    return count;
}

void PictureStream::work() {
    Outcome outcome;
    try {
        outcome.count = write_pictures();
        bool cancelled = false;
        {
            const std::lock_guard lock(mutex_);
            cancelled = cancelled_;
        }
        if (!cancelled && outcome.count == 0) outcome.fault = "nothing was shown that could be recorded";
        if (!cancelled && outcome.count > 0) {
            if (std::filesystem::exists(target_))
                throw render::RenderError(fmt::format("{}: there is one by now", target_.string()));
            std::filesystem::rename(aside_, target_);
            outcome.written = true;
        }
    } catch (const std::exception& error) {
        outcome.fault = error.what();
    }
    std::error_code ignored;
    if (!outcome.written) std::filesystem::remove_all(aside_, ignored);
    const std::lock_guard lock(mutex_);
    outcome_ = std::move(outcome);
    queue_.clear();
}

}  // namespace percuss::app
