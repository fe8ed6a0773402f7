#include "record/mesh_record.hpp"

#include <algorithm>
#include <array>

namespace percuss {
namespace {

using hdf5::read_array;
using hdf5::write_array;
using Integers = std::vector<std::int32_t>;

constexpr std::array kind_names{"quad_one_point", "quad_mean_dilatation", "triangle", "triangle_averaged"};

ElementKind kind_of(const std::string& name) {
    const auto found = std::find(kind_names.begin(), kind_names.end(), name);
    if (found == kind_names.end()) throw RecordError("unknown element kind '" + name + "'");
    return static_cast<ElementKind>(found - kind_names.begin());
}

/// All chains of all bodies in one list: name, body, whether it is an outline, whether closed, its nodes.
struct FlatEdges {
    std::vector<std::string> names;
    Integers body, outline, closed, begin{0}, nodes;

    void add(const Edge& edge, std::size_t body_index, bool is_outline) {
        names.push_back(edge.name);
        body.push_back(static_cast<std::int32_t>(body_index));
        outline.push_back(is_outline ? 1 : 0);
        closed.push_back(edge.closed ? 1 : 0);
        nodes.insert(nodes.end(), edge.nodes.begin(), edge.nodes.end());
        begin.push_back(static_cast<std::int32_t>(nodes.size()));
    }
};

void write_integers(hid_t group, const char* name, const Integers& values) {
    write_array(group, name, std::span(values), {values.size()});
}

void require(bool condition, const char* what) {
    if (!condition) throw RecordError(std::string("the mesh is damaged: ") + what);
}

}  // namespace

void write_mesh(hid_t group, const Mesh& mesh, const std::string& length_label) {
    std::vector<double> nodes;
    for (const Vec2& node : mesh.nodes) nodes.insert(nodes.end(), {node.x(), node.y()});
    write_array(group, "nodes", std::span<const double>(nodes), {mesh.nodes.size(), 2});
    const hdf5::Handle dataset(H5Dopen2(group, "nodes", H5P_DEFAULT), "nodes");
    hdf5::write_attribute(dataset.id(), "unit", length_label);
    Integers cells;
    for (const Cell& cell : mesh.cells) cells.insert(cells.end(), cell.begin(), cell.end());
    write_array(group, "cells", std::span<const std::int32_t>(cells), {mesh.cells.size(), 4});

    std::vector<std::string> names, kinds;
    Integers ranges;
    FlatEdges edges;
    for (std::size_t b = 0; b < mesh.bodies.size(); ++b) {
        const MeshBody& body = mesh.bodies[b];
        names.push_back(body.name);
        kinds.emplace_back(kind_names[static_cast<std::size_t>(body.kind)]);
        ranges.insert(ranges.end(), {body.node_begin, body.node_end, body.cell_begin, body.cell_end});
        for (const Edge& edge : body.edges) edges.add(edge, b, false);
        for (const Edge& edge : body.outlines) edges.add(edge, b, true);
    }
    const hdf5::Handle bodies = hdf5::create_group(group, "bodies");
    hdf5::write_texts(bodies.id(), "name", names);
    hdf5::write_texts(bodies.id(), "element", kinds);
    write_array(bodies.id(), "range", std::span<const std::int32_t>(ranges), {names.size(), 4});

    const hdf5::Handle chains = hdf5::create_group(group, "edges");
    hdf5::write_texts(chains.id(), "name", edges.names);
    write_integers(chains.id(), "body", edges.body);
    write_integers(chains.id(), "outline", edges.outline);
    write_integers(chains.id(), "closed", edges.closed);
    write_integers(chains.id(), "begin", edges.begin);
    write_integers(chains.id(), "node", edges.nodes);
}

Mesh read_mesh(hid_t group) {
    Mesh mesh;
    const std::vector<double> nodes = read_array<double>(group, "nodes");
    for (std::size_t i = 0; i + 1 < nodes.size(); i += 2) mesh.nodes.emplace_back(nodes[i], nodes[i + 1]);
    const Integers cells = read_array<std::int32_t>(group, "cells");
    const auto is_node = [&](std::int32_t n) { return n >= 0 && n < mesh.node_count(); };
    for (std::size_t i = 0; i + 3 < cells.size(); i += 4) {
        const Cell cell{cells[i], cells[i + 1], cells[i + 2], cells[i + 3]};
        require(std::all_of(cell.begin(), cell.begin() + corner_count(cell), is_node), "a cell's node");
        mesh.cells.push_back(cell);
    }

    const hdf5::Handle bodies(H5Gopen2(group, "bodies", H5P_DEFAULT), "/mesh/bodies");
    const auto names = hdf5::read_texts(bodies.id(), "name"),
               kinds = hdf5::read_texts(bodies.id(), "element");
    const Integers ranges = read_array<std::int32_t>(bodies.id(), "range");
    require(kinds.size() == names.size() && ranges.size() == 4 * names.size(), "the list of bodies");
    for (std::size_t b = 0; b < names.size(); ++b) {
        const std::int32_t* range = ranges.data() + 4 * b;
        require(0 <= range[0] && range[0] <= range[1] && range[1] <= mesh.node_count(), "a body's nodes");
        require(0 <= range[2] && range[2] <= range[3] && range[3] <= mesh.cell_count(), "a body's cells");
        mesh.bodies.push_back({names[b], kind_of(kinds[b]), range[0], range[1], range[2], range[3], {}, {}});
    }

    const hdf5::Handle chains(H5Gopen2(group, "edges", H5P_DEFAULT), "/mesh/edges");
    const auto edge_names = hdf5::read_texts(chains.id(), "name");
    const auto read = [&](const char* name) { return read_array<std::int32_t>(chains.id(), name); };
    const Integers body = read("body"), outline = read("outline"), closed = read("closed"),
                   begin = read("begin"), node = read("node");
    const std::size_t count = edge_names.size();
    require(body.size() == count && outline.size() == count && closed.size() == count &&
                begin.size() == count + 1 && static_cast<std::size_t>(begin.back()) == node.size() &&
                std::is_sorted(begin.begin(), begin.end()) && begin.front() == 0,
            "the list of edges");
    require(std::all_of(node.begin(), node.end(), is_node), "an edge's node");
    for (std::size_t e = 0; e < count; ++e) {
        require(body[e] >= 0 && static_cast<std::size_t>(body[e]) < mesh.bodies.size(), "an edge's body");
        MeshBody& owner = mesh.bodies[static_cast<std::size_t>(body[e])];
        Edge edge{edge_names[e], {node.begin() + begin[e], node.begin() + begin[e + 1]}, closed[e] != 0};
        (outline[e] != 0 ? owner.outlines : owner.edges).push_back(std::move(edge));
    }
    return mesh;
}

}  // namespace percuss
