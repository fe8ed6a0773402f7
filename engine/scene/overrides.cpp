#include "scene/overrides.hpp"

#include <algorithm>
#include <charconv>
#include <optional>
#include <span>

#include <fmt/format.h>

#include "nearest_name.hpp"
#include "scene/input_limits.hpp"
#include "scene/table_reader.hpp"

namespace percuss {
namespace {

using Path = std::span<const std::string>;

std::string joined(Path path) {
    std::string text;
    for (const auto& part : path) text += (text.empty() ? "" : ".") + part;
    return text;
}

/// Parts between dots; dots inside double quotes do not part, and the quotes go.
std::vector<std::string> split(std::string_view text) {
    std::vector<std::string> parts(1);
    bool quoted = false;
    for (const char c : text) {
        if (c == '"')
            quoted = !quoted;
        else if (c == '.' && !quoted)
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

std::string quoted(std::string_view text) {
    std::string result = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') result += '\\';
        result += c;
    }
    return result + "\"";
}

bool is_bare_word(std::string_view text) {
    // An expression, "= 2*shank"; what else it may hold is its own reader's to judge.
    if (text.starts_with('=')) return text.find_first_of("\n\r") == std::string_view::npos;
    return text.find_first_of("\"'[]{}=,#\n\r\t\\") == std::string_view::npos;
}

constexpr std::string_view scheme_key = "contact_solver.scheme";

/// One override under way: where in the tree it goes, and what to say when it cannot.
class Override {
  public:
    /// @param last_scheme whether no later override chooses the scheme of contact anew.
    Override(std::size_t number, bool last_scheme, Faults& faults)
        : number_(number), last_scheme_(last_scheme), faults_(&faults) {}

    void apply(toml::table& root, std::string_view text) {
        const auto equals = text.find('=');
        if (equals == std::string_view::npos || equals == 0)
            return fail("no value; write --set KEY=VALUE, e.g. --set model.step.courant=0.5");
        const auto key = text.substr(0, equals);
        value_ = text.substr(equals + 1);
        auto path = split(key);
        for (const auto& part : path)
            if (part.empty())
                return fail(fmt::format("'{}' is not a key; write e.g. model.step.courant", key));
        if (path.size() > most_parts)
            return fail("the key has too many parts; write e.g. model.step.courant");
        const auto fault = fault_of_input(value_);
        plain_ = !fault;
        if (fault && !is_bare_word(value_)) return fail(fault->second);
        if (value_.find_first_of("\n\r") != std::string_view::npos)
            return fail("the value has several lines");
        if (path.size() == 2 && path[0] == "parameters" && !find_parameter(root, path)) return;
        set_in_table(root, path, "the scene");
        if (joined(path) == "model.step.fixed") forget(root, "courant");
        if (joined(path) == "model.step.courant") forget(root, "fixed");
        if (joined(path) == scheme_key && last_scheme_) forget_other_schemes(root);
        if (path.size() == 3 && path[0] == "body" && path[2] == "element")
            forget_other_elements(root, path[1]);
    }

  private:
    static constexpr std::size_t most_parts = 16;

    void fail(std::string message) { faults_->error({.override_number = number()}, std::move(message)); }
    [[nodiscard]] int number() const { return static_cast<int>(number_); }

    /// Leads to the `value` of a parameter that has a table. False, and told, when there is no such
    /// parameter: a new one could have no effect.
    bool find_parameter(toml::table& root, std::vector<std::string>& path) {
        const auto* parameters = root["parameters"].as_table();
        const auto* node = parameters ? parameters->get(path[1]) : nullptr;
        if (!node) {
            std::vector<std::string> names;
            if (parameters)
                for (const auto& [name, value] : *parameters) names.emplace_back(name.str());
            fail(fmt::format("there is no parameter '{}'{}", path[1], suggest_name(path[1], names)));
            return false;
        }
        if (node->is_table() && !value_.starts_with('{')) path.emplace_back("value");
        return true;
    }

    static void forget(toml::table& root, std::string_view key) {
        if (auto* step = root.at_path("model.step").as_table()) step->erase(key);
    }

    /// What a scene says for one scheme of contact would be a fault with another. The projection has rows of
    /// its own, too.
    void forget_other_schemes(toml::table& root) const {
        const auto is = [&](std::string_view scheme) { return value_ == scheme || value_ == quoted(scheme); };
        if (auto* solver = root["contact_solver"].as_table()) {
            if (!is("penalty") && !is("bipenalty")) solver->erase("penalty");
            if (!is("penalty")) solver->erase("step");
            if (!is("joint")) solver->erase("recovery_speed");
            if (!is("joint") && !is("bipenalty")) solver->erase("solver");
        }
        if (!is("projection")) return;
        if (auto* pairs = root["contact"].as_array())
            for (toml::node& pair : *pairs)
                if (auto* table = pair.as_table()) table->erase("scheme");
    }

    /// Likewise what a body says for one kind of element.
    void forget_other_elements(toml::table& root, const std::string& body) const {
        auto* bodies = root["body"].as_array();
        const auto index = bodies ? element(*bodies, body) : std::nullopt;
        auto* table = index ? bodies->get_as<toml::table>(*index) : nullptr;
        if (!table) return;
        if (value_.find("one-point quad") == std::string_view::npos) table->erase("hourglass");
        if (value_.find("triangle") == std::string_view::npos) table->erase("pattern");
    }

    void set_in_table(toml::table& table, Path path, const std::string& title) {
        // Keys may hold dots ("energy.maximum_loss"): the longest key that the table has wins.
        for (std::size_t length = path.size(); length > 0; --length) {
            auto* child = table.get(joined(path.first(length)));
            if (!child) continue;
            const Path rest = path.subspan(length);
            if (rest.empty()) break;
            return set_below(*child, rest, joined(path.first(length)));
        }
        // Nothing below exists: the missing tables are made by parsing the whole rest of the path. The reader
        // then finds keys that it does not know, and names the nearest.
        const bool known = table.contains(joined(path));
        const std::string name = known ? joined(path) : path.front();
        auto document = parse(known ? Path(&name, 1) : path, title);
        if (!document) return;
        move_into(table, name, *document->get(name));
    }

    void set_below(toml::node& node, Path path, const std::string& title) {
        if (auto* table = node.as_table()) return set_in_table(*table, path, title);
        auto* array = node.as_array();
        if (!array)
            return fail(fmt::format("'{}' is {} and has no '{}'; set '{}' itself", title, type_name(node),
                                    joined(path), title));
        const auto index = element(*array, path.front());
        if (!index)
            return fail(
                fmt::format("there is no {} '{}'{}", title, path.front(), suggest(*array, path.front())));
        auto& child = *array->get(*index);
        if (path.size() > 1) return set_below(child, path.subspan(1), title + "." + path.front());
        const std::string name = "value";
        if (auto document = parse(Path(&name, 1), title)) {
            document->get(name)->visit([&](auto& value) {
                array->replace(array->cbegin() + static_cast<std::ptrdiff_t>(*index), std::move(value));
            });
        }
    }

    static std::optional<std::size_t> element(const toml::array& array, const std::string& name) {
        for (std::size_t i = 0; i < array.size(); ++i) {
            const auto* table = array.get_as<toml::table>(i);
            if (table && (*table)["name"].value_exact<std::string>() == name) return i;
        }
        std::size_t index = 0;
        const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), index);
        if (error != std::errc() || end != name.data() + name.size() || index >= array.size())
            return std::nullopt;
        return index;
    }

    static std::string suggest(const toml::array& array, const std::string& name) {
        std::vector<std::string> names;
        for (const auto& item : array) {
            const auto* table = item.as_table();
            if (const auto found = table ? (*table)["name"].value_exact<std::string>() : std::nullopt)
                names.push_back(*found);
        }
        if (names.empty()) return fmt::format("; there are {}, counted from 0", array.size());
        return suggest_name(name, names);
    }

    /// A document in which `path` holds the value, with the override as its source.
    std::optional<toml::table> parse(Path path, const std::string& title) {
        std::string key;
        for (const auto& part : path) key += (key.empty() ? "" : ".") + quoted(part);
        const auto source = override_source(number_);
        std::string reason;
        for (const bool as_string : {false, true}) {
            if (as_string ? !is_bare_word(value_) : !plain_) continue;
            try {
                const std::string value = as_string ? quoted(value_) : std::string(value_);
                auto document = toml::parse(key + " = " + value, source);
                if (document.size() == 1) return document;
            } catch (const toml::parse_error& error) {
                if (reason.empty()) reason = error.description();
            }
        }
        fail(fmt::format("the value for {} is not TOML ({}); write e.g. 0.5, [0, -20] or \"text\"", title,
                         reason));
        return std::nullopt;
    }

    static void move_into(toml::table& table, const std::string& name, toml::node& node) {
        // Moving keeps the source of the value, by which messages name the override; copying would lose it.
        node.visit([&](auto& value) { table.insert_or_assign(name, std::move(value)); });
    }

    std::size_t number_;
    bool last_scheme_;
    Faults* faults_;
    std::string_view value_;
    bool plain_ = true;  // may be given to the TOML parser without quotes
};

}  // namespace

void apply_overrides(toml::table& root, const std::vector<std::string>& overrides, Faults& faults) {
    const auto last = std::find_if(overrides.rbegin(), overrides.rend(), [](const std::string& text) {
        return std::string_view(text).substr(0, text.find('=')) == scheme_key;
    });
    const auto last_scheme = static_cast<std::size_t>(overrides.rend() - last);  // counted from 1
    for (std::size_t i = 0; i < overrides.size(); ++i)
        Override(i + 1, i + 1 == last_scheme, faults).apply(root, overrides[i]);
}

}  // namespace percuss
