#include "study/study.hpp"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

#include "exit_status.hpp"
#include "figures/run_figure.hpp"
#include "nearest_name.hpp"
#include "run/fields.hpp"
#include "run/history_columns.hpp"
#include "run/state_hash.hpp"
#include "scene/parse.hpp"

namespace percuss::app {
namespace {

std::vector<std::string> column_names(const Scene& scene) {
    std::vector<std::string> names;
    for (const HistoryColumn& column : history_columns(scene)) names.push_back(column.name);
    return names;
}

bool contains(const std::vector<std::string>& list, const std::string& name) {
    return std::find(list.begin(), list.end(), name) != list.end();
}

/// What both histories and summary.json have by one name: there it is the value at the end.
bool is_number_too(const std::string& column) {
    return column.starts_with("energy.") ||
           (column.starts_with("body.") && column.find(".velocity.") != std::string::npos);
}

std::vector<StudyAxis> axes_of(const Scene& scene, const StudyRequest& request) {
    std::vector<StudyAxis> axes = scene.study ? scene.study->vary : std::vector<StudyAxis>{};
    for (const std::string& text : request.vary) {
        StudyAxis asked = parse_axis(text, "--vary");
        const auto same =
            std::find_if(axes.begin(), axes.end(), [&](const StudyAxis& a) { return a.key == asked.key; });
        if (same == axes.end())
            axes.push_back(std::move(asked));
        else
            same->values = std::move(asked.values);
    }
    // What is set for all cases is not varied.
    std::erase_if(axes, [&](const StudyAxis& axis) { return is_set(axis, request.overrides); });
    if (axes.empty())
        throw UsageError(
            fmt::format("{}: nothing is varied; add --vary KEY=VALUE,VALUE, e.g. --vary "
                        "model.step.courant=0.25,0.5,0.9, or a [study] to the scene",
                        request.file));
    return axes;
}

StudyQuantity parse_quantity(const std::string& text, const Scene& scene) {
    const auto equals = text.find('=');
    StudyQuantity quantity;
    quantity.of = quantity.name = text.substr(0, equals);
    if (is_number_too(quantity.of))
        quantity.name = "final " + quantity.of;
    else if (contains(column_names(scene), quantity.of))
        quantity.name = column_title(quantity.of);
    if (equals == std::string::npos) return quantity;
    double exact = 0;
    const char* end = text.data() + text.size();
    const auto [stop, error] = std::from_chars(text.data() + equals + 1, end, exact);
    if (error != std::errc() || stop != end || exact == 0)
        throw UsageError(
            fmt::format("--quantity {}: write PATH or PATH=NUMBER, the exact answer, which is "
                        "not 0, e.g. body.rod.velocity.axial=5",
                        text));
    quantity.exact = exact;
    return quantity;
}

/// What any impact is judged by: the exact histories; the force of the first contact, its impulse; velocities
/// of the bodies that move at first.
std::vector<StudyQuantity> usual_quantities(const Scene& scene) {
    std::vector<StudyQuantity> found;
    const auto add = [&](std::string of, std::string name) {
        StudyQuantity quantity;
        quantity.of = std::move(of);
        quantity.name = std::move(name);
        found.push_back(std::move(quantity));
    };
    const std::string direction = direction_names(scene.geometry)[1];
    for (const ExactHistory& exact : scene.exact) add(exact.quantity, column_title(exact.quantity));
    if (!scene.contacts.empty()) {
        const std::string pair = "contact." + scene.contacts.front().name;
        if (scene.exact.empty()) add(pair + "." + direction, column_title(pair + "." + direction));
        add(pair + ".peak_force", "peak force");
        add(pair + ".impulse." + direction, "impulse");
    }
    for (const Body& body : scene.bodies)
        if (body.velocity[1] != 0)
            add("body." + body.name + ".velocity." + direction, "final velocity of " + body.name);
    add("energy.final", "final energy");
    return found;
}

std::vector<StudyQuantity> quantities_of(const Scene& scene, const StudyRequest& request) {
    std::vector<StudyQuantity> quantities;
    for (const std::string& text : request.quantities) quantities.push_back(parse_quantity(text, scene));
    if (quantities.empty() && scene.study) quantities = scene.study->quantities;
    if (quantities.empty()) quantities = usual_quantities(scene);
    for (StudyQuantity& quantity : quantities)
        if (request.tolerance) quantity.tolerance = *request.tolerance;
    return quantities;
}

/// "step 0.9, mesh 2 mm, joint"
std::string label_of(const std::vector<Variation>& axes, const std::vector<std::size_t>& at) {
    std::string label;
    for (std::size_t a = 0; a < axes.size(); ++a) {
        label += label.empty() ? "" : ", ";
        label += axes[a].describe(at[a]);
    }
    return label;
}

/// A result of another program is no result of this one.
std::uint64_t program_hash() {
    static const std::uint64_t hash = [] {
        std::ifstream in("/proc/self/exe", std::ios::binary);
        const std::string bytes{std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>()};
        return hash_bytes(bytes.data(), bytes.size(), 0xcbf29ce484222325u);
    }();
    return hash;
}

std::string key_of(const Study& study, const StudyCase& of) {
    std::uint64_t hash = program_hash();
    const auto add = [&](const std::string& text) {
        // With its end, so that parts do not run into each other.
        hash = hash_bytes(text.c_str(), text.size() + 1, hash);
    };
    add(study.scene.text);
    for (const std::string& setting : of.overrides) add(setting);
    for (const std::string& column : study.columns) add(column);
    return hash_text(hash);
}

/// A value that no case can be read with is a fault of the request, not of a case.
void check_values(const Study& study) {
    for (std::size_t a = 0; a < study.axes.size(); ++a)
        for (std::size_t v = 0; v < study.axes[a].values.size(); ++v) {
            const StudyCase* faulty = nullptr;
            bool all = true;
            for (const StudyCase& each : study.cases) {
                if (each.at[a] != v) continue;
                all = all && !each.scene;
                faulty = faulty == nullptr ? &each : faulty;
            }
            if (all && faulty != nullptr)
                throw UsageError(fmt::format("no case can be read with {}={}:\n{}", study.axes[a].axis.key,
                                             study.axes[a].values[v].label, faulty->fault));
        }
}

void check_quantities(const Study& study) {
    const std::vector<std::string> columns = column_names(study.scene);
    for (const StudyQuantity& quantity : study.quantities)
        if (quantity.of.starts_with("probe.") && !contains(columns, quantity.of))
            throw UsageError(
                fmt::format("there is no history '{}'{}", quantity.of, suggest_name(quantity.of, columns)));
}

}  // namespace

bool is_history(const StudyQuantity& quantity, const Study& study) {
    return contains(study.columns, quantity.of) && (quantity.history || !is_number_too(quantity.of));
}

Study make_study(const StudyRequest& request) {
    Study study;
    study.scene = load_scene(request.file, request.overrides);
    study.repeat = request.repeat;
    study.quantities = quantities_of(study.scene, request);
    const std::vector<std::string> columns = column_names(study.scene);
    for (const StudyQuantity& quantity : study.quantities)
        if (contains(columns, quantity.of) && !contains(study.columns, quantity.of) &&
            (quantity.history || !is_number_too(quantity.of)))
            study.columns.push_back(quantity.of);
    check_quantities(study);
    for (const StudyAxis& axis : axes_of(study.scene, request))
        study.axes.push_back(make_variation(axis, study.scene));
    for (const Combination& one : combine(study.axes)) {
        StudyCase of{one.at, request.overrides, "", label_of(study.axes, one.at), std::nullopt, ""};
        of.overrides.insert(of.overrides.end(), one.overrides.begin(), one.overrides.end());
        try {
            of.scene = parse_scene(study.scene.text, study.scene.file, of.overrides);
        } catch (const SceneError& error) {
            of.fault = error.what();
        }
        of.key = key_of(study, of);
        study.cases.push_back(std::move(of));
    }
    check_values(study);
    return study;
}

}  // namespace percuss::app
