#include <algorithm>

#include <fmt/format.h>

#include "run/fields.hpp"
#include "scene/readers.hpp"
#include "scene/scheme_names.hpp"

namespace percuss {
namespace {

const Body* find_body(const Scene& scene, const std::string& name) {
    const auto found = std::find_if(scene.bodies.begin(), scene.bodies.end(),
                                    [&](const Body& body) { return body.name == name; });
    return found == scene.bodies.end() ? nullptr : &*found;
}

void report_body(TableReader& reader, std::string_view key, const Scene& scene, const std::string& name) {
    reader.error(key, fmt::format("unknown body '{}'{}", name, suggest_name(name, names_of(scene.bodies))));
}

bool is_wall(const Scene& scene, const std::string& name) {
    const auto names = names_of(scene.walls);
    return std::find(names.begin(), names.end(), name) != names.end();
}

constexpr std::string_view every_body = "all";

/// bodies = "all".
bool names_all(const toml::node* bodies) { return bodies && bodies->value<std::string_view>() == every_body; }

void refuse_rows_of_self(TableReader& reader, const ContactPair& pair) {
    if (is_self_contact(pair) && reader.find("scheme") && pair.scheme != RowScheme::symmetric)
        reader.error("scheme",
                     fmt::format("a body, '{}', is kept out of itself by the scheme \"symmetric\"; leave "
                                 "'scheme' out, or name the pairs that it is for",
                                 pair.master.body));
}

void refuse_roles(TableReader& reader) {
    for (const char* role : {"master", "slave"})
        if (reader.find(role))
            reader.error(role,
                         fmt::format("'bodies' knows no roles; leave '{}' out, or name 'master' and 'slave' "
                                     "instead of 'bodies'",
                                     role));
}

/// bodies = ["A", "B"], whole outlines without roles; the second may be a wall, or the first again.
void read_bodies_of_pair(TableReader& reader, const Scene& scene, ContactPair& pair) {
    pair.by_bodies = true;
    refuse_roles(reader);
    if (const auto* one = reader.find("bodies"); one->is_string())
        return reader.error(
            "bodies", fmt::format("'bodies' is '{}'; write bodies = [\"A\", \"B\"], or bodies = \"all\"",
                                  one->value_or(std::string())));
    const auto names = reader.texts("bodies");
    if (!names) return;
    if (names->size() != 2)
        return reader.error(
            "bodies",
            fmt::format(
                "a pair has two bodies, these are {}; write bodies = [\"A\", \"B\"], or [\"A\", \"A\"] "
                "for a body that folds on itself",
                names->size()));
    for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
        const std::string& name = (*names)[k];
        (k == 0 ? pair.master : pair.slave) = {name, "", reader.place("bodies")};
        if (find_body(scene, name)) continue;
        if (!is_wall(scene, name))
            report_body(reader, "bodies", scene, name);
        else if (k == 0)
            reader.error(
                "bodies",
                fmt::format("'{}' is a wall; name it second, forces are counted on the first", name));
    }
}

/// bodies = "all": every two bodies, every body and wall, and every body with itself, but for those that
/// other pairs name.
void append_all_pairs(TableReader& reader, Scene& scene, const ContactPair& like) {
    std::vector<ContactPair> pairs;
    const auto append = [&](const std::string& one, const std::string& other) {
        const auto named = [&](const ContactPair& pair) {
            const auto &a = pair.master.body, &b = pair.slave.body;
            return (a == one && b == other) || (a == other && b == one);
        };
        if (std::any_of(scene.contacts.begin(), scene.contacts.end(), named)) return;
        ContactPair pair = like;
        pair.name = fmt::format("{}-{}-{}", like.name, one, other);
        pair.master = {one, "", like.place};
        pair.slave = {other, "", like.place};
        const auto same = [&](const ContactPair& other_pair) { return other_pair.name == pair.name; };
        std::vector<ContactPair> taken_by;
        std::copy_if(scene.contacts.begin(), scene.contacts.end(), std::back_inserter(taken_by), same);
        std::copy_if(pairs.begin(), pairs.end(), std::back_inserter(taken_by), same);
        for (const ContactPair& taken : taken_by)
            reader.error("name", fmt::format("the name '{}', of a pair of \"all\", is taken by line {}; give "
                                             "one of the two another name",
                                             pair.name, taken.place.line));
        pairs.push_back(std::move(pair));
    };
    for (std::size_t a = 0; a < scene.bodies.size(); ++a) {
        for (std::size_t b = a; b < scene.bodies.size(); ++b)
            append(scene.bodies[a].name, scene.bodies[b].name);
        for (const Wall& wall : scene.walls) append(scene.bodies[a].name, wall.name);
    }
    if (const auto self = std::find_if(pairs.begin(), pairs.end(), is_self_contact); self != pairs.end())
        refuse_rows_of_self(reader, *self);
    if (pairs.empty())
        reader.error("bodies",
                     "nothing is left to pair: other tables name every two bodies; leave this one out");
    scene.contacts.insert(scene.contacts.end(), pairs.begin(), pairs.end());
}

/// "body" or "body.edge"; nothing when it is faulty.
std::optional<SurfaceName> read_surface(TableReader& reader, std::string_view key, const Scene& scene) {
    reader.need(key, fmt::format("{} = \"BODY.EDGE\" or \"BODY\"", key));
    const auto text = reader.text(key);
    if (!text) return std::nullopt;
    const auto dot = text->find('.');
    SurfaceName surface{text->substr(0, dot), dot == std::string::npos ? "" : text->substr(dot + 1),
                        reader.place(key)};
    const auto* body = find_body(scene, surface.body);
    if (!body && is_wall(scene, surface.body)) {
        if (key == "slave" && dot == std::string::npos) return surface;
        reader.error(
            key, key == "slave"
                     ? fmt::format("wall '{}' has no edges; write slave = \"{}\"", surface.body, surface.body)
                     : fmt::format("'{}' is a wall; walls can only be slaves, swap the two", surface.body));
        return std::nullopt;
    }
    if (!body) {
        report_body(reader, key, scene, surface.body);
        return std::nullopt;
    }
    if (dot != std::string::npos) check_edge(reader, key, *body, surface.edge);
    return surface;
}

void check_self_contact(TableReader& reader, const ContactPair& pair, bool declared) {
    if (pair.master.body != pair.slave.body) {
        if (declared)
            reader.error("self", "'self' is true, but master and slave are different bodies; leave it out");
        return;
    }
    if (!declared)
        reader.error("slave",
                     fmt::format("body '{}' is paired with itself; name another body, or write self = true",
                                 pair.slave.body));
    else if (pair.master.edge.empty() || pair.master.edge == pair.slave.edge || pair.slave.edge.empty())
        reader.error("slave",
                     "contact of a body with itself needs two different edges; name them as BODY.EDGE");
}

void read_contact_solver(TableReader& root, Scene& scene) {
    scene.contact_solver.recovery_speed = 1 / scene.units.si(Quantity::velocity);  // 1 m/s
    // Bodies without roles have no other scheme to fall back on.
    if (const toml::array* pairs = root.node()["contact"].as_array())
        for (const toml::node& pair : *pairs)
            if (pair.is_table() && pair.as_table()->contains("bodies"))
                scene.contact_solver.scheme = ContactScheme::joint;
    auto reader = root.table("contact_solver");
    if (!reader) return;
    ContactSolver& solver = scene.contact_solver;
    const auto scheme = reader->choice<ContactScheme>("scheme", "contact scheme", contact_scheme_words());
    if (scheme) solver.scheme = *scheme;
    const bool joint = solver.scheme == ContactScheme::joint,
               penalty = solver.scheme == ContactScheme::penalty,
               bipenalty = solver.scheme == ContactScheme::bipenalty,
               massless = solver.scheme == ContactScheme::massless;
    const auto only_for = [&](std::string_view key, bool fits, std::string_view schemes) {
        if (!fits)
            reader->error(key, fmt::format("'{}' belongs to scheme = {}; leave it out or choose that scheme",
                                           key, schemes));
    };
    if (const auto speed = reader->number("recovery_speed", positive)) {
        solver.recovery_speed = *speed;
        only_for("recovery_speed", joint || massless, "\"joint\" or \"massless\"");
    }
    if (const auto kind =
            reader->choice<ForceSolver>("solver", "solver",
                                        {{"active-set", ForceSolver::active_set},
                                         {"gauss-seidel", ForceSolver::gauss_seidel},
                                         {"conjugate-gradient", ForceSolver::conjugate_gradient}})) {
        solver.solver = *kind;
        only_for("solver", joint || bipenalty, "\"joint\" or \"bipenalty\"");
    }
    if (const auto factor = reader->number("penalty", positive)) {
        solver.penalty = *factor;
        only_for("penalty", penalty || bipenalty, "\"penalty\" or \"bipenalty\"");
    }
    if (const auto bound =
            reader->choice<bool>("step", "bound of the step", {{"springs", false}, {"elements", true}})) {
        solver.step_of_elements = *bound;
        only_for("step", penalty, "\"penalty\"");
    }
    reader->finish();
}

/// layer = { viscosity = 0.06, layers = 3 }
std::optional<ContactLayer> read_layer(TableReader& pair) {
    auto reader = pair.table("layer");
    if (!reader) return std::nullopt;
    ContactLayer layer;
    reader->need("viscosity", "viscosity = 0.06");
    layer.viscosity = reader->number("viscosity", positive).value_or(0);
    if (const auto layers = reader->whole("layers", {.low = 1, .high = 100}))
        layer.layers = static_cast<int>(*layers);
    reader->finish();
    return layer;
}

}  // namespace

namespace {

/// All of a [[contact]] but what it is between.
void read_how(TableReader& reader, const Scene& scene, ContactPair& pair) {
    const bool rows = scene.contact_solver.scheme != ContactScheme::projection;
    const auto scheme = reader.choice<RowScheme>("scheme", "contact scheme", row_scheme_words());
    pair.scheme = scheme.value_or(pair.by_bodies ? RowScheme::symmetric : RowScheme::node_to_side);
    if (scheme && pair.scheme != RowScheme::node_to_side && !rows)
        reader.error("scheme",
                     "the scheme \"projection\" knows no other rows; write scheme = \"joint\" in "
                     "[contact_solver], or leave 'scheme' out");
    const auto level = reader.choice<ContactLevel>(
        "level", "contact level",
        {{"position", ContactLevel::position}, {"velocity", ContactLevel::velocity}});
    pair.level = level.value_or(ContactLevel::position);
    if (pair.level != ContactLevel::position && scene.contact_solver.scheme != ContactScheme::joint)
        reader.error("level",
                     "levels of pairs belong to the joint problem; write scheme = \"joint\" in "
                     "[contact_solver], or leave 'level' out");
    pair.sign = reader
                    .choice<ContactSign>("sign", "sign",
                                         {{"restricted", ContactSign::restricted},
                                          {"unrestricted", ContactSign::unrestricted}})
                    .value_or(ContactSign::restricted);
    if (pair.sign == ContactSign::unrestricted && rows)
        reader.error("sign",
                     "only the scheme \"projection\" knows tension; leave 'sign' out, or choose scheme = "
                     "\"projection\" in [contact_solver]");
    pair.friction = reader.number("friction", not_negative).value_or(0);
    if (pair.friction > 0 && !rows)
        reader.error("friction",
                     "the scheme \"projection\" knows no friction; write scheme = \"joint\" in "
                     "[contact_solver], or leave 'friction' out");
    if (pair.friction > 0 && scene.contact_solver.scheme == ContactScheme::massless)
        reader.error(
            "friction",
            "contact nodes without mass have no slip to stop; leave 'friction' out, or choose another scheme "
            "in [contact_solver]");
    pair.layer = read_layer(reader);
}

void read_pair(TableReader& reader, Scene& scene) {
    ContactPair pair;
    pair.place = reader.place();
    pair.name = pair.table = read_unique_name(reader, scene.contacts, "name = \"impact\"");
    const bool all = names_all(reader.find("bodies"));
    std::optional<SurfaceName> master, slave;
    if (all) {
        pair.by_bodies = true;
        refuse_roles(reader);
    } else if (reader.find("bodies")) {
        read_bodies_of_pair(reader, scene, pair);
    } else {
        master = read_surface(reader, "master", scene);
        slave = read_surface(reader, "slave", scene);
    }
    if (pair.by_bodies && scene.contact_solver.scheme == ContactScheme::projection)
        reader.error("bodies",
                     "the scheme \"projection\" needs roles; name 'master' and 'slave', or write scheme = "
                     "\"joint\" in [contact_solver]");
    read_how(reader, scene, pair);
    const bool self = reader.flag("self").value_or(false);
    if (master) pair.master = *master;
    if (slave) pair.slave = *slave;
    if (master && slave) check_self_contact(reader, pair, self);
    if (!all) refuse_rows_of_self(reader, pair);
    reader.finish();
    if (all)
        append_all_pairs(reader, scene, pair);
    else
        scene.contacts.push_back(std::move(pair));
}

}  // namespace

void read_contacts(TableReader& root, Scene& scene) {
    read_contact_solver(root, scene);
    if (const auto* contact = root.find("contact"); contact && contact->is_string())
        return root.error("contact",
                          fmt::format("'contact' is '{}'; write contact = \"all\", or [[contact]] for "
                                      "each pair",
                                      contact->value_or(std::string())));
    auto tables = root.tables("contact");
    // "all" leaves out the pairs that any other table names.
    std::stable_partition(tables.begin(), tables.end(),
                          [](TableReader& reader) { return !names_all(reader.find("bodies")); });
    for (TableReader& reader : tables) read_pair(reader, scene);
}

void read_probes(TableReader& root, Scene& scene) {
    for (auto& reader : root.tables("probe")) {
        Probe probe;
        probe.place = reader.place();
        probe.name = read_unique_name(reader, scene.probes, "name = \"near-face\"");
        reader.need("body", "body = NAME of a [[body]]");
        probe.body = reader.text("body").value_or("");
        if (reader.node().contains("body") && !find_body(scene, probe.body))
            report_body(reader, "body", scene, probe.body);
        reader.need("at", "at = [x, y]");
        if (const auto at = reader.numbers("at", 2)) probe.at = vec2(*at);
        reader.need("record", fmt::format("record = [\"{}\"]", available_fields(scene).front().name));
        probe.record = reader.texts("record").value_or(std::vector<std::string>{});
        for (const auto& quantity : probe.record)
            if (const auto fault = fault_of_field(scene, "quantity", quantity); !fault.empty())
                reader.error("record", fault);
        reader.finish();
        scene.probes.push_back(std::move(probe));
    }
}

}  // namespace percuss
