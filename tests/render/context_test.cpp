#include "context/context.hpp"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "context/shared_library.hpp"
#include "image.hpp"
#include "render/synthetic.hpp"
#include "view/view.hpp"

namespace percuss::render {
namespace {

std::string contents(const char* file) {
    std::ifstream stream(file);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

/// Sockets of this process that lead to an X server, by /proc/net/unix: named, or joined to a named one.
int x_connections() {
    int count = 0;
    const std::string sockets = contents("/proc/net/unix");
    for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
        std::error_code gone;
        const std::string target = std::filesystem::read_symlink(entry.path(), gone).string();
        if (target.rfind("socket:[", 0) != 0) continue;
        const std::string inode = target.substr(8, target.size() - 9);
        std::istringstream lines(sockets);
        for (std::string line; std::getline(lines, line);)
            if (line.find(" " + inode + " ") != std::string::npos &&
                line.find("X11-unix") != std::string::npos)
                ++count;
    }
    return count;
}

/// Sockets of any kind that this process has open.
int sockets() {
    int count = 0;
    for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
        std::error_code gone;
        if (std::filesystem::read_symlink(entry.path(), gone).string().rfind("socket:[", 0) == 0) ++count;
    }
    return count;
}

TEST(Context, DrawsByOsMesaWithoutAnXConnection) {
    unsetenv("DISPLAY");
    const int before = sockets();
    const auto context = make_offscreen_context();
    EXPECT_TRUE(context->is_current());
    const auto setup = synthetic::rods(2, 4, 8);
    View view(*context, setup, setup->scene.view);
    static_cast<void>(view.draw(synthetic::at_rest(setup)));
    EXPECT_THAT(contents("/proc/self/maps"), testing::HasSubstr("libOSMesa.so"));
    EXPECT_EQ(x_connections(), 0);
    EXPECT_EQ(sockets(), before);
}

TEST(Context, SeveralContextsTakeTurns) {
    const auto first = make_offscreen_context();
    const auto second = make_offscreen_context(32, 32);
    EXPECT_FALSE(first->is_current());
    const auto setup = synthetic::rods(2, 4, 8);
    View one(*first, setup, setup->scene.view), two(*second, setup, setup->scene.view);
    const Snapshot snapshot = synthetic::rods_in_contact(setup, 0.02, 50);
    const Image a = one.draw(snapshot);
    const Image b = two.draw(snapshot);
    EXPECT_EQ(a.pixels, b.pixels);
    EXPECT_EQ(one.draw(snapshot).pixels, a.pixels);
}

TEST(Context, AMissingLibraryIsNamedWithItsPackage) {
    try {
        const SharedLibrary library("libNoSuchThing.so.1", "libnosuchthing1");
        FAIL() << "no exception";
    } catch (const RenderError& error) {
        EXPECT_THAT(error.what(), testing::HasSubstr("libNoSuchThing.so.1 cannot be loaded"));
        EXPECT_THAT(error.what(), testing::HasSubstr("install the package libnosuchthing1"));
    }
}

TEST(Context, AMissingSymbolIsNamed) {
    const SharedLibrary library("libc.so.6", "libc6");
    void (*function)() = nullptr;
    try {
        library.load("percuss_has_no_such_symbol", function);
        FAIL() << "no exception";
    } catch (const RenderError& error) {
        EXPECT_THAT(error.what(),
                    testing::HasSubstr("libc.so.6 lacks the symbol percuss_has_no_such_symbol"));
    }
}

TEST(Context, AnEmptySizeIsRefused) {
    EXPECT_THROW(static_cast<void>(make_offscreen_context(0, 16)), RenderError);
}

}  // namespace
}  // namespace percuss::render
