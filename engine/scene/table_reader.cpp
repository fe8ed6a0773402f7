#include "scene/table_reader.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

namespace percuss {
namespace {

constexpr std::string_view override_mark = "--set ";
constexpr std::size_t most_tables = 10'000;

Place place_of(const toml::source_region& region) {
    Place place{static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
    if (region.path && region.path->starts_with(override_mark)) {
        const std::string_view digits = std::string_view(*region.path).substr(override_mark.size());
        std::from_chars(digits.data(), digits.data() + digits.size(), place.override_number);
    }
    return place;
}

bool is_name(std::string_view text) {
    const auto good = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
               c == '-';
    };
    return !text.empty() && std::all_of(text.begin(), text.end(), good);
}

}  // namespace

Place place_of(const toml::node& node) { return place_of(node.source()); }

std::string override_source(std::size_t number) {
    return std::string(override_mark) + std::to_string(number);
}

std::string type_name(const toml::node& node) {
    switch (node.type()) {
        case toml::node_type::table:
            return "a table";
        case toml::node_type::array:
            return "an array";
        case toml::node_type::string:
            return "a string";
        case toml::node_type::integer:
            return "an integer";
        case toml::node_type::floating_point:
            return "a number";
        case toml::node_type::boolean:
            return "a boolean";
        case toml::node_type::date:
            return "a date";
        case toml::node_type::time:
            return "a time";
        default:
            return "a date-time";
    }
}

bool Range::holds(double value) const {
    return (low_open ? value > low : value >= low) && (high_open ? value < high : value <= high);
}

std::string Range::text() const {
    std::string text;
    if (std::isfinite(low)) text = fmt::format("{} {}", low_open ? ">" : ">=", low);
    if (std::isfinite(high))
        text += fmt::format("{}{} {}", text.empty() ? "" : " and ", high_open ? "<" : "<=", high);
    return text;
}

TableReader::TableReader(Faults& faults, const toml::table& table, std::string title, std::string path)
    : faults_(&faults), table_(&table), title_(std::move(title)), path_(std::move(path)) {}

const toml::node* TableReader::find(std::string_view key) {
    known_.emplace(key);
    return table_->get(key);
}

const toml::node* TableReader::need(std::string_view key, std::string_view example) {
    const auto* node = find(key);
    if (!node) error(fmt::format("{} lacks '{}'; add {}", title_, key, example));
    return node;
}

std::optional<double> TableReader::checked(const toml::node& node, const std::string& what,
                                           const Range& range) {
    std::string problem;
    if (!node.is_number()) {
        problem = fmt::format("{} is {}; it must be a number", what, type_name(node));
    } else {
        const double value = *node.value<double>();
        if (!std::isfinite(value))
            problem = fmt::format("{} is {}; it must be a finite number", what, value);
        else if (!range.holds(value))
            problem = fmt::format("{} is {}; it must be {}", what, value, range.text());
        else
            return value;
    }
    faults_->error(place_of(node), problem);
    return std::nullopt;
}

std::optional<double> TableReader::number(std::string_view key, const Range& range) {
    const auto* node = find(key);
    return node ? checked(*node, fmt::format("'{}'", key), range) : std::nullopt;
}

std::optional<std::int64_t> TableReader::whole(std::string_view key, const Range& range) {
    const auto* node = find(key);
    if (!node) return std::nullopt;
    if (!node->is_integer()) {
        error(key, fmt::format("'{}' is {}; it must be an integer", key, type_name(*node)));
        return std::nullopt;
    }
    if (!checked(*node, fmt::format("'{}'", key), range)) return std::nullopt;
    return node->value<std::int64_t>();
}

std::optional<bool> TableReader::flag(std::string_view key) {
    const auto* node = find(key);
    if (!node) return std::nullopt;
    if (!node->is_boolean())
        error(key, fmt::format("'{}' is {}; it must be true or false", key, type_name(*node)));
    return node->value_exact<bool>();
}

std::optional<std::string> TableReader::text(std::string_view key) {
    const auto* node = find(key);
    if (!node) return std::nullopt;
    if (!node->is_string()) error(key, fmt::format("'{}' is {}; it must be a string", key, type_name(*node)));
    return node->value_exact<std::string>();
}

std::optional<std::string> TableReader::name(std::string_view key) {
    const auto value = text(key);
    if (!value || is_name(*value)) return value;
    error(key, fmt::format("'{}' is not a name; use letters, digits, '_' and '-' only", *value));
    return std::nullopt;
}

std::optional<std::vector<std::string>> TableReader::texts(std::string_view key) {
    const auto* node = find(key);
    if (!node) return std::nullopt;
    const auto* array = node->as_array();
    if (!array) {
        error(key, fmt::format("'{}' is {}; it must be an array of strings", key, type_name(*node)));
        return std::nullopt;
    }
    std::vector<std::string> values;
    for (const auto& element : *array) {
        if (const auto value = element.value_exact<std::string>()) {
            values.push_back(*value);
            continue;
        }
        faults_->error(place_of(element), fmt::format("'{}[{}]' is {}; it must be a string", key,
                                                      values.size(), type_name(element)));
        return std::nullopt;
    }
    return values;
}

std::optional<std::vector<double>> TableReader::checked_array(const toml::node& node, const std::string& what,
                                                              std::size_t count, const Range& range) {
    const auto* array = node.as_array();
    const std::string wanted = fmt::format("it must be an array of {} numbers", count);
    if (!array || array->size() != count) {
        const std::string found = array ? fmt::format("an array of {}", array->size()) : type_name(node);
        faults_->error(place_of(node), fmt::format("'{}' is {}; {}", what, found, wanted));
        return std::nullopt;
    }
    std::vector<double> values;
    for (std::size_t i = 0; i < count; ++i) {
        const auto value = checked((*array)[i], fmt::format("'{}[{}]'", what, i), range);
        if (value) values.push_back(*value);
    }
    if (values.size() != count) return std::nullopt;
    return values;
}

std::optional<std::vector<double>> TableReader::numbers(std::string_view key, std::size_t count,
                                                        const Range& range) {
    const auto* node = find(key);
    return node ? checked_array(*node, std::string(key), count, range) : std::nullopt;
}

std::optional<std::vector<std::vector<double>>> TableReader::rows(std::string_view key, std::size_t width) {
    const auto* node = find(key);
    return node ? checked_rows(*node, std::string(key), width) : std::nullopt;
}

std::optional<std::vector<std::vector<double>>> TableReader::checked_rows(const toml::node& node,
                                                                          const std::string& what,
                                                                          std::size_t width) {
    const auto* array = node.as_array();
    if (!array) {
        faults_->error(place_of(node), fmt::format("'{}' is {}; it must be an array of arrays of {} numbers",
                                                   what, type_name(node), width));
        return std::nullopt;
    }
    std::vector<std::vector<double>> values;
    for (const auto& row : *array) {
        auto numbers = checked_array(row, fmt::format("{}[{}]", what, values.size()), width, any_number);
        if (!numbers) return std::nullopt;
        values.push_back(std::move(*numbers));
    }
    return values;
}

std::optional<TimeFunction> TableReader::time_function(std::string_view key) {
    const auto* node = find(key);
    return node ? time_function(*node, std::string(key)) : std::nullopt;
}

std::optional<TimeFunction> TableReader::time_function(const toml::node& node, const std::string& what) {
    if (!node.is_array()) {
        const auto value = checked(node, "'" + what + "'", any_number);
        if (!value) return std::nullopt;
        return TimeFunction{{{0.0, *value}}};
    }
    const auto table = checked_rows(node, what, 2);
    if (!table) return std::nullopt;
    TimeFunction function;
    for (const auto& row : *table) function.points.emplace_back(row[0], row[1]);
    const auto not_later = [](const auto& a, const auto& b) { return !(a.first < b.first); };
    const auto& points = function.points;
    if (points.empty() || std::adjacent_find(points.begin(), points.end(), not_later) != points.end()) {
        faults_->error(place_of(node),
                       fmt::format("'{}' has no increasing times; write [[time, value], ...] with "
                                   "each time later than the one before",
                                   what));
        return std::nullopt;
    }
    return function;
}

std::optional<TableReader> TableReader::table(std::string_view key) {
    const auto* node = find(key);
    if (!node) return std::nullopt;
    const std::string path = child_path(key);
    if (const auto* table = node->as_table()) return TableReader(*faults_, *table, "[" + path + "]", path);
    error(key, fmt::format("'{}' is {}; it must be a table [{}]", key, type_name(*node), path));
    return std::nullopt;
}

std::vector<TableReader> TableReader::tables(std::string_view key) {
    const auto* node = find(key);
    if (!node) return {};
    const std::string path = child_path(key), heading = "[[" + path + "]]";
    const auto* array = node->as_array();
    if (!array || (!array->empty() && !array->is_homogeneous(toml::node_type::table))) {
        error(key, fmt::format("'{}' is {}; it must be tables {}", key, type_name(*node), heading));
        return {};
    }
    if (array->size() > most_tables) {
        error(key, fmt::format("there are {} {}; at most {} are read", array->size(), heading, most_tables));
        return {};
    }
    std::vector<TableReader> readers;
    for (const auto& element : *array) {
        const auto* table = element.as_table();
        const auto name = (*table)["name"].value_exact<std::string>();
        readers.emplace_back(*faults_, *table, name ? heading + " '" + *name + "'" : heading, path);
    }
    return readers;
}

std::string TableReader::child_path(std::string_view key) const {
    return path_.empty() ? std::string(key) : path_ + "." + std::string(key);
}

void TableReader::error(std::string_view key, std::string message) {
    faults_->error(place(key), std::move(message));
}

void TableReader::error(std::string message) { faults_->error(place(), std::move(message)); }

void TableReader::finish() {
    const std::vector<std::string> known(known_.begin(), known_.end());
    for (const auto& [key, value] : *table_) {
        if (faults_->full()) return;
        if (known_.contains(key.str())) continue;
        // An override brings its value into a table of the file: then the key has no place of its own.
        const bool from_file = place_of(value).override_number == 0 && key.source().begin.line > 0;
        faults_->error(
            from_file ? place_of(key.source()) : place_of(value),
            fmt::format("unknown key '{}' in {}{}", key.str(), title_, suggest_name(key.str(), known)));
    }
}

Place TableReader::place() const { return place_of(*table_); }

Place TableReader::place(std::string_view key) const {
    const auto* node = table_->get(key);
    return node ? place_of(*node) : place();
}

}  // namespace percuss
