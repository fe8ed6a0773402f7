#include <algorithm>

#include <fmt/format.h>

#include "run/fields.hpp"
#include "scene/readers.hpp"

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

/// bodies = ["A", "B"], whole outlines without roles; the second may be a wall.
void read_bodies_of_pair(TableReader& reader, const Scene& scene, ContactPair& pair) {
    pair.by_bodies = true;
    for (const char* role : {"master", "slave"})
        if (reader.find(role))
            reader.error(role,
                         fmt::format("'bodies' knows no roles; leave '{}' out, or name 'master' and 'slave' "
                                     "instead of 'bodies'",
                                     role));
    const auto names = reader.texts("bodies");
    if (!names) return;
    if (names->size() != 2)
        return reader.error(
            "bodies",
            fmt::format("a pair has two bodies, these are {}; write bodies = [\"A\", \"B\"]", names->size()));
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
    if ((*names)[0] == (*names)[1])
        reader.error("bodies",
                     fmt::format("body '{}' is paired with itself; name another body, or two of its edges as "
                                 "master and slave with self = true",
                                 (*names)[0]));
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
    auto reader = root.table("contact_solver");
    if (!reader) return;
    ContactSolver& solver = scene.contact_solver;
    solver.scheme = reader
                        ->choice<ContactScheme>(
                            "scheme", "contact scheme",
                            {{"projection", ContactScheme::projection}, {"joint", ContactScheme::joint}})
                        .value_or(ContactScheme::projection);
    if (const auto speed = reader->number("recovery_speed", positive)) {
        solver.recovery_speed = *speed;
        if (solver.scheme != ContactScheme::joint)
            reader->error(
                "recovery_speed",
                "'recovery_speed' belongs to scheme = \"joint\"; leave it out or choose that scheme");
    }
    reader->finish();
}

}  // namespace

void read_contacts(TableReader& root, Scene& scene) {
    read_contact_solver(root, scene);
    for (auto& reader : root.tables("contact")) {
        ContactPair pair;
        pair.place = reader.place();
        pair.name = read_unique_name(reader, scene.contacts, "name = \"impact\"");
        const bool joint = scene.contact_solver.scheme == ContactScheme::joint;
        std::optional<SurfaceName> master, slave;
        if (reader.find("bodies")) {
            read_bodies_of_pair(reader, scene, pair);
            if (!joint)
                reader.error(
                    "bodies",
                    "the scheme \"projection\" needs roles; name 'master' and 'slave', or write scheme = "
                    "\"joint\" in [contact_solver]");
        } else {
            master = read_surface(reader, "master", scene);
            slave = read_surface(reader, "slave", scene);
        }
        const auto scheme = reader.choice<RowScheme>("scheme", "contact scheme",
                                                     {{"node-to-side", RowScheme::node_to_side},
                                                      {"symmetric", RowScheme::symmetric},
                                                      {"segment-to-segment", RowScheme::segment_to_segment}});
        pair.scheme = scheme.value_or(pair.by_bodies ? RowScheme::symmetric : RowScheme::node_to_side);
        if (scheme && !joint)
            reader.error("scheme",
                         "schemes of pairs belong to the joint problem; write scheme = \"joint\" in "
                         "[contact_solver], or leave 'scheme' out");
        pair.sign = reader
                        .choice<ContactSign>("sign", "sign",
                                             {{"restricted", ContactSign::restricted},
                                              {"unrestricted", ContactSign::unrestricted}})
                        .value_or(ContactSign::restricted);
        if (pair.sign == ContactSign::unrestricted && joint)
            reader.error("sign",
                         "the joint scheme knows no tension; leave 'sign' out, or choose scheme = "
                         "\"projection\" in [contact_solver]");
        pair.friction = reader.number("friction", not_negative).value_or(0);
        if (pair.friction > 0 && !joint)
            reader.error("friction",
                         "the scheme \"projection\" knows no friction; write scheme = \"joint\" in "
                         "[contact_solver], or leave 'friction' out");
        const bool self = reader.flag("self").value_or(false);
        if (master) pair.master = *master;
        if (slave) pair.slave = *slave;
        if (master && slave) check_self_contact(reader, pair, self);
        reader.finish();
        scene.contacts.push_back(std::move(pair));
    }
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
