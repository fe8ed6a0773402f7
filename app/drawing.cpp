#include "drawing.hpp"

#include <system_error>

#include <fmt/format.h>

#include "exit_status.hpp"
#include "image.hpp"
#include "output.hpp"

namespace percuss::app {

Drawing::Drawing(std::shared_ptr<const RunSetup> setup, const ViewOptions& options, DrawingTargets targets)
    : targets_(std::move(targets)) {
    if (targets_.film) {
        const std::filesystem::path& film = *targets_.film;
        if (film.has_parent_path()) std::filesystem::create_directories(film.parent_path());
        film_aside_ = film.parent_path() / fmt::format(".{}.part.mp4", film.stem().string());
        film_ = std::make_unique<render::Film>(film_aside_, options.size[0], options.size[1],
                                               options.frames_per_second);
    }
    if (targets_.folder) std::filesystem::create_directories(*targets_.folder);
    context_ = render::make_offscreen_context();
    view_ = std::make_unique<render::View>(*context_, std::move(setup), options);
}

Drawing::~Drawing() {
    view_.reset();
    if (!film_) return;
    film_.reset();
    std::error_code ignored;
    std::filesystem::remove(film_aside_, ignored);
}

void Drawing::add(const Snapshot& snapshot, const History* history, long long index) {
    const render::Image image = view_->draw(snapshot, history);
    if (targets_.folder) {
        write_whole(*targets_.folder / frame_name(index),
                    [&](const std::filesystem::path& aside) { render::write_png(image, aside); });
    }
    if (film_) film_->add(image);
}

void Drawing::finish() {
    if (!film_) return;
    film_->finish();
    film_.reset();
    std::filesystem::rename(film_aside_, *targets_.film);
}

void check_film(const std::filesystem::path& film, bool force) {
    if (film.extension() != ".mp4") {
        throw UsageError(fmt::format("--film {}: the name must end in .mp4", film.string()));
    }
    if (!force && std::filesystem::exists(film)) {
        throw UsageError(fmt::format("--film {}: the file exists; choose another, or replace it with --force",
                                     film.string()));
    }
}

}  // namespace percuss::app
