#include "recorded_run.hpp"

#include <mutex>
#include <optional>

#include "record/run_file.hpp"

namespace percuss::app {
namespace {

std::mutex& hdf5_turn() {
    static std::mutex turn;
    return turn;
}

class RunFileSource final : public RunSource {
  public:
    explicit RunFileSource(const std::filesystem::path& file) {
        const std::lock_guard lock(hdf5_turn());
        run_.emplace(file);
    }
    ~RunFileSource() override {
        const std::lock_guard lock(hdf5_turn());
        run_.reset();
    }
    std::vector<double> frame_times() override {
        const std::lock_guard lock(hdf5_turn());
        return run_->frame_times();
    }
    std::shared_ptr<const Snapshot> frame(std::int64_t index) override {
        const std::lock_guard lock(hdf5_turn());
        return run_->frame(index);
    }
    std::shared_ptr<const History> history() override {
        const std::lock_guard lock(hdf5_turn());
        return run_->history();
    }
    std::vector<Trace> traces() override {
        const std::lock_guard lock(hdf5_turn());
        return run_->traces();
    }

  private:
    std::optional<RunFile> run_;
};

}  // namespace

std::unique_ptr<RunSource> open_recorded_run(const std::filesystem::path& file) {
    return std::make_unique<RunFileSource>(file);
}

}  // namespace percuss::app
