#include "scene/parameters.hpp"

#include <algorithm>
#include <tuple>

#include <fmt/format.h>

#include "nearest_name.hpp"
#include "scene/expression.hpp"
#include "scene/table_reader.hpp"

namespace percuss {
namespace {

/// Bounds the depth to which parameters can refer to each other.
constexpr std::size_t most_parameters = 500;

/// Variables of formulas: a parameter of such a name would be hidden there.
constexpr std::array<std::string_view, 11> variables_of_formulas{"r", "z", "x", "y", "s", "i",
                                                                 "j", "R", "Z", "X", "Y"};

bool is_identifier(std::string_view text) {
    const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; };
    return !text.empty() && letter(text[0]) &&
           std::all_of(text.begin(), text.end(), [&](char c) { return letter(c) || (c >= '0' && c <= '9'); });
}

std::string fault_of_name(const std::string& name) {
    if (!is_identifier(name))
        return "is no name for expressions; use letters, digits and '_', a letter first";
    if (std::find(variables_of_formulas.begin(), variables_of_formulas.end(), name) !=
        variables_of_formulas.end())
        return "has the name of a variable of formulas; choose a longer one";
    const auto& taken = expression_names();
    if (std::find(taken.begin(), taken.end(), name) != taken.end())
        return "has the name of a function or constant; choose another";
    return "";
}

std::string quoted(const std::string& text) { return "\"" + text + "\""; }

}  // namespace

Parameters::Parameters(const toml::table* declared, Faults& faults) : faults_(&faults) {
    if (!declared) return;
    if (declared->size() > most_parameters) {
        faults.error(place_of(*declared), fmt::format("[parameters] has {} parameters; at most {} are read",
                                                      declared->size(), most_parameters));
        faults.throw_if_any();
    }
    for (const auto& [key, node] : *declared) {
        const std::string name(key.str());
        Place place = place_of(key.source());
        if (place.line == 0) place = place_of(node);
        const auto fault = fault_of_name(name);
        if (!fault.empty()) faults.error(place, fmt::format("parameter '{}' {}", name, fault));
        entries_[name] = Entry{&node, place, State::unread, {}};
        entries_[name].parameter.name = name;
    }
}

std::optional<double> Parameters::evaluate(const std::string& text, const Place& place,
                                           const std::string& what) {
    std::vector<std::pair<std::string, double>> values;
    auto expression = compile(text, place, what, {}, values);
    if (!expression) return std::nullopt;
    for (const auto& [name, number] : values) expression->set(name, number);
    try {
        return expression->value();
    } catch (const ExpressionError& error) {
        faults_->error(place, fmt::format("{} = {}: {}", what, quoted(text), error.what()));
        return std::nullopt;
    }
}

std::optional<Formula> Parameters::formula(const std::string& text, const Place& place,
                                           const std::string& what,
                                           const std::vector<std::string>& variables) {
    Formula formula{text.substr(1), {}, place};
    if (!compile(text, place, what, variables, formula.parameters)) return std::nullopt;
    return formula;
}

/// Compiles an expression and finds the values of the parameters in it.
std::optional<Expression> Parameters::compile(const std::string& text, const Place& place,
                                              const std::string& what,
                                              const std::vector<std::string>& variables,
                                              std::vector<std::pair<std::string, double>>& values) {
    try {
        Expression expression(std::string_view(text).substr(1));
        for (const auto& name : expression.names()) {
            if (std::find(variables.begin(), variables.end(), name) != variables.end()) continue;
            const auto entry = entries_.find(name);
            if (entry == entries_.end()) {
                auto known = variables;
                for (const auto& [parameter, unused] : entries_) known.push_back(parameter);
                throw ExpressionError(fmt::format("unknown name '{}'{}", name, suggest_name(name, known)));
            }
            const auto number = value(entry->second);
            if (!number) return std::nullopt;
            values.emplace_back(name, *number);
        }
        return expression;
    } catch (const ExpressionError& error) {
        faults_->error(place, fmt::format("{} = {}: {}", what, quoted(text), error.what()));
        return std::nullopt;
    }
}

std::optional<double> Parameters::value(Entry& entry) {
    const auto& name = entry.parameter.name;
    if (entry.state == State::reading) {
        std::string cycle;
        for (auto from = std::find(reading_.begin(), reading_.end(), name); from != reading_.end(); ++from)
            cycle += *from + " -> ";
        faults_->error(entry.parameter.place,
                       fmt::format("parameter '{}' depends on itself: {}{}; give one of them a number", name,
                                   cycle, name));
        return std::nullopt;
    }
    if (entry.state == State::unread) {
        entry.state = State::reading;
        reading_.push_back(name);
        const bool good = read(entry);
        reading_.pop_back();
        entry.state = good ? State::good : State::faulty;
    }
    return entry.state == State::good ? std::optional(entry.parameter.value) : std::nullopt;
}

/// @return false when the parameter has no value; why is then reported.
bool Parameters::read(Entry& entry) {
    auto& parameter = entry.parameter;
    const std::string title = "parameter '" + parameter.name + "'";
    const toml::node* node = entry.node;
    parameter.place = place_of(*node);
    std::optional<TableReader> table;
    if (const auto* declared = node->as_table()) {
        table.emplace(*faults_, *declared, title, "parameters." + parameter.name, this);
        node = table->need("value", "value = NUMBER");
        parameter.unit = table->text("unit").value_or("");
        parameter.description = table->text("description").value_or("");
        if (const auto range = table->numbers("range", 2)) {
            if ((*range)[0] <= (*range)[1])
                parameter.range = {(*range)[0], (*range)[1]};
            else
                table->error("range", "'range' is empty; write [lowest, highest]");
        }
        table->finish();
    }
    if (!node) return false;
    parameter.place = place_of(*node);
    if (const auto text = node->value_exact<std::string>()) parameter.expression = *text;
    const toml::table none;
    const auto number = TableReader(*faults_, none, title, "", this).number(*node, title, any_number);
    if (!number) return false;
    parameter.value = *number;
    if (parameter.range &&
        !Range{.low = (*parameter.range)[0], .high = (*parameter.range)[1]}.holds(*number)) {
        const std::string unit = parameter.unit.empty() ? "" : " " + parameter.unit;
        faults_->error(
            parameter.place,
            fmt::format("{} is {}{}{}; its range is {} to {}{}", title, *number, unit,
                        parameter.expression.empty() ? "" : " (" + quoted(parameter.expression) + ")",
                        (*parameter.range)[0], (*parameter.range)[1], unit));
        return false;
    }
    return true;
}

std::vector<Parameter> Parameters::all() {
    std::vector<Entry*> entries;
    for (auto& [name, entry] : entries_) entries.push_back(&entry);
    std::stable_sort(entries.begin(), entries.end(), [](const Entry* a, const Entry* b) {
        return std::tuple(a->key.line, a->key.column) < std::tuple(b->key.line, b->key.column);
    });
    std::vector<Parameter> result;
    for (auto* entry : entries) {
        static_cast<void>(value(*entry));
        result.push_back(entry->parameter);
    }
    return result;
}

}  // namespace percuss
