#pragma once

#include <initializer_list>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <toml++/toml.h>

#include "nearest_name.hpp"
#include "scene/faults.hpp"
#include "scene/formula.hpp"
#include "scene/scene.hpp"

namespace percuss {

class Parameters;

/// The numbers that a key accepts.
struct Range {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    bool low_open = false, high_open = false;
    [[nodiscard]] bool holds(double value) const;
    [[nodiscard]] std::string text() const;  ///< "> -1 and < 0.5"
};
inline const Range any_number{};
inline const Range positive{.low = 0, .low_open = true};
inline const Range not_negative{.low = 0};

/// Where a node of the tree stands: in the file, or in the override that it came from.
[[nodiscard]] Place place_of(const toml::node& node);
[[nodiscard]] Place place_of(const toml::source_region& region);

/// Source path given to the tree of override number n (from 1), by which place_of knows it.
[[nodiscard]] std::string override_source(std::size_t number);

/// Reads typed values of one TOML table, any number of which may be an expression of the scene's parameters,
/// and reports faults with their places. It remembers each key that was
/// asked for, so that finish() can report the keys that nobody reads.
class TableReader {
  public:
    /// @param title how messages call the table: "[model]", "[[body]] 'rod'"
    /// @param path its dotted key, "" for the root
    /// @param parameters what expressions may use
    TableReader(Faults& faults, const toml::table& table, std::string title, std::string path,
                Parameters* parameters);

    [[nodiscard]] const toml::node* find(std::string_view key);
    /// As find; reports a missing key, quoting an example of it.
    const toml::node* need(std::string_view key, std::string_view example);

    // Each returns nothing when the key is absent or its value is faulty (which is then reported).
    [[nodiscard]] std::optional<double> number(std::string_view key, const Range& range);
    [[nodiscard]] std::optional<double> number(const toml::node& node, const std::string& what,
                                               const Range& range);
    [[nodiscard]] std::optional<std::int64_t> whole(const toml::node& node, const std::string& what,
                                                    const Range& range);
    [[nodiscard]] std::optional<std::int64_t> whole(std::string_view key, const Range& range);
    [[nodiscard]] std::optional<bool> flag(std::string_view key);
    [[nodiscard]] std::optional<std::string> text(std::string_view key);
    /// A name of our own grammar: letters, digits, '_' and '-'.
    [[nodiscard]] std::optional<std::string> name(std::string_view key);
    [[nodiscard]] std::optional<std::vector<std::string>> texts(std::string_view key);
    [[nodiscard]] std::optional<std::vector<double>> numbers(std::string_view key, std::size_t count,
                                                             const Range& range = any_number);
    /// An array of at least one number.
    [[nodiscard]] std::optional<std::vector<double>> list(std::string_view key, const Range& range);
    /// A formula of the given variables, or a number.
    [[nodiscard]] std::optional<Formula> formula(std::string_view key,
                                                 const std::vector<std::string>& variables);
    /// Array of arrays of `width` numbers; any number of rows.
    [[nodiscard]] std::optional<std::vector<std::vector<double>>> rows(std::string_view key,
                                                                       std::size_t width);
    /// A number, or [[time, value], ...] with increasing times.
    [[nodiscard]] std::optional<TimeFunction> time_function(std::string_view key);
    [[nodiscard]] std::optional<TimeFunction> time_function(const toml::node& node, const std::string& what);
    [[nodiscard]] std::optional<TableReader> table(std::string_view key);
    /// As table, for an element of an array. @param what how messages call it
    [[nodiscard]] std::optional<TableReader> table(const toml::node& node, const std::string& what);
    /// The elements of [[key]]; empty when absent.
    [[nodiscard]] std::vector<TableReader> tables(std::string_view key);

    /// One of the given words. @param noun what the words name: "geometry", "unit of length"
    template <class T>
    [[nodiscard]] std::optional<T> choice(std::string_view key, std::string_view noun,
                                          const std::vector<std::pair<std::string, T>>& words) {
        const auto word = text(key);
        if (!word) return std::nullopt;
        std::vector<std::string> names;
        for (const auto& [candidate, value] : words) {
            if (candidate == *word) return value;
            names.push_back(candidate);
        }
        error(key, "unknown " + std::string(noun) + " '" + *word + "'" + suggest_name(*word, names));
        return std::nullopt;
    }

    void error(std::string_view key, std::string message);  ///< at the value of `key`
    void error(std::string message);                        ///< at the table
    /// Reports the keys of the table that were never asked for.
    void finish();

    [[nodiscard]] Place place() const;
    [[nodiscard]] Place place(std::string_view key) const;
    [[nodiscard]] const std::string& title() const { return title_; }
    [[nodiscard]] const toml::table& node() const { return *table_; }
    [[nodiscard]] Faults& faults() { return *faults_; }

  private:
    std::optional<std::vector<std::vector<double>>> checked_rows(const toml::node& node,
                                                                 const std::string& what, std::size_t width);
    std::optional<std::vector<double>> checked_array(const toml::node& node, const std::string& what,
                                                     std::size_t count, const Range& range);

    [[nodiscard]] std::string child_path(std::string_view key) const;

    Faults* faults_;
    Parameters* parameters_;
    const toml::table* table_;
    std::string title_, path_;
    std::set<std::string, std::less<>> known_;
};

/// True for letters, digits, '_' and '-'.
[[nodiscard]] bool is_name(std::string_view text);

/// "a string", "an integer", ...
[[nodiscard]] std::string type_name(const toml::node& node);

}  // namespace percuss
