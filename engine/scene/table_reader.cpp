#include "scene/table_reader.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "scene/parameters.hpp"

namespace percuss {
namespace {

constexpr std::string_view override_mark = "--set ";
constexpr std::size_t most_tables = 10'000;

/// The text of an expression, "= 2*shank"; nothing when the node is none.
std::optional<std::string> expression_in(const toml::node& node) {
    auto text = node.value_exact<std::string>();
    return text && Parameters::is_expression(*text) ? text : std::nullopt;
}

/// ' ("= 2*shank")' behind the value of an expression.
std::string quoted(const std::optional<std::string>& expression) {
    return expression ? " (\"" + *expression + "\")" : "";
}

}  // namespace

bool is_name(std::string_view text) {
    const auto good = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' ||
               c == '-';
    };
    return !text.empty() && std::all_of(text.begin(), text.end(), good);
}

Place place_of(const toml::source_region& region) {
    Place place{static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
    if (region.path && region.path->starts_with(override_mark)) {
        const std::string_view digits = std::string_view(*region.path).substr(override_mark.size());
        std::from_chars(digits.data(), digits.data() + digits.size(), place.override_number);
    }
    return place;
}

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

TableReader::TableReader(Faults& faults, const toml::table& table, std::string title, std::string path,
                         Parameters* parameters)
    : faults_(&faults),
      parameters_(parameters),
      table_(&table),
      title_(std::move(title)),
      path_(std::move(path)) {}

const toml::node* TableReader::find(std::string_view key) {
    known_.emplace(key);
    return table_->get(key);
}

const toml::node* TableReader::need(std::string_view key, std::string_view example) {
    const auto* node = find(key);
    if (!node) error(fmt::format("{} lacks '{}'; add {}", title_, key, example));
    return node;
}

std::optional<double> TableReader::number(const toml::node& node, const std::string& what,
                                          const Range& range) {
    const auto expression = expression_in(node);
    if (!node.is_number() && !expression) {
        faults_->error(place_of(node), fmt::format("{} is {}; it must be a number", what, type_name(node)));
        return std::nullopt;
    }
    const auto value =
        expression ? parameters_->evaluate(*expression, place_of(node), what) : node.value<double>();
    if (!value) return std::nullopt;
    if (std::isfinite(*value) && range.holds(*value)) return value;
    faults_->error(place_of(node), fmt::format("{} is {}{}; it must be {}", what, *value, quoted(expression),
                                               std::isfinite(*value) ? range.text() : "a finite number"));
    return std::nullopt;
}

std::optional<double> TableReader::number(std::string_view key, const Range& range) {
    const auto* node = find(key);
    return node ? number(*node, fmt::format("'{}'", key), range) : std::nullopt;
}

std::optional<std::int64_t> TableReader::whole(const toml::node& node, const std::string& what,
                                               const Range& range) {
    const auto expression = expression_in(node);
    if (!node.is_integer() && !expression) {
        const std::string found =
            node.is_number() ? fmt::format("{:#}", *node.value<double>()) : type_name(node);
        faults_->error(place_of(node), fmt::format("{} is {}; it must be an integer", what, found));
        return std::nullopt;
    }
    const auto value = number(node, what, range);
    if (!value) return std::nullopt;
    // Rounding takes away what the arithmetic of the expression added, never what its writer left open.
    if (std::abs(*value - std::round(*value)) <= 1e-9 && std::abs(*value) < 9e15)
        return static_cast<std::int64_t>(std::round(*value));
    faults_->error(place_of(node),
                   fmt::format("{} is {}{}; it must be an integer: use round(), floor() or ceil()", what,
                               *value, quoted(expression)));
    return std::nullopt;
}

std::optional<std::int64_t> TableReader::whole(std::string_view key, const Range& range) {
    const auto* node = find(key);
    return node ? whole(*node, fmt::format("'{}'", key), range) : std::nullopt;
}

std::optional<Formula> TableReader::formula(std::string_view key, const std::vector<std::string>& variables) {
    const auto* node = find(key);
    if (!node) return std::nullopt;
    const std::string what = fmt::format("'{}'", key);
    if (const auto expression = expression_in(*node))
        return parameters_->formula(*expression, place_of(*node), what, variables);
    const auto value = number(*node, what, any_number);
    if (!value) return std::nullopt;
    return Formula{fmt::format("{}", *value), {}, place_of(*node)};
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
        const auto value = number((*array)[i], fmt::format("'{}[{}]'", what, i), range);
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

std::optional<std::vector<double>> TableReader::list(std::string_view key, const Range& range) {
    const auto* node = find(key);
    if (!node) return std::nullopt;
    const auto* array = node->as_array();
    return checked_array(*node, std::string(key), array ? std::max<std::size_t>(array->size(), 1) : 1, range);
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
        const auto value = number(node, "'" + what + "'", any_number);
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
    if (const auto* table = node->as_table())
        return TableReader(*faults_, *table, "[" + path + "]", path, parameters_);
    error(key, fmt::format("'{}' is {}; it must be a table [{}]", key, type_name(*node), path));
    return std::nullopt;
}

std::optional<TableReader> TableReader::table(const toml::node& node, const std::string& what) {
    if (const auto* table = node.as_table()) return TableReader(*faults_, *table, what, "", parameters_);
    faults_->error(place_of(node), fmt::format("{} is {}; it must be a table", what, type_name(node)));
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
        readers.emplace_back(*faults_, *table, name ? heading + " '" + *name + "'" : heading, path,
                             parameters_);
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
