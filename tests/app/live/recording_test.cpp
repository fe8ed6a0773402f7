#include "live/recording.hpp"

#include <chrono>
#include <condition_variable>
#include <mutex>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "live/probe_curves.hpp"
#include "record/sample_run.hpp"

namespace percuss::app {
namespace {

using namespace std::chrono_literals;
using testing::ElementsAre;
using testing::HasSubstr;

/// What a test knows and decides of a source.
struct Disk {
    std::mutex mutex;
    std::condition_variable changed;
    int frames = 10;
    std::int64_t damaged = -1;
    bool stuck = false;  // reads wait
    std::vector<std::int64_t> read;

    void stick(bool now) {
        {
            const std::lock_guard lock(mutex);
            stuck = now;
        }
        changed.notify_all();
    }
    std::vector<std::int64_t> reads() {
        const std::lock_guard lock(mutex);
        return read;
    }
};

class SlowSource final : public RunSource {
  public:
    explicit SlowSource(Disk& disk) : disk_(disk), setup_(test::sample_setup()) {}
    std::vector<double> frame_times() override {
        std::vector<double> times;
        for (int i = 0; i < disk_.frames; ++i) times.push_back(0.1 * i);
        return times;
    }
    std::shared_ptr<const Snapshot> frame(std::int64_t index) override {
        std::unique_lock lock(disk_.mutex);
        disk_.changed.wait(lock, [&] { return !disk_.stuck; });
        if (index == disk_.damaged) throw std::runtime_error("run.h5: frame is damaged");
        disk_.read.push_back(index);
        return std::make_shared<Snapshot>(test::sample_snapshot(setup_, static_cast<int>(index)));
    }
    std::vector<Trace> traces() override { return {}; }
    std::shared_ptr<const History> history() override {
        return std::make_shared<History>(test::sample_columns());
    }

  private:
    Disk& disk_;
    std::shared_ptr<const RunSetup> setup_;
};

OpenRun opener(Disk& disk) {
    return [&disk](const std::filesystem::path&) { return std::make_unique<SlowSource>(disk); };
}

/// Asks as a window does, frame by frame.
std::shared_ptr<const Snapshot> get(Recording& recording, double time) {
    for (int i = 0; i < 5000; ++i) {
        if (auto frame = recording.frame_at(time)) return frame;
        std::this_thread::sleep_for(1ms);
    }
    return nullptr;
}

TEST(Recording, GivesTheFrameAtOrBeforeATime) {
    Disk disk;
    Recording recording("run.h5", opener(disk), 1 << 20);
    ASSERT_TRUE(recording.frame_at(0)) << "the first one is there from the start";
    EXPECT_EQ(recording.index_at(-1), 0);
    EXPECT_EQ(recording.index_at(0.1 * 3), 3) << "a frame's own time, rounded";
    EXPECT_EQ(recording.index_at(0.39), 3);
    EXPECT_EQ(recording.index_at(100), 9);
    const auto frame = get(recording, 0.55);
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->step, 35);
    EXPECT_EQ(recording.last_read(), frame);
    EXPECT_FALSE(recording.reading());
}

TEST(Recording, NobodyWaitsForTheDiskAndOnlyTheLastFramesAskedForAreRead) {
    Disk disk;
    disk.frames = 100;
    Recording recording("run.h5", opener(disk), 1 << 20);
    get(recording, 0.1);
    disk.stick(true);
    const auto begin = std::chrono::steady_clock::now();
    for (int i = 20; i <= 90; ++i) EXPECT_FALSE(recording.frame_at(0.1 * i));
    EXPECT_LT(std::chrono::steady_clock::now() - begin, 2s);
    EXPECT_TRUE(recording.reading());
    EXPECT_EQ(recording.last_read()->step, 7) << "shown meanwhile, not what was read beforehand";
    disk.stick(false);
    ASSERT_TRUE(get(recording, 9));
    EXPECT_LT(disk.reads().size(), 12U) << "a slider drawn along does not read all that it passed";
}

TEST(Recording, ReadsTheNextFrameBeforehand) {
    Disk disk;
    Recording recording("run.h5", opener(disk), 1 << 20);
    get(recording, 0.4);
    for (int i = 0; i < 5000 && disk.reads().back() != 5; ++i) std::this_thread::sleep_for(1ms);
    EXPECT_EQ(disk.reads().back(), 5);
    EXPECT_TRUE(recording.frame_at(0.5)) << "at once";
}

TEST(Recording, KeepsWithinItsBoundWhatWasAskedForLast) {
    Disk disk;
    const std::size_t one = memory_of(test::sample_snapshot(test::sample_setup(), 1));
    Recording recording("run.h5", opener(disk), 5 * one / 2 + 2 * one);
    for (int i = 0; i < 10; ++i) {
        ASSERT_TRUE(get(recording, 0.1 * i));
        EXPECT_LT(recording.bytes(), 5 * one);
    }
    EXPECT_TRUE(recording.frame_at(0.9));
    EXPECT_FALSE(recording.frame_at(0.1)) << "gone";
    ASSERT_TRUE(get(recording, 0.1)) << "and read again";
    Disk small;
    Recording tight("run.h5", opener(small), 1);
    for (int i = 0; i < 10; ++i) ASSERT_TRUE(get(tight, 0.1 * i));
}

TEST(Recording, ADamagedFrameGivesTheOneBeforeAndAMessage) {
    Disk disk;
    disk.damaged = 4;
    Recording recording("run.h5", opener(disk), 1 << 20);
    const auto frame = get(recording, 0.4);
    ASSERT_TRUE(frame);
    EXPECT_EQ(frame->step, 21);
    EXPECT_THAT(recording.take_messages(), ElementsAre(HasSubstr("damaged")));
    EXPECT_EQ(get(recording, 0.5)->step, 35);
    get(recording, 0.4);
    EXPECT_TRUE(recording.take_messages().empty()) << "said once";
}

TEST(Recording, AProbeIsReadOffAllFramesBesideWhatIsShown) {
    Disk disk;
    disk.damaged = 4;
    const std::size_t one = memory_of(test::sample_snapshot(test::sample_setup(), 1));
    Recording recording("run.h5", opener(disk), 3 * one);
    const Probe probe{"a", "striker", Vec2(1.9, 0.1), {"velocity.y", "stress.y"}, {}};
    EXPECT_FALSE(recording.reading_probes());
    recording.add_probe(probe);
    EXPECT_TRUE(recording.reading_probes());
    ASSERT_TRUE(get(recording, 0.9)) << "what is to be shown does not wait for it";
    for (int i = 0; i < 5000 && recording.reading_probes(); ++i) std::this_thread::sleep_for(1ms);
    const std::vector<SetProbe> probes = recording.probes();
    ASSERT_EQ(probes.size(), 1U);
    const History& rows = *probes[0].rows;
    EXPECT_EQ(rows.columns().at(2).name, "probe.a.stress.y");
    EXPECT_LE(recording.bytes(), 3 * one) << "they are not kept";
    ASSERT_EQ(rows.rows(), 9U) << "all but the damaged one";
    EXPECT_EQ(recording.take_messages().size(), 1U);
    const auto setup = test::sample_setup();
    const std::vector<ProbeReading> readings = bind_probe(setup->scene, setup->mesh, probe);
    for (std::size_t row = 0; row < 9; ++row) {
        const Snapshot frame = test::sample_snapshot(setup, static_cast<int>(row < 4 ? row : row + 1));
        EXPECT_EQ(rows.values(0, row, row + 1)[0], frame.time);
        for (std::size_t k = 0; k < 2; ++k)
            EXPECT_EQ(rows.values(k + 1, row, row + 1)[0], value_of(frame, readings[k]));
    }
    recording.add_probe({"b", "anvil", Vec2(0.5, -0.5), {"velocity.x"}, {}});
    recording.remove_probe("a");
    for (int i = 0; i < 5000 && recording.reading_probes(); ++i) std::this_thread::sleep_for(1ms);
    ASSERT_EQ(recording.probes().size(), 1U);
    EXPECT_EQ(recording.probes()[0].probe.name, "b");
    EXPECT_EQ(recording.probes()[0].rows->rows(), 9U) << "from the first frame on";
}

TEST(Recording, WithoutAFrameThereIsNothingToShow) {
    Disk disk;
    disk.frames = 0;
    EXPECT_THROW(Recording("run.h5", opener(disk), 1 << 20), std::runtime_error);
}

}  // namespace
}  // namespace percuss::app
