#include "run/design_values.hpp"

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "run/fields.hpp"
#include "scene/expression.hpp"
#include "scene/expressions.hpp"
#include "scene/scheme_names.hpp"

namespace percuss {
namespace {

constexpr double none = -std::numeric_limits<double>::infinity();
using Range = std::optional<std::array<double, 2>>;

/// Collects the values of one scene, which it varies to see what that takes.
class Collector {
  public:
    explicit Collector(const Scene& scene)
        : scene_(&scene), varied_(scene), expressions_(expressions_in(scene)) {}

    void begin(std::string group) { group_ = std::move(group); }

    /// @param of finds the number in a scene
    template <class Find>
    void add(const std::string& key, std::string title, Quantity quantity, const Range& range, double least,
             std::string help, Find of) {
        DesignValue value;
        value.key = key;
        value.group = group_;
        value.title = std::move(title);
        value.unit = scene_->units.label(quantity);
        value.help = std::move(help);
        double& number = of(varied_);
        value.number = number;
        value.range = range;
        value.least = least;
        value.expression = expression(key);
        number = value.number != 0 ? 0.99 * value.number : 0.01;
        value.effect = effect_of_change(*scene_, varied_);
        number = value.number;
        values_.push_back(std::move(value));
    }

    void add_scheme() {
        DesignValue value;
        value.key = "contact_solver.scheme";
        value.group = group_;
        value.title = "contact scheme";
        value.help =
            "projection: the paper's, pair by pair. joint: one problem for all pairs that share nodes; "
            "between "
            "the two a run goes on. "
            "penalty: "
            "springs. bipenalty: springs with inertia. massless: contact nodes without mass; to and from it "
            "the run "
            "begins anew.";
        for (const auto& [name, scheme] : contact_scheme_words()) value.choices.push_back(name);
        value.choice = name_of(scene_->contact_solver.scheme);
        value.expression = expression(value.key);
        value.effect = ChangeEffect::next_step;
        values_.push_back(std::move(value));
    }

    void add_parameters() {
        std::vector<DesignValue> all;
        for (const Parameter& parameter : scene_->parameters) {
            DesignValue value;
            value.key = "parameters." + parameter.name;
            value.group = "parameters";
            value.title = parameter.name;
            value.unit = parameter.unit;
            value.help = parameter.description;
            value.number = parameter.value;
            value.range = parameter.range;
            value.expression = parameter.expression;
            value.effect = effect_of_parameter(parameter.name);
            all.push_back(std::move(value));
        }
        values_.insert(values_.begin(), std::make_move_iterator(all.begin()),
                       std::make_move_iterator(all.end()));
    }

    std::vector<DesignValue> take() { return std::move(values_); }

  private:
    [[nodiscard]] std::string expression(const std::string& key) const {
        const auto found = expressions_.find(key);
        return found == expressions_.end() ? "" : found->second;
    }

    /// The strongest effect among all values that follow from a parameter.
    ChangeEffect effect_of_parameter(const std::string& name) {
        if (users_.empty()) find_users();
        const auto known = effects_.find(name);
        if (known != effects_.end()) return known->second;
        ChangeEffect strongest = ChangeEffect::none;
        effects_[name] = strongest;
        for (const std::string& key : users_[name]) strongest = std::max(strongest, effect_of_key(key));
        return effects_[name] = strongest;
    }

    ChangeEffect effect_of_key(const std::string& key) {
        constexpr std::string_view parameters = "parameters.";
        if (key.starts_with(parameters)) return effect_of_parameter(key.substr(parameters.size()));
        for (const DesignValue& value : values_)
            if (value.key == key) return value.effect;
        // Loads may change in size and time, whatever the depth at which a number stands in them.
        const bool load = key.starts_with("body.") && key.find(".load.") != std::string::npos;
        return load ? ChangeEffect::next_step : effect_of_change(key);
    }

    void find_users() {
        for (const auto& [key, text] : expressions_) {
            try {
                const Expression compiled(std::string_view(text).substr(1));
                for (const std::string& name : compiled.names()) users_[name].insert(key);
            } catch (const ExpressionError&) {
                continue;  // a text that begins like one, in a place that knows none
            }
        }
    }

    const Scene* scene_;
    Scene varied_;
    std::map<std::string, std::string> expressions_;
    std::map<std::string, std::set<std::string>> users_;  // parameter -> keys
    std::map<std::string, ChangeEffect> effects_;         // of parameters
    std::string group_;
    std::vector<DesignValue> values_;
};

void add_run(Collector& list, const Scene& scene) {
    list.begin("run");
    if (scene.step.fixed)
        list.add("model.step.fixed", "time step", Quantity::time, {}, 0, "",
                 [](Scene& s) -> double& { return *s.step.fixed; });
    else
        list.add("model.step.courant", "step / critical", Quantity::dimensionless, {{0.05, 1.0}}, 0,
                 "Time step as a fraction of the critical one.",
                 [](Scene& s) -> double& { return s.step.courant; });
    if (scene.contacts.empty()) return;
    list.add_scheme();
    if (scene.contact_solver.scheme == ContactScheme::joint)
        list.add("contact_solver.recovery_speed", "recovery speed", Quantity::velocity, {}, 0,
                 "A penetration is taken back no faster than this.",
                 [](Scene& s) -> double& { return s.contact_solver.recovery_speed; });
    if (scene.contact_solver.scheme == ContactScheme::penalty ||
        scene.contact_solver.scheme == ContactScheme::bipenalty)
        // Inertia with stiff springs adds energy: see bipenalty_contact.hpp.
        list.add("contact_solver.penalty", "penalty", Quantity::dimensionless,
                 {{0.01, scene.contact_solver.scheme == ContactScheme::penalty ? 10.0 : 1.0}}, 0,
                 "Springs of contact as a part of the stiffness of the elements behind it.",
                 [](Scene& s) -> double& { return s.contact_solver.penalty; });
}

void add_law(Collector& list, const std::string& key, std::size_t m, const VoceHardening& law) {
    const auto of = [m](double VoceHardening::*member) {
        return [m, member](Scene& s) -> double& {
            return std::get<VoceHardening>(s.materials[m].plasticity).*member;
        };
    };
    list.add(key + ".plastic.yield", "yield stress", Quantity::stress, {}, 0, "At no plastic strain.",
             of(&VoceHardening::yield));
    list.add(key + ".plastic.linear", "linear hardening", Quantity::stress, {}, 0,
             "Rise of the yield stress for each unit of plastic strain.", of(&VoceHardening::linear));
    if (law.saturation <= 0) return;
    list.add(key + ".plastic.saturation", "saturating hardening", Quantity::stress, {}, 0,
             "What the exponential part adds to the yield stress in the end.",
             of(&VoceHardening::saturation));
    list.add(key + ".plastic.rate", "saturation rate", Quantity::dimensionless, {}, 0,
             "How fast it saturates, for each unit of plastic strain.", of(&VoceHardening::rate));
}

void add_law(Collector& list, const std::string& key, std::size_t m, const TabulatedHardening& law) {
    for (std::size_t i = 0; i < law.points.size(); ++i)
        list.add(fmt::format("{}.plastic.points.{}.1", key, i),
                 fmt::format("yield stress at {:g}", law.points[i].first), Quantity::stress, {}, 0,
                 "At this plastic strain.", [m, i](Scene& s) -> double& {
                     return std::get<TabulatedHardening>(s.materials[m].plasticity).points[i].second;
                 });
}

void add_law(Collector& list, const std::string& key, std::size_t m, const JohnsonCook& law) {
    const auto put = [&](const char* name, const char* title, Quantity quantity, auto member) {
        list.add(key + ".johnson_cook." + name, title, quantity, {}, 0,
                 "Yield stress (A + B ep^n) (1 + C ln(rate/reference)) (1 - T*^m).",
                 [m, member](Scene& s) -> double& {
                     auto& number = std::get<JohnsonCook>(s.materials[m].plasticity).*member;
                     if constexpr (requires { number.value(); })
                         return *number;
                     else
                         return number;
                 });
    };
    put("yield", "yield stress A", Quantity::stress, &JohnsonCook::yield);
    if (law.hardening > 0) {
        put("hardening", "hardening B", Quantity::stress, &JohnsonCook::hardening);
        put("exponent", "exponent n", Quantity::dimensionless, &JohnsonCook::exponent);
    }
    if (law.rate_factor > 0) {
        put("rate_factor", "rate factor C", Quantity::dimensionless, &JohnsonCook::rate_factor);
        put("reference_rate", "reference rate", Quantity::rate, &JohnsonCook::reference_rate);
    }
    if (law.melting_temperature) {
        put("melting_temperature", "melting temperature", Quantity::temperature,
            &JohnsonCook::melting_temperature);
        put("softening_exponent", "softening exponent m", Quantity::dimensionless,
            &JohnsonCook::softening_exponent);
    }
}

void add_law(Collector&, const std::string&, std::size_t, const std::monostate&) {}

void add_materials(Collector& list, const Scene& scene) {
    for (std::size_t m = 0; m < scene.materials.size(); ++m) {
        const Material& material = scene.materials[m];
        list.begin("material " + material.name);
        const std::string key = "material." + material.name;
        list.add(key + ".density", "density", Quantity::density, {}, 0, "",
                 [m](Scene& s) -> double& { return s.materials[m].density; });
        list.add(key + ".young", "Young's modulus", Quantity::stress, {}, 0,
                 "Stresses were gathered with the former value, so that a run cannot go on with another one.",
                 [m](Scene& s) -> double& { return s.materials[m].young; });
        list.add(key + ".poisson", "Poisson's ratio", Quantity::dimensionless, {{0.0, 0.49}}, -1,
                 "As Young's modulus: a run cannot go on with another one.",
                 [m](Scene& s) -> double& { return s.materials[m].poisson; });
        std::visit([&](const auto& law) { add_law(list, key, m, law); }, material.plasticity);
        if (!material.viscosity) continue;
        list.add(key + ".viscosity.linear", "linear viscosity", Quantity::dimensionless, {{0.0, 0.5}}, 0,
                 "Bulk viscosity that damps waves; 0.06 is usual. Lowers the critical step.",
                 [m](Scene& s) -> double& { return s.materials[m].viscosity->linear; });
        list.add(
            key + ".viscosity.quadratic", "quadratic viscosity", Quantity::dimensionless, {{0.0, 4.0}}, 0,
            "Bulk viscosity that spreads shocks over some elements; 1.2 is usual. Lowers the critical step.",
            [m](Scene& s) -> double& { return s.materials[m].viscosity->quadratic; });
    }
}

void add_bodies(Collector& list, const Scene& scene) {
    const auto names = direction_names(scene.geometry);
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
        const Body& body = scene.bodies[b];
        list.begin("body " + body.name);
        const std::string key = "body." + body.name;
        if (body.element == ElementKind::quad_one_point)
            list.add(key + ".hourglass", "hourglass stiffness", Quantity::dimensionless, {{0.0, 0.3}}, 0,
                     "Holds one-point quads against the modes that their strains do not see; 0.1 is usual.",
                     [b](Scene& s) -> double& { return s.bodies[b].hourglass; });
        for (std::size_t d = 0; d < 2; ++d) {
            if (body.velocity != std::array{0.0, 0.0})
                list.add(fmt::format("{}.velocity.{}", key, d), names[d] + " velocity", Quantity::velocity,
                         {}, none, "At the start.",
                         [b, d](Scene& s) -> double& { return s.bodies[b].velocity[d]; });
        }
        for (std::size_t d = 0; d < 2; ++d) {
            if (body.body_force != std::array{0.0, 0.0})
                list.add(fmt::format("{}.body_force.{}", key, d), names[d] + " body force",
                         Quantity::acceleration, {}, none, "Acceleration by gravity or the like.",
                         [b, d](Scene& s) -> double& { return s.bodies[b].body_force[d]; });
        }
    }
}

void add_contacts(Collector& list, const Scene& scene) {
    if (scene.contact_solver.scheme == ContactScheme::projection) return;  // it knows no friction
    std::set<std::string> tables;
    for (std::size_t p = 0; p < scene.contacts.size(); ++p) {
        const std::string& name = scene.contacts[p].table;
        if (!tables.insert(name).second) continue;
        list.begin("contact " + name);
        list.add("contact." + name + ".friction", "friction", Quantity::dimensionless, {{0.0, 1.0}}, 0,
                 "Coulomb's coefficient; from 0 or to 0 the run begins anew.",
                 [p](Scene& s) -> double& { return s.contacts[p].friction; });
    }
}

}  // namespace

std::vector<DesignValue> design_values(const Scene& scene) {
    Collector list(scene);
    add_run(list, scene);
    add_materials(list, scene);
    add_bodies(list, scene);
    add_contacts(list, scene);
    list.add_parameters();
    return list.take();
}

}  // namespace percuss
