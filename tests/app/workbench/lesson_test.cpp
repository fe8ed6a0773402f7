#include "app/workbench/window_fixture.hpp"
#include "workbench/lessons.hpp"

/// The lesson panel: what is read, the control beside it, the way from lesson to lesson.
namespace percuss {
namespace {

namespace fs = std::filesystem;

class LessonWindowTest : public test::WindowTest {
  protected:
    LessonWindowTest() {
        const std::string plain = test::text_of(path("scene.toml"));
        const auto taught = [&](const char* title, const char* control) {
            return plain + "[lesson]\ntitle = \"" + title +
                   "\"\ntext = \"They meet.\"\nquestion = \"Why?\"\ncontrol = \"" + control +
                   "\"\nlook_for = \"The force.\"\nanswer = \"So.\"\n";
        };
        fs::create_directories(path("scenes/lessons"));
        write("scenes/lessons/01-first.toml", taught("first", "parameters.speed"));
        write("scenes/lessons/02-second.toml", taught("second", "scheme"));
    }
};

TEST_F(LessonWindowTest, GoesFromLessonToLesson) {
    play(R"(
wait time = 0
frames 2
do lesson.next
wait file = scenes/lessons/01-first.toml
wait time = 0
frames 3
click lesson.answer
expect lesson.answered = 1
frames 2
widgets
screenshot first.png
click lesson.next
wait file = scenes/lessons/02-second.toml
frames 3
expect lesson.answered = 0
do lesson.next
frames 2
expect file = scenes/lessons/02-second.toml
click lesson.previous
wait file = scenes/lessons/01-first.toml
)");
    for (const char* name : {"lesson", "lesson.answer", "lesson.next", "lesson.previous", "lesson.list"})
        EXPECT_TRUE(widgets_.contains(name)) << name;
    // The control stands within the lesson, beside the picture.
    ASSERT_TRUE(widgets_.contains("parameters.speed"));
    EXPECT_LE(widgets_["lesson"][2], widgets_["viewport"][0] + 10);
}

TEST_F(LessonWindowTest, TheSchemeIsMovedByItsName) {
    play(R"(
wait time = 0
do lesson.next
wait file = scenes/lessons/01-first.toml
frames 2
do lesson.next
wait file = scenes/lessons/02-second.toml
wait time = 0
frames 3
expect scheme = projection
click scheme
frames 2
click scheme.lagged
wait scheme = lagged
expect builds = 4
click scheme
frames 2
click scheme.joint
wait scheme = joint
wait contact_solver.scheme = joint
expect messages = ""
)");
}

TEST_F(LessonWindowTest, TheWordLessonsAsksForOne) {
    write("script.txt",
          "frames 3\nwidgets\nclick picker.scenes/lessons/02-second.toml\nwait time = 0\nexpect title = "
          "\"two blocks\"\n");
    const test::Outcome outcome = run({"view", "lessons", "--headless", "--script", "script.txt"});
    EXPECT_EQ(outcome.status, 0) << outcome.err;
    EXPECT_THAT(outcome.out, testing::HasSubstr("picker.scenes/lessons/01-first.toml"));
    EXPECT_THAT(outcome.out, testing::Not(testing::HasSubstr("picker.scene.toml")));
}

TEST(LessonText, LosesTheLineEndsOfTheFile) {
    EXPECT_EQ(app::reflowed("one\ntwo\n\nthree"), "one two\n\nthree");
}

}  // namespace
}  // namespace percuss
