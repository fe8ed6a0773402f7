#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace percuss::app {

class Workbench;

/// What the lesson panel remembers between frames.
struct LessonState {
    std::filesystem::path file;  ///< of the scene whose lesson it is
    bool answered = false;       ///< the answer is shown
};

/// The scenes of the folder of lessons, in order: that of the scene that is shown when it has a lesson, else
/// scenes/lessons.
[[nodiscard]] std::vector<std::filesystem::path> lesson_files(const Workbench& workbench);

/// Opens the lesson so many places after the present one, the first when there is none; tells when there is
/// no such lesson.
void open_lesson(Workbench& workbench, int offset);
/// Lets the scene picker begin with the lessons.
void list_lessons(Workbench& workbench);

/// A text of a scene file without the line ends that only keep its lines short; an empty line stays one.
[[nodiscard]] std::string reflowed(const std::string& text);

}  // namespace percuss::app
