#include "study/study_progress.hpp"

#include <cstdio>

#include <fmt/format.h>

#include "progress.hpp"

namespace percuss::app {

StudyProgress::StudyProgress(std::size_t cases, std::size_t there)
    : cases_(cases), there_(there), terminal_(stderr_is_terminal()) {
    if (there > 0) fmt::print(stderr, "{} of {} cases are there already\n", there, cases);
}

StudyProgress::~StudyProgress() {
    if (line_open_) std::fputc('\n', stderr);
}

void StudyProgress::show(const std::string& ended, const std::string& trouble, std::size_t running) {
    if (!ended.empty()) ++done_;
    const std::size_t done = there_ + done_, width = 24, filled = width * done / cases_;
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    std::string line =
        fmt::format("[{:#>{}}{:.>{}}] {} of {} cases", "", filled, "", width - filled, done, cases_);
    if (running > 0) line += fmt::format(", {} running", running);
    if (done_ > 0 && done < cases_)
        line += fmt::format(", {} left", short_duration(seconds * static_cast<double>(cases_ - done) /
                                                        static_cast<double>(done_)));
    const std::string news = ended.empty() ? "" : ended + (trouble.empty() ? "" : ": " + trouble);
    if (!terminal_) {
        if (!news.empty()) fmt::print(stderr, "{}  {}\n", line, news);
        return;
    }
    if (!trouble.empty()) fmt::print(stderr, "\r{}\x1b[K\n", news);
    fmt::print(stderr, "\r{}\x1b[K", line);
    std::fflush(stderr);
    line_open_ = true;
}

}  // namespace percuss::app
