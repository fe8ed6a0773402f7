#include "scene/edit_text.hpp"

#include <algorithm>
#include <optional>
#include <sstream>

#include <fmt/format.h>
#include <toml++/toml.h>

#include "scene/overrides.hpp"
#include "scene/parse.hpp"
#include "scene/table_reader.hpp"

namespace percuss {
namespace {

std::optional<toml::table> parsed(const std::string& text) {
    try {
        return toml::parse(text);
    } catch (const toml::parse_error&) {
        return std::nullopt;
    }
}

/// Offset of a position that the parser gives: lines and columns from 1, columns in characters of UTF-8.
std::size_t offset_of(std::string_view text, const toml::source_position& position) {
    std::size_t at = 0;
    for (toml::source_index line = 1; line < position.line; ++line) at = text.find('\n', at) + 1;
    for (toml::source_index column = 1; column < position.column && at < text.size(); ++column) do
            ++at;
        while (at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U);
    return at;
}

std::string in_quotes(std::string_view words) {
    std::string result = "\"";
    for (const char c : words) {
        if (c == '"' || c == '\\')
            (result += '\\') += c;
        else if (static_cast<unsigned char>(c) < 0x20)
            result += fmt::format("\\u{:04X}", static_cast<unsigned>(c));
        else
            result += c;
    }
    return result + '"';
}

std::string key_notation(const std::string& key) { return is_name(key) ? key : in_quotes(key); }

bool is_inline(const toml::node& node) {
    if (const auto* table = node.as_table()) return table->is_inline();
    const auto* array = node.as_array();
    return array == nullptr || array->empty() || !array->is_array_of_tables() ||
           array->get_as<toml::table>(0)->is_inline();
}

bool same(const toml::node& a, const toml::node& b) {
    if (const auto* table = a.as_table()) return b.is_table() && *table == *b.as_table();
    if (const auto* array = a.as_array()) return b.is_array() && *array == *b.as_array();
    return a.visit([&](const auto& value) {
        if constexpr (toml::is_value<decltype(value)>)
            return b.value_exact<std::decay_t<decltype(value.get())>>() == value.get();
        else
            return false;
    });
}

/// One difference between what a text says and what it is to say.
struct Difference {
    std::vector<std::string> path;       // keys down to the table, array elements as their index
    const toml::table* table = nullptr;  // that lacks the key, if that is what differs
    std::string key;
    const toml::node* before = nullptr;  // the node that says something else
    const toml::node* after = nullptr;   // what is to be said; null: nothing
};

void find_differences(const toml::node& before, const toml::node& after, std::vector<std::string>& path,
                      std::vector<Difference>& found) {
    const auto below = [&](const std::string& name, const toml::node& a, const toml::node& b) {
        path.push_back(name);
        find_differences(a, b, path, found);
        path.pop_back();
    };
    if (before.is_table() && after.is_table()) {
        for (const auto& [key, node] : *after.as_table()) {
            const std::string name(key.str());
            if (const auto* there = before.as_table()->get(name))
                below(name, *there, node);
            else
                found.push_back({path, before.as_table(), name, nullptr, &node});
        }
        for (const auto& [key, node] : *before.as_table())
            if (!after.as_table()->contains(key.str()))
                found.push_back({path, before.as_table(), std::string(key.str()), &node, nullptr});
        return;
    }
    const auto *a = before.as_array(), *b = after.as_array();
    if (a != nullptr && b != nullptr && a->size() == b->size()) {
        for (std::size_t i = 0; i < a->size(); ++i) below(std::to_string(i), (*a)[i], (*b)[i]);
        return;
    }
    if (!same(before, after)) found.push_back({path, nullptr, "", &before, &after});
}

std::vector<Difference> differences(const toml::table& before, const toml::table& after) {
    std::vector<Difference> found;
    std::vector<std::string> path;
    find_differences(before, after, path, found);
    return found;
}

/// A text on its way to say what a tree says.
class Editor {
  public:
    Editor(std::string_view text, const toml::table& wanted, const std::vector<std::string>& overrides)
        : text_(text), wanted_(wanted), overrides_(overrides) {}

    /// Makes one difference go. @returns whether there was one. @throws std::runtime_error when there is no
    /// place.
    bool step() {
        const auto tree = parsed(text_);
        const std::vector<Difference> all = differences(*tree, wanted_);
        if (all.empty()) return false;
        // Keys that are to go make room for those that come, so these are first.
        auto first = std::find_if(all.begin(), all.end(), [](const Difference& d) { return d.after; });
        if (first == all.end()) first = all.begin();
        for (const std::string& candidate : candidates(*tree, *first, all)) {
            const auto then = parsed(candidate);
            if (!then || differences(*then, wanted_).size() >= all.size()) continue;
            text_ = candidate;
            return true;
        }
        throw std::runtime_error(first->key.empty() && !first->path.empty() ? first->path.back()
                                                                            : first->key);
    }
    [[nodiscard]] const std::string& text() const { return text_; }

  private:
    [[nodiscard]] std::size_t at(const toml::source_position& p) const { return offset_of(text_, p); }
    [[nodiscard]] std::string replaced(std::size_t begin, std::size_t end, const std::string& by) const {
        return text_.substr(0, begin) + by + text_.substr(end);
    }

    /// As it was given, if that is TOML.
    [[nodiscard]] std::string notation(const toml::node& node) const {
        const int number = place_of(node).override_number;
        if (number > 0) {
            const std::string& given = overrides_[static_cast<std::size_t>(number) - 1];
            const std::string raw = given.substr(given.find('=') + 1);
            const auto tree = parsed("v = " + raw);
            if (tree && tree->size() == 1 && same(*tree->get("v"), node)) return raw;
        }
        if (const auto words = node.value_exact<std::string>()) return in_quotes(*words);
        if (const auto value = node.value_exact<double>()) {
            const std::string digits = fmt::format("{}", *value);
            return digits.find_first_of(".en") == std::string::npos ? digits + ".0" : digits;
        }
        std::ostringstream out;
        node.visit([&](const auto& value) { out << value; });
        return out.str();
    }

    /// The text with the difference mended, in the order of preference; not all of them need be right.
    [[nodiscard]] std::vector<std::string> candidates(const toml::table& tree, const Difference& d,
                                                      const std::vector<Difference>& all) const {
        if (d.after == nullptr) {
            if (!is_inline(*d.before)) return {};
            return {without_key(at(d.table->find(d.key)->first.source().begin), at(d.before->source().end),
                                d.table->is_inline())};
        }
        if (d.before != nullptr) {
            if (!is_inline(*d.before)) return {};
            const auto& source = d.before->source();
            return {replaced(at(source.begin), at(source.end), notation(*d.after))};
        }
        const std::string line = key_notation(d.key) + " = " + notation(*d.after);
        std::vector<std::string> result;
        for (const Difference& other : all) {  // one key takes another's place
            if (other.after != nullptr || other.table != d.table || !is_inline(*other.before)) continue;
            const auto& key = d.table->find(other.key)->first;
            result.push_back(replaced(at(key.source().begin), at(other.before->source().end), line));
        }
        if (d.table->is_inline()) {
            const std::size_t brace = at(d.table->source().end) - 1;
            const std::size_t last = text_.find_last_not_of(" \t", brace - 1);
            result.push_back(d.table->empty() ? replaced(last + 1, brace, " " + line + " ")
                                              : replaced(last + 1, last + 1, ", " + line));
            return result;
        }
        result.push_back(with_line_in_section(tree, d, line));
        std::string header;
        for (const std::string& part : d.path) header += (header.empty() ? "" : ".") + key_notation(part);
        const std::string gap = text_.ends_with('\n') ? break_ : break_ + break_;
        if (const auto* table = d.after->as_table()) {
            std::string whole =
                gap + "[" + (header.empty() ? "" : header + ".") + key_notation(d.key) + "]" + break_;
            for (const auto& [key, node] : *table)
                whole += key_notation(std::string(key.str())) + " = " + notation(node) + break_;
            // A table of its own reads better than a line among the keys of the whole scene.
            result.insert(d.path.empty() ? result.begin() : result.end(), text_ + whole);
        }
        if (!header.empty()) result.push_back(text_ + gap + "[" + header + "]" + break_ + line + break_);
        return result;
    }

    /// Without what stands from begin to end: with its comma in an inline table, else with its whole line.
    [[nodiscard]] std::string without_key(std::size_t begin, std::size_t end, bool in_table) const {
        if (!in_table) {
            const std::size_t before = text_.rfind('\n', begin), after = text_.find('\n', end);
            return replaced(before == std::string::npos ? 0 : before + 1,
                            after == std::string::npos ? text_.size() : after + 1, "");
        }
        const std::size_t next = text_.find_first_not_of(" \t", end);
        if (text_[next] == ',') return replaced(begin, text_.find_first_not_of(" \t", next + 1), "");
        const std::size_t last = text_.find_last_not_of(" \t", begin - 1);
        return replaced(text_[last] == ',' ? last : begin, end, "");
    }

    /// The key at the end of the section of its table, or of the nearest table around it that has a section.
    [[nodiscard]] std::string with_line_in_section(const toml::table& tree, const Difference& d,
                                                   const std::string& line) const {
        const toml::node* node = &tree;
        std::size_t begin = 0, own = 0;
        for (std::size_t i = 0; i < d.path.size(); ++i) {
            node = node->is_table() ? node->as_table()->get(d.path[i])
                                    : node->as_array()->get(std::stoul(d.path[i]));
            if (!node->is_table()) continue;
            const std::size_t start = at(node->source().begin);
            if (text_[start] != '[') continue;
            begin = start;
            own = i + 1;
        }
        std::string dotted;
        for (std::size_t i = own; i < d.path.size(); ++i) dotted += key_notation(d.path[i]) + ".";
        const std::size_t end = end_of_section(begin, own > 0);
        std::string before = text_.substr(0, end);
        if (!before.empty() && !before.ends_with('\n')) before += break_;
        return before + dotted + line + break_ + text_.substr(end);
    }

    /// Where the next header's line begins, less the blank lines and comments before it, which are its own.
    [[nodiscard]] std::size_t end_of_section(std::size_t begin, bool has_header) const {
        std::size_t next = text_.size();
        for (const std::size_t header : headers())
            if (header > begin || (header == begin && !has_header)) next = std::min(next, header);
        while (next > begin) {
            const std::size_t line = text_.rfind('\n', next > 1 ? next - 2 : 0);
            const std::size_t start = line == std::string::npos || next < 2 ? 0 : line + 1;
            const std::size_t first = text_.find_first_not_of(" \t\r\n", start);
            const bool idle = first >= next || text_[first] == '#';
            if (!idle || start < begin) break;
            next = start;
        }
        return next;
    }

    [[nodiscard]] std::vector<std::size_t> headers() const {
        std::vector<std::size_t> found;
        const auto tree = parsed(text_);
        collect_headers(*tree, found);
        return found;
    }
    void collect_headers(const toml::node& node, std::vector<std::size_t>& found) const {
        if (const auto* array = node.as_array()) {
            for (const auto& element : *array) collect_headers(element, found);
        } else if (const auto* table = node.as_table(); table != nullptr && !table->is_inline()) {
            const std::size_t start = at(table->source().begin);
            if (start < text_.size() && text_[start] == '[') found.push_back(start);
            for (const auto& [key, value] : *table) collect_headers(value, found);
        }
    }

    std::string text_;
    const toml::table& wanted_;
    const std::vector<std::string>& overrides_;
    const std::string break_ = text_.find("\r\n") == std::string::npos ? "\n" : "\r\n";
};

}  // namespace

std::string edit_scene_text(std::string_view text, const std::string& name,
                            const std::vector<std::string>& overrides) {
    static_cast<void>(parse_scene(text, name, overrides));  // what has a fault is not written
    Faults faults(name, overrides);
    toml::table wanted = toml::parse(text, name);
    apply_overrides(wanted, overrides, faults);
    faults.throw_if_any();
    Editor editor(text, wanted, overrides);
    try {
        while (editor.step()) {
        }
    } catch (const std::runtime_error& error) {
        throw SceneError(
            {fmt::format("{}: '{}' has no place in the text; write it there by hand", name, error.what())});
    }
    return editor.text();
}

}  // namespace percuss
