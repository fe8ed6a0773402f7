#include <algorithm>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <imgui.h>

#include "workbench/panels/panel.hpp"

namespace percuss::app {
namespace {

/// Line ends where the panel ends, between words alone: ImGui would begin a line with a comma.
std::string wrapped(const std::string& text, float width) {
    std::string result, line;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find_first_of(" \n", begin), text.size());
        const std::string word = text.substr(begin, end - begin);
        const std::string longer = line.empty() ? word : line + ' ' + word;
        const bool fits = ImGui::CalcTextSize(longer.c_str()).x <= width;
        if (!fits && !line.empty()) result += line + '\n';
        line = fits ? longer : word;
        if (end < text.size() && text[end] == '\n') result += std::exchange(line, "") + '\n';
        begin = end + 1;
    }
    return result + line;
}

void show_text(const std::string& text) {
    ImGui::TextUnformatted(wrapped(reflowed(text), ImGui::GetContentRegionAvail().x).c_str());
}

void show_heading(Workbench& w, const std::string& text) {
    ImGui::Dummy({0, 0.25F * ImGui::GetFontSize()});
    ImGui::PushFont(w.screen.fonts().bold);
    show_text(text);
    ImGui::PopFont();
}

void show_control(Workbench& w, const std::string& control) {
    if (control == "scheme")
        show_scheme_choice(w);
    else if (const DesignValue* value = w.run.design_value(control))
        show_design_value(w, *value);
}

void show_ways_on(Workbench& w) {
    command_button(w, "lesson.previous");
    ImGui::SameLine();
    command_button(w, "lesson.next");
    ImGui::SameLine();
    command_button(w, "lesson.list");
}

}  // namespace

bool has_lesson(const Workbench& w) {
    return w.run.snapshot() && !w.run.recorded() && w.run.snapshot()->setup->scene.lesson.has_value();
}

void show_lesson(Workbench& w, const PanelArea& area) {
    const Panel panel("lesson", area);
    w.names.place("lesson", {area.x, area.y, area.x + area.width, area.y + area.height});
    if (w.lesson.file != w.run.file()) {
        w.lesson = {w.run.file(), false};
        ImGui::SetScrollY(0);
    }
    const Lesson& lesson = *w.run.snapshot()->setup->scene.lesson;
    const std::vector<std::filesystem::path> files = lesson_files(w);
    const auto place = std::find(files.begin(), files.end(), w.run.file());
    if (place != files.end())
        ImGui::TextDisabled("Lesson %d of %d", static_cast<int>(place - files.begin()) + 1,
                            static_cast<int>(files.size()));
    show_heading(w, lesson.title);
    show_text(lesson.text);
    show_heading(w, lesson.question);
    show_control(w, lesson.control);
    ImGui::Spacing();
    show_text(lesson.look_for);
    ImGui::Spacing();
    command_button(w, "lesson.answer", w.lesson.answered ? "Hide the answer" : "Show the answer");
    if (w.lesson.answered) show_text(lesson.answer);
    ImGui::Separator();
    show_ways_on(w);
}

}  // namespace percuss::app
