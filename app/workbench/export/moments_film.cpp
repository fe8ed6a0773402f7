#include "workbench/export/moments_film.hpp"

#include <utility>

namespace percuss::app {

MomentsFilm::MomentsFilm(Workbench& w, std::filesystem::path target, std::vector<double> times,
                         std::array<int, 2> size, double frames_per_second)
    : stream(std::move(target), frames_per_second),
      view_(w, size),
      moments_(w.run.moments()),
      newest_(w.run.recorded() ? nullptr : w.run.newest()),
      times_(std::move(times)) {}

void MomentsFilm::advance(const Workbench& w) {
    if (next_ >= times_.size() || stream.outcome() || stream.full()) return;
    const double time = times_[next_];
    std::shared_ptr<const Snapshot> moment = newest_;
    if (!newest_ || time < newest_->time) moment = moments_(time);
    if (!moment && !newest_) return;  // it is being read
    // Only a run without kept moments of its own can have been replaced.
    if (!moment || moment->setup != view_.setup())
        throw render::RenderError("the run was built anew before its film was done");
    if (moment != drawn_) {
        image_ = view_.draw(w, moment);
        drawn_ = std::move(moment);
    }
    stream.add(image_);
    if (++next_ == times_.size()) stream.finish();
}

double MomentsFilm::progress() const {
    return static_cast<double>(next_) / static_cast<double>(std::max<std::size_t>(times_.size(), 1));
}

}  // namespace percuss::app
