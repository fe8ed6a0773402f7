#include <algorithm>

#include <fmt/format.h>

#include "scene/named_schemes.hpp"
#include "scene/readers.hpp"

namespace percuss {
namespace {

/// What a reader of the scene can move.
std::vector<std::string> controls(const Scene& scene) {
    std::vector<std::string> names;
    if (!scene.contacts.empty()) names.emplace_back("scheme");
    names.emplace_back(scene.step.fixed ? "model.step.fixed" : "model.step.courant");
    for (const Parameter& parameter : scene.parameters)
        if (parameter.expression.empty()) names.push_back("parameters." + parameter.name);
    if (scene.contact_solver.scheme == ContactScheme::joint)
        for (const ContactPair& pair : scene.contacts) names.push_back("contact." + pair.name + ".friction");
    return names;
}

Comparison read_comparison(TableReader& reader, const Lesson& lesson) {
    Comparison comparison;
    comparison.schemes = reader.texts("schemes").value_or(std::vector<std::string>{});
    const std::vector<std::string> known = scheme_names();
    for (const std::string& name : comparison.schemes)
        if (find_scheme(name) == nullptr)
            reader.error("schemes", fmt::format("unknown scheme '{}'{}", name, suggest_name(name, known)));
    const auto list = [&](const char* key, const Range& range) {
        return reader.find(key) ? reader.list(key, range).value_or(std::vector<double>{})
                                : std::vector<double>{};
    };
    comparison.steps = list("steps", {.low = 0, .high = 1, .low_open = true});
    comparison.values = list("values", any_number);
    if (!comparison.values.empty() && !lesson.control.starts_with("parameters."))
        reader.error("values",
                     fmt::format("'values' are those of a parameter, the control is '{}'; name 'schemes' or "
                                 "'steps'",
                                 lesson.control));
    reader.finish();
    return comparison;
}

}  // namespace

void read_lesson(TableReader& root, Scene& scene) {
    auto reader = root.table("lesson");
    if (!reader) return;
    Lesson lesson;
    lesson.place = reader->place();
    const auto text = [&](const char* key, std::string& into) {
        reader->need(key, fmt::format("{} = \"...\"", key));
        into = reader->text(key).value_or("");
        while (!into.empty() && into.back() == '\n') into.pop_back();
    };
    text("title", lesson.title);
    text("text", lesson.text);
    text("question", lesson.question);
    reader->need("control", "control = \"scheme\" or control = \"parameters.NAME\"");
    lesson.control = reader->text("control").value_or("");
    text("look_for", lesson.look_for);
    text("answer", lesson.answer);
    const std::vector<std::string> valid = controls(scene);
    if (!lesson.control.empty() && std::find(valid.begin(), valid.end(), lesson.control) == valid.end())
        reader->error("control", fmt::format("there is no control '{}'{}", lesson.control,
                                             suggest_name(lesson.control, valid)));
    if (auto comparison = reader->table("compare")) lesson.compare = read_comparison(*comparison, lesson);
    reader->finish();
    scene.lesson = std::move(lesson);
}

}  // namespace percuss
