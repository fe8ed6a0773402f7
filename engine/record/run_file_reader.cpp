#include <algorithm>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "record/hdf5.hpp"
#include "record/layout.hpp"
#include "record/mesh_record.hpp"
#include "record/trace_record.hpp"
#include "run/fields.hpp"
#include "scene/parse.hpp"

namespace percuss {
namespace {

using hdf5::Handle;
using hdf5::Rows;

Handle open_file(const std::filesystem::path& file) {
    hdf5::silence_errors();
    if (!std::filesystem::exists(file)) throw RecordError("no such file");
    // Its writer is about to lock it, and must find it free.
    std::error_code not_a_file;
    if (std::filesystem::file_size(file, not_a_file) == 0) throw RecordError("the file is empty");
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), "file access");
    hdf5::check(H5Pset_file_locking(access.id(), true, true), "file locking");
    const hid_t plain = H5Fopen(file.c_str(), H5F_ACC_RDONLY, access.id());
    if (plain >= 0) return {plain, "open"};
    // A run that still goes on, or was killed, left its mark "being written"; its data are consistent all the
    // same. Metadata amid a write are read again after a pause that doubles each time: here up to half a
    // second in all, where by default a damaged file would hang its reader for hours.
    hdf5::check(H5Pset_metadata_read_attempts(access.id(), 28), "read attempts");
    return {H5Fopen(file.c_str(), H5F_ACC_RDONLY | H5F_ACC_SWMR_READ, access.id()), "cannot be opened"};
}

std::shared_ptr<const RunSetup> read_setup(hid_t file) {
    const Handle scene(H5Gopen2(file, "scene", H5P_DEFAULT), "/scene");
    const std::string text = hdf5::read_text(scene.id(), "text");
    const std::string name = hdf5::read_text_attribute(scene.id(), "file");
    const Handle mesh(H5Gopen2(file, "mesh", H5P_DEFAULT), "/mesh");
    auto setup = std::make_shared<RunSetup>();
    try {
        setup->scene = parse_scene(text, name, hdf5::read_texts(scene.id(), "overrides"));
    } catch (const SceneError& error) {
        throw RecordError(fmt::format("this version cannot read the run's scene: {}", error.what()));
    }
    setup->mesh = read_mesh(mesh.id());
    const std::vector<Body>& bodies = setup->scene.bodies;
    if (!std::equal(bodies.begin(), bodies.end(), setup->mesh.bodies.begin(), setup->mesh.bodies.end(),
                    [](const Body& body, const MeshBody& meshed) { return body.name == meshed.name; })) {
        throw RecordError("the mesh does not belong to the scene");
    }
    return setup;
}

std::array<double, 2> pair_at(const std::vector<double>& values, std::size_t index) {
    return {values[2 * index], values[2 * index + 1]};
}

}  // namespace

struct RunFile::Impl {
    std::filesystem::path path;
    Handle file, frames;
    std::shared_ptr<const RunSetup> setup;
    std::int64_t frame_count = 0;

    template <class Call>
    auto named(Call call) const {  // errors name the file
        try {
            return call();
        } catch (const RecordError& error) {
            throw RecordError(fmt::format("{}: {}", path.string(), error.what()));
        }
    }

    template <class T>
    std::vector<T> row(const char* name, std::int64_t index, std::size_t expected_size) const {
        const Rows rows(frames.id(), name);
        if (rows.row_size() != expected_size) {
            throw RecordError(fmt::format("/frames/{} has rows of {} numbers, not {}", name, rows.row_size(),
                                          expected_size));
        }
        return rows.read<T>(static_cast<hsize_t>(index), 1);
    }

    void read_contacts(std::int64_t index, Snapshot& snapshot) const {
        const auto range = row<std::int64_t>("contact_begin", index, 2);
        if (range[0] < 0 || range[1] < range[0]) throw RecordError("the list of contact forces is damaged");
        const auto begin = static_cast<hsize_t>(range[0]), count = static_cast<hsize_t>(range[1] - range[0]);
        const auto read = [&](const char* name) {
            return Rows(frames.id(), name).read<std::int32_t>(begin, count);
        };
        const auto node = read("contact_node"), pair = read("contact_pair"), master = read("contact_master");
        const auto force = Rows(frames.id(), "contact_force").read<double>(begin, count);
        for (std::size_t i = 0; i < count; ++i) {
            if (node[i] < 0 || node[i] >= setup->mesh.node_count())
                throw RecordError("a contact's node is damaged");
            snapshot.contact_forces.push_back({node[i], pair[i], master[i] != 0, pair_at(force, i)});
        }
    }

    void read_states(std::int64_t index, Snapshot& snapshot) const {
        const std::size_t pairs = setup->scene.contacts.size(), bodies = setup->scene.bodies.size();
        if (pairs > 0) {
            const auto force = row<double>("pair_force", index, 2 * pairs);
            const auto active = row<std::int32_t>("pair_active", index, pairs);
            const auto penetration = row<double>("pair_penetration", index, pairs);
            for (std::size_t p = 0; p < pairs; ++p) {
                snapshot.pairs.push_back({pair_at(force, p), active[p], penetration[p], {}, 0});
            }
        }
        const auto velocity = row<double>("body_velocity", index, 2 * bodies);
        for (std::size_t b = 0; b < bodies; ++b) snapshot.bodies.push_back({pair_at(velocity, b)});
        if (hdf5::has_object(frames.id(), "body_energies")) {  // not in files of earlier versions
            const auto of_bodies =
                row<double>("body_energies", index, layout::body_energy_columns.size() * bodies);
            for (auto e = of_bodies.begin(); e != of_bodies.end(); e += layout::body_energy_columns.size())
                snapshot.body_energies.push_back({e[0], e[1], e[2], e[3], e[4]});
        }
        const auto e = row<double>("energies", index, layout::energy_columns.size());
        snapshot.energy = {e[0], e[1], e[2], e[3], e[4], e[5], e[6], 0};
        if (has_friction(setup->scene))
            snapshot.energy.friction = row<double>("friction_energy", index, 1).front();
    }

    std::shared_ptr<const Snapshot> read_frame(std::int64_t index) const {
        if (index < 0 || index >= frame_count) {
            throw RecordError(
                fmt::format("no frame {}; the run has {} (0 to {})", index, frame_count, frame_count - 1));
        }
        const auto nodes = setup->mesh.nodes.size(), cells = setup->mesh.cells.size();
        auto snapshot = std::make_shared<Snapshot>();
        snapshot->setup = setup;
        snapshot->time = row<double>("time", index, 1).front();
        snapshot->step = row<std::int64_t>("step", index, 1).front();
        snapshot->dt = row<double>("dt", index, 1).front();
        snapshot->critical_step = row<double>("critical_step", index, 1).front();
        snapshot->position = row<double>("position", index, 2 * nodes);
        snapshot->velocity = row<double>("velocity", index, 2 * nodes);
        const auto stress = row<double>("stress", index, 4 * cells);
        snapshot->stress.resize(cells);
        for (std::size_t i = 0; i < stress.size(); ++i) snapshot->stress[i / 4][i % 4] = stress[i];
        if (has_plasticity(setup->scene)) {
            snapshot->plastic_strain = row<double>("plastic_strain", index, cells);
            snapshot->yield_stress = row<double>("yield_stress", index, cells);
        }
        if (ambient_temperature(setup->scene))
            snapshot->temperature = row<double>("temperature", index, cells);
        read_contacts(index, *snapshot);
        read_states(index, *snapshot);
        const std::int32_t status = row<std::int32_t>("status", index, 1).front();
        snapshot->status =
            static_cast<RunStatus>(std::clamp(status, 0, static_cast<int>(RunStatus::diverged)));
        if (snapshot->status == RunStatus::diverged) {
            const auto summary = nlohmann::json::parse(read_summary(), nullptr, false);
            if (summary.is_object()) {
                snapshot->message = summary.value("message", "");
                const std::int64_t failed = summary.value("failed_element", std::int64_t{-1});
                if (failed >= 0 && failed < setup->mesh.cell_count())
                    snapshot->failed_cell = static_cast<std::int32_t>(failed);
            }
        }
        return snapshot;
    }

    std::shared_ptr<const History> read_history() const {
        const Handle group(H5Gopen2(file.id(), "history", H5P_DEFAULT), "/history");
        const auto names = hdf5::read_texts(group.id(), "column");
        const auto quantities = hdf5::read_texts(group.id(), "quantity");
        const Rows rows(group.id(), "rows");
        if (names.empty() || quantities.size() != names.size() || rows.row_size() != names.size()) {
            throw RecordError("the history's columns are damaged");
        }
        std::vector<HistoryColumn> columns;
        for (std::size_t c = 0; c < names.size(); ++c) {
            columns.push_back({names[c], layout::quantity_of(quantities[c])});
        }
        const auto count = static_cast<hsize_t>(hdf5::Counter::read(group.id(), "count"));
        auto history = std::make_shared<History>(std::move(columns));
        constexpr hsize_t piece = 16384;
        for (hsize_t begin = 0; begin < count; begin += piece) {
            const std::vector<double> table = rows.read<double>(begin, std::min(piece, count - begin));
            for (std::size_t i = 0; i < table.size(); i += names.size()) {
                history->append(std::span(table).subspan(i, names.size()));
            }
        }
        return history;
    }

    std::string read_summary() const {
        const Rows bytes(file.id(), "summary");
        const auto text = bytes.read<std::uint8_t>(0, bytes.rows());
        std::string summary(text.begin(), text.end());
        return nlohmann::json::accept(summary) ? summary : "";
    }
};

RunFile::RunFile(const std::filesystem::path& file) : impl_(std::make_unique<Impl>()) {
    impl_->path = file;
    impl_->named([&] {
        impl_->file = open_file(file);
        const hid_t root = impl_->file.id();
        if (H5Aexists(root, "format") <= 0 || hdf5::read_text_attribute(root, "format") != "percuss run") {
            throw RecordError("not a run of percuss");
        }
        const std::int64_t version = hdf5::read_integer_attribute(root, "format_version");
        if (version != layout::format_version) {
            throw RecordError(fmt::format("written in format {}, this version reads format {}", version,
                                          layout::format_version));
        }
        impl_->setup = read_setup(root);
        impl_->frames = Handle(H5Gopen2(root, "frames", H5P_DEFAULT), "/frames");
        impl_->frame_count = hdf5::Counter::read(impl_->frames.id(), "count");
    });
}

RunFile::~RunFile() = default;

std::shared_ptr<const RunSetup> RunFile::setup() const { return impl_->setup; }

std::int64_t RunFile::frames() const { return impl_->frame_count; }

std::vector<double> RunFile::frame_times() const {
    return impl_->named([&] {
        return Rows(impl_->frames.id(), "time").read<double>(0, static_cast<hsize_t>(impl_->frame_count));
    });
}

std::shared_ptr<const Snapshot> RunFile::frame(std::int64_t index) const {
    return impl_->named([&] { return impl_->read_frame(index); });
}

std::shared_ptr<const History> RunFile::history() const {
    return impl_->named([&] { return impl_->read_history(); });
}

std::vector<Trace> RunFile::traces() const {
    return impl_->named([&] { return read_traces(impl_->file.id()); });
}

std::string RunFile::summary() const {
    return impl_->named([&] { return impl_->read_summary(); });
}

}  // namespace percuss
