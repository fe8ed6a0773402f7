#include "app/workbench/window_fixture.hpp"

/// A user's way through the window, on the nail itself.
namespace percuss {
namespace {

namespace fs = std::filesystem;

class NailTourTest : public test::WindowTest {};

TEST_F(NailTourTest, RunsRebuildsComparesLooksBackExportsAndRecovers) {
    const fs::path source(PERCUSS_SOURCE_DIR);
    fs::create_directory_symlink(source / "scenes", path("scenes"));
    fs::copy_file(path("bad.toml"), path("broken.toml"));
    play(test::text_of(source / "tests/app/workbench/nail_tour.txt"));
    for (const char* picture :
         {"ran.png", "rebuilt.png", "compared.png", "looked-back.png", "refused.png", "nail.png"}) {
        const render::Image image = render::read_png(path(picture));
        EXPECT_GT(image.width, 500) << picture;
        EXPECT_GT(image.height, 400) << picture;
    }
    EXPECT_GT(fs::file_size(path("nail.mp4")), 10'000);
    EXPECT_FALSE(fs::exists(path("broken.png")));
}

}  // namespace
}  // namespace percuss
