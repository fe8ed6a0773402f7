#include "workbench/lessons.hpp"

#include <algorithm>

#include "workbench/panels/panel.hpp"

namespace percuss::app {

namespace fs = std::filesystem;

std::vector<fs::path> lesson_files(const Workbench& w) {
    const fs::path folder = has_lesson(w) && w.run.file().has_parent_path() ? w.run.file().parent_path()
                            : has_lesson(w)                                 ? fs::path(".")
                                                                            : fs::path("scenes/lessons");
    std::vector<fs::path> files;
    std::error_code unreadable;
    for (fs::directory_iterator entry(folder, unreadable), end; !unreadable && entry != end;
         entry.increment(unreadable))
        if (entry->path().extension() == ".toml") files.push_back(entry->path());
    std::sort(files.begin(), files.end());
    return files;
}

void open_lesson(Workbench& w, int offset) {
    const std::vector<fs::path> files = lesson_files(w);
    if (files.empty()) {
        w.tell("there are no lessons in scenes/lessons");
        return;
    }
    const auto present = std::find_if(files.begin(), files.end(), [&](const fs::path& file) {
        return file.filename() == w.run.file().filename() && has_lesson(w);
    });
    const auto wanted = present == files.end() ? 0 : present - files.begin() + offset;
    if (wanted < 0 || wanted >= static_cast<std::ptrdiff_t>(files.size()))
        w.tell(wanted < 0 ? "this is the first lesson" : "this is the last lesson");
    else
        w.open(files[static_cast<std::size_t>(wanted)]);
}

void list_lessons(Workbench& w) {
    w.pick_typed = "lessons/";
    w.pick_scene = true;
}

std::string reflowed(const std::string& text) {
    std::string result;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool line_end = text[i] == '\n';
        const bool paragraph =
            line_end && ((i + 1 < text.size() && text[i + 1] == '\n') || (i > 0 && text[i - 1] == '\n'));
        result += line_end && !paragraph ? ' ' : text[i];
    }
    return result;
}

}  // namespace percuss::app
