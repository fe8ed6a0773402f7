#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "scene/readers.hpp"

namespace percuss {
namespace {

constexpr std::array<std::string_view, 5> promise_keys{"value", "tolerance", "min", "max", "why"};

void read_promise(TableReader& reader, const std::string& path, Scene& scene) {
    Expectation promise;
    promise.path = path;
    promise.place = reader.place();
    promise.why = reader.text("why").value_or("");
    const auto value = reader.number("value", any_number),
               tolerance = reader.number("tolerance", not_negative);
    const auto min = reader.number("min", any_number), max = reader.number("max", any_number);
    const bool by_value = reader.find("value"), by_range = reader.find("min") || reader.find("max");
    if (by_value == by_range || (reader.find("tolerance") && !by_value))
        reader.error(fmt::format(
            "'{}' must be promised as {{value = .., tolerance = ..}} or as {{min = .., max = ..}}", path));
    promise.min = min.value_or(-std::numeric_limits<double>::infinity());
    promise.max = max.value_or(std::numeric_limits<double>::infinity());
    if (value) promise.min = *value - tolerance.value_or(0), promise.max = *value + tolerance.value_or(0);
    if (promise.min > promise.max)
        reader.error(
            fmt::format("'{}' cannot be kept: min {} is above max {}", path, promise.min, promise.max));
    reader.finish();
    scene.expect.push_back(std::move(promise));
}

bool is_promise(const toml::table& table) {
    return table.empty() || std::any_of(table.begin(), table.end(), [](const auto& entry) {
               const auto& [key, value] = entry;
               return !value.is_table() &&
                      std::find(promise_keys.begin(), promise_keys.end(), key.str()) != promise_keys.end();
           });
}

/// Paths may be written as one quoted key or as nested tables: energy.maximum_loss = {...}.
void read_promises_below(TableReader& reader, const std::string& path, Scene& scene) {
    for (const auto& [key, value] : reader.node()) {
        const std::string below = path.empty() ? std::string(key.str()) : path + "." + std::string(key.str());
        auto inner = reader.table(key.str());
        if (!inner) continue;
        if (is_promise(inner->node()))
            read_promise(*inner, below, scene);
        else
            read_promises_below(*inner, below, scene);
    }
}

void read_exact(TableReader& reader, Scene& scene) {
    ExactHistory exact;
    exact.place = reader.place();
    reader.need("quantity", "quantity = \"contact.NAME.axial\"");
    exact.quantity = reader.text("quantity").value_or("");
    if (!exact.quantity.empty()) check_column(reader, "quantity", scene, exact.quantity);
    exact.label = reader.text("label").value_or(exact.quantity);
    exact.window = reader.number("window", not_negative).value_or(0);
    reader.need("points", "points = [[time, value], ...]");
    for (const auto& row : reader.rows("points", 2).value_or(std::vector<std::vector<double>>{}))
        exact.points.emplace_back(row[0], row[1]);
    const auto earlier = [](const auto& a, const auto& b) { return b.first < a.first; };
    if (std::adjacent_find(exact.points.begin(), exact.points.end(), earlier) != exact.points.end())
        reader.error("points",
                     "the times of 'points' fall; order them by time, a jump as two points at one time");
    if (reader.node().contains("points") && exact.points.size() < 2 && reader.node()["points"].is_array())
        reader.error("points", "'points' has fewer than two points; write [[time, value], [time, value]]");
    reader.finish();
    scene.exact.push_back(std::move(exact));
}

}  // namespace

void check_column(TableReader& reader, std::string_view key, const Scene& scene, const std::string& column) {
    const auto first = column.find('.');
    const std::string kind = column.substr(0, first);
    const auto rest = first == std::string::npos ? std::string() : column.substr(first + 1);
    const std::string name = rest.substr(0, rest.find('.'));
    const auto check = [&](std::string_view noun, const std::vector<std::string>& names) {
        if (std::find(names.begin(), names.end(), name) == names.end())
            reader.error(
                key, fmt::format("unknown {} '{}' in '{}'{}", noun, name, column, suggest_name(name, names)));
    };
    if (kind == "contact") check("contact", names_of(scene.contacts));
    if (kind == "body") check("body", names_of(scene.bodies));
    if (kind == "probe") check("probe", names_of(scene.probes));
}

void read_promises(TableReader& root, Scene& scene) {
    for (auto& reader : root.tables("exact")) read_exact(reader, scene);
    if (auto expect = root.table("expect")) read_promises_below(*expect, "", scene);
}

}  // namespace percuss
