#include <algorithm>
#include <array>
#include <sstream>

#include <fmt/format.h>

#include "scene/readers.hpp"

namespace percuss {
namespace {

std::string last_part(const std::string& key) { return key.substr(key.rfind('.') + 1); }

/// A value as it would follow KEY= on the command line. Nothing for what no key takes.
std::optional<std::string> value_text(const toml::node& node) {
    if (const auto text = node.value_exact<std::string>()) return text;
    if (const auto number = node.value_exact<double>()) return fmt::format("{}", *number);
    if (!node.is_integer() && !node.is_boolean() && !node.is_array()) return std::nullopt;
    std::ostringstream text;
    node.visit([&](const auto& value) { text << value; });
    return text.str();
}

void read_axis(TableReader& reader, StudySpec& study) {
    StudyAxis axis;
    axis.place = reader.place();
    reader.need("key", "key = \"model.step.courant\"");
    axis.key = reader.text("key").value_or("");
    axis.name = reader.text("name").value_or(usual_name(axis.key));
    axis.kind = reader
                    .choice<AxisKind>("kind", "kind",
                                      {{"step", AxisKind::step},
                                       {"mesh", AxisKind::mesh},
                                       {"method", AxisKind::method},
                                       {"design", AxisKind::design}})
                    .value_or(usual_kind(axis.key));
    const toml::node* values = reader.need("values", "values = [0.9, 0.5]");
    const toml::array* array = values ? values->as_array() : nullptr;
    if (values && (!array || array->empty()))
        reader.error("values", "'values' must be an array of at least one value, e.g. [0.9, 0.5]");
    if (array)
        for (const toml::node& node : *array) {
            const auto text = value_text(node);
            if (!text)
                reader.error("values",
                             fmt::format("a value is {}; write numbers, strings or arrays", type_name(node)));
            else if (std::find(axis.values.begin(), axis.values.end(), *text) != axis.values.end())
                reader.error("values", fmt::format("the value {} stands there twice", *text));
            else
                axis.values.push_back(*text);
        }
    const auto same = [&](const StudyAxis& other) { return other.key == axis.key; };
    if (!axis.key.empty() && std::any_of(study.vary.begin(), study.vary.end(), same))
        reader.error("key", fmt::format("'{}' is varied twice; write all its values once", axis.key));
    reader.finish();
    study.vary.push_back(std::move(axis));
}

void read_quantity(TableReader& reader, const Scene& scene, StudySpec& study) {
    StudyQuantity quantity;
    quantity.place = reader.place();
    reader.need("of", "of = \"contact.NAME.peak_force\"");
    quantity.of = reader.text("of").value_or("");
    if (!quantity.of.empty()) check_column(reader, "of", scene, quantity.of);
    quantity.name = reader.text("name").value_or(quantity.of);
    quantity.exact = reader.number("exact", any_number);
    quantity.scale = reader.number("scale", positive);
    quantity.tolerance = reader.number("tolerance", positive).value_or(0.01);
    quantity.history = reader.flag("history").value_or(false);
    if (quantity.exact == 0.0 && !quantity.scale)
        reader.error("exact", "no error is relative to 0; add 'scale', the number that errors are parts of");
    reader.finish();
    study.quantities.push_back(std::move(quantity));
}

}  // namespace

AxisKind usual_kind(const std::string& key) {
    const std::string last = last_part(key);
    if (key.starts_with("model.step.")) return AxisKind::step;
    if (key.find(".divisions") != std::string::npos || last == "mesh") return AxisKind::mesh;
    static constexpr std::array methods{"scheme",  "level",     "sign",          "element",
                                        "pattern", "hourglass", "penalty",       "viscosity",
                                        "lagged",  "solver",    "recovery_speed"};
    const bool method = std::any_of(methods.begin(), methods.end(), [&](const char* m) { return last == m; });
    return method || key.find(".layer") != std::string::npos || key.find(".viscosity.") != std::string::npos
               ? AxisKind::method
               : AxisKind::design;
}

std::string usual_name(const std::string& key) {
    if (key == "model.step.courant") return "step";
    return last_part(key);
}

void read_study(TableReader& root, Scene& scene) {
    auto reader = root.table("study");
    if (!reader) return;
    StudySpec study;
    study.place = reader->place();
    for (auto& axis : reader->tables("vary")) read_axis(axis, study);
    for (auto& quantity : reader->tables("quantity")) read_quantity(quantity, scene, study);
    reader->finish();
    scene.study = std::move(study);
}

void read_accuracy(TableReader& root, Scene& scene) {
    auto reader = root.table("accuracy");
    if (!reader) return;
    constexpr const char* example = "target = { quantity = \"contact.NAME.peak_force\", tolerance = 0.01 }";
    AccuracyTarget target;
    target.place = reader->place();
    reader->need("target", example);
    if (auto inner = reader->table("target")) {
        inner->need("quantity", "quantity = \"contact.NAME.peak_force\"");
        target.quantity = inner->text("quantity").value_or("");
        if (!target.quantity.empty()) check_column(*inner, "quantity", scene, target.quantity);
        target.tolerance = inner->number("tolerance", positive).value_or(0.01);
        inner->finish();
    }
    const auto refines = [](const StudyAxis& axis) {
        return axis.kind == AxisKind::step || axis.kind == AxisKind::mesh;
    };
    if (!scene.study || std::none_of(scene.study->vary.begin(), scene.study->vary.end(), refines))
        reader->error(
            "[accuracy] has no steps or meshes to choose from; add a [[study.vary]] with key = "
            "\"model.step.courant\" and values = [0.9, 0.5, 0.25]");
    reader->finish();
    scene.accuracy = std::move(target);
}

}  // namespace percuss
