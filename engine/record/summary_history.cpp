#include "record/summary_history.hpp"

#include <algorithm>
#include <optional>
#include <vector>

#include "run/series.hpp"

namespace percuss {
namespace {

using Json = nlohmann::ordered_json;
using Column = std::vector<double>;

/// A column's numbers in the rows that "time" has too; nothing when there is no such column.
std::optional<Column> column(const History& history, const std::string& name, std::size_t rows) {
    const auto& columns = history.columns();
    const auto found =
        std::find_if(columns.begin(), columns.end(), [&](const auto& c) { return c.name == name; });
    if (found == columns.end() || rows == 0) return std::nullopt;
    return history.values(static_cast<std::size_t>(found - columns.begin()), 0, rows);
}

std::optional<double> stop_time(const Column& time, const Column& velocity) {
    const double start = velocity.front();
    for (std::size_t k = 1; k < velocity.size(); ++k) {
        if (start == 0 || velocity[k] * start > 0) continue;
        const double share = velocity[k - 1] / (velocity[k - 1] - velocity[k]);
        return time[k - 1] + share * (time[k] - time[k - 1]);
    }
    return std::nullopt;
}

}  // namespace

Json contact_history(const History& history, const std::string& pair,
                     const std::array<std::string, 2>& directions) {
    Json result = Json::object();
    const std::size_t rows = history.rows();
    const auto time = column(history, "time", rows);
    if (!time) return result;
    const std::string name = "contact." + pair + ".";
    for (const std::string& direction : directions) {
        const auto force = column(history, name + direction, rows);
        if (!force) continue;
        const std::size_t peak = largest_magnitude(*force);
        result["peak"][direction] = {{"value", (*force)[peak]}, {"time", (*time)[peak]}};
    }
    if (const auto active = column(history, name + "active", rows)) {
        const auto touches = [](double count) { return count > 0; };
        const auto first = std::find_if(active->begin(), active->end(), touches);
        const auto last = std::find_if(active->rbegin(), active->rend(), touches);
        if (first != active->end()) {
            result["first_touch"] = (*time)[static_cast<std::size_t>(first - active->begin())];
            result["last_touch"] = (*time)[static_cast<std::size_t>(active->rend() - last) - 1];
        }
    }
    return result;
}

Json body_history(const History& history, const std::string& body,
                  const std::array<std::string, 2>& directions) {
    Json result = Json::object();
    const std::size_t rows = history.rows();
    const auto time = column(history, "time", rows);
    if (!time) return result;
    for (const std::string& direction : directions) {
        const auto velocity = column(history, "body." + body + ".velocity." + direction, rows);
        if (!velocity) continue;
        const auto [least, most] = std::minmax_element(velocity->begin(), velocity->end());
        result["velocity_min"][direction] = *least;
        result["velocity_max"][direction] = *most;
        if (const auto stop = stop_time(*time, *velocity)) result["stops"][direction] = *stop;
    }
    return result;
}

}  // namespace percuss
