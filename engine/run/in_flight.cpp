#include "run/in_flight.hpp"

#include <algorithm>
#include <array>

namespace percuss {
namespace {

using Names = std::string_view;

/// Tables and keys that are read when pictures, records and summaries are made.
constexpr std::array beside_the_run{Names("title"),  Names("description"), Names("view"),    Names("record"),
                                    Names("expect"), Names("exact"),       Names("analysis")};

/// Keys of a figure that say how it is drawn, not what is sampled for it.
constexpr std::array drawn{Names("title"),  Names("time"),       Names("range"),  Names("columns"),
                           Names("labels"), Names("axis"),       Names("factor"), Names("window"),
                           Names("times"),  Names("colour_map"), Names("along"),  Names("bins"),
                           Names("pairs"),  Names("direction")};

template <class List>
bool contains(const List& list, std::string_view name) {
    return std::find(list.begin(), list.end(), name) != list.end();
}

/// Takes the part before the first dot off the key.
std::string_view take(std::string_view& key) {
    const std::string_view part = key.substr(0, key.find('.'));
    key.remove_prefix(std::min(key.size(), part.size() + 1));
    return part;
}

}  // namespace

ChangeEffect effect_of_change(std::string_view key) {
    if (key == "model.step" || key.starts_with("model.step.")) return ChangeEffect::next_step;
    // Quoted names may hold dots: only before them is it clear which part is which.
    const bool quoted = key.find('"') != std::string_view::npos;
    const std::string_view table = take(key);
    if (contains(beside_the_run, table)) return ChangeEffect::none;
    if (table != "figure" || quoted) return ChangeEffect::rebuild;
    take(key);  // the figure's name or index
    return contains(drawn, take(key)) ? ChangeEffect::none : ChangeEffect::rebuild;
}

}  // namespace percuss
