#include "workbench/script.hpp"

#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "workbench/command_table.hpp"

namespace percuss::app {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string fault(const std::string& text) {
    try {
        static_cast<void>(parse_script(text, "s.txt"));
    } catch (const ScriptError& error) {
        return error.what();
    }
    return "";
}

TEST(Script, OneEventALine) {
    const auto events =
        parse_script("# first\n\n click run.toggle 0.2 0.8 # there\nexpect messages = \"\"\n", "s.txt");
    ASSERT_EQ(events.size(), 2U);
    EXPECT_EQ(events[0].line, 3);
    EXPECT_EQ(events[0].verb, "click");
    EXPECT_THAT(events[0].arguments, ElementsAre("run.toggle", "0.2", "0.8"));
    EXPECT_THAT(events[1].arguments, ElementsAre("messages", "=", ""));
}

TEST(Script, FaultsNameLineAndCure) {
    EXPECT_EQ(fault("frames 2\nclck run.toggle\n"), "s.txt:2: unknown event 'clck'; did you mean 'click'?");
    EXPECT_THAT(fault("do run.togle"),
                HasSubstr("s.txt:1: unknown command 'run.togle'; did you mean 'run.toggle'?"));
    EXPECT_THAT(fault("key Hyper+Q"), HasSubstr("unknown key"));
    EXPECT_THAT(fault("drag viewport 0.1 0.2"), HasSubstr("write: drag WIDGET X Y X Y"));
    EXPECT_THAT(fault("click viewport left 0.2"), HasSubstr("'left' is no number"));
    EXPECT_THAT(fault("wait time ~ 3"), HasSubstr("no comparison"));
}

TEST(Commands, HaveNamesKeysAndHelpOfTheirOwn) {
    std::set<std::string> names, keys;
    for (const WorkbenchCommand& command : workbench_commands()) {
        EXPECT_TRUE(names.insert(command.name).second) << command.name;
        EXPECT_FALSE(command.help.empty()) << command.name;
        EXPECT_NE(command.act, nullptr) << command.name;
        if (command.key.empty()) continue;
        EXPECT_TRUE(keys.insert(command.key).second) << command.key;
        EXPECT_NE(parse_key(command.key).key, 0) << command.key;
    }
    for (const char* expected : {"Space", "Right", "R", "F", "Tab", "Ctrl+O", "Ctrl+L", "Ctrl+P", "F1"})
        EXPECT_TRUE(keys.contains(expected)) << expected;
}

}  // namespace
}  // namespace percuss::app
