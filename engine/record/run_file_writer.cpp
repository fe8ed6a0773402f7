#include <algorithm>
#include <bit>
#include <system_error>

#include <fmt/format.h>

#include "record/hdf5.hpp"
#include "record/layout.hpp"
#include "record/machine.hpp"
#include "record/mesh_record.hpp"
#include "record/trace_record.hpp"
#include "run/fields.hpp"

namespace percuss {
namespace {

using hdf5::Counter;
using hdf5::Handle;
using hdf5::Rows;

constexpr const char* sign_conventions =
    "Tension positive in stresses, compression positive in pressure. Velocities stand at time - dt/2. Forces "
    "of a "
    "frame or history row are impulses of one step divided by the step, centred on its time. Contact forces "
    "act on "
    "the node named; resultants act on the master body. Axisymmetric: components (radial, axial), stresses "
    "(rr, zz, "
    "hoop, rz), forces, masses and energies of the full ring; plane: (x, y), (xx, yy, zz, xy), of the "
    "thickness.";

// Created for writers that other processes may read at any moment (SWMR): HDF5 then orders its metadata so
// that the file is consistent whenever the writer dies. That needs the file format of HDF5 1.10.
Handle create_file(const std::filesystem::path& file) {
    hdf5::silence_errors();
    std::error_code ignored;
    if (std::filesystem::exists(file, ignored)) {
        throw RecordError(fmt::format("{}: the file exists already", file.string()));
    }
    const Handle access(H5Pcreate(H5P_FILE_ACCESS), "file access");
    hdf5::check(H5Pset_libver_bounds(access.id(), H5F_LIBVER_V110, H5F_LIBVER_V110), "file format");
    hdf5::check(H5Pset_file_locking(access.id(), true, true), "file locking");
    // Metadata kept within pages of the system: a kill takes effect between pages, so that it cannot tear the
    // header of a dataset, without which all its frames would be lost.
    const Handle creation(H5Pcreate(H5P_FILE_CREATE), "file creation");
    hdf5::check(H5Pset_file_space_strategy(creation.id(), H5F_FSPACE_STRATEGY_PAGE, false, 1), "file space");
    hdf5::check(H5Pset_file_space_page_size(creation.id(), 4096), "page size");
    return {H5Fcreate(file.c_str(), H5F_ACC_EXCL, creation.id(), access.id()),
            fmt::format("{}: cannot be made", file.string())};
}

void write_origin(hid_t file, const Scene& scene) {
    hdf5::write_attribute(file, "format", "percuss run");
    hdf5::write_attribute(file, "format_version", std::int64_t{layout::format_version});
    hdf5::write_attribute(file, "percuss_version", PERCUSS_VERSION);
    hdf5::write_attribute(file, "sign_conventions", sign_conventions);
    const Machine machine = this_machine();
    hdf5::write_attribute(file, "machine_cpu", machine.cpu);
    hdf5::write_attribute(file, "machine_cores", std::int64_t{machine.cores});
    hdf5::write_attribute(file, "compiler", machine.compiler);
    hdf5::write_attribute(file, "build", machine.build);
    hdf5::write_attribute(file, "unit_length", scene.units.length_name());
    hdf5::write_attribute(file, "unit_time", scene.units.time_name());
    hdf5::write_attribute(file, "unit_mass", scene.units.mass_name());

    const Handle group = hdf5::create_group(file, "scene");
    hdf5::write_attribute(group.id(), "file", scene.file);
    hdf5::write_attribute(group.id(), "title", scene.title);
    hdf5::write_text(group.id(), "text", scene.text);
    hdf5::write_texts(group.id(), "overrides", scene.overrides);
}

}  // namespace

struct RunFileWriter::Impl {
    std::filesystem::path path;
    std::shared_ptr<const RunSetup> setup;
    FieldInfo von_mises_field, pressure_field;
    std::size_t next_history_row = 0;
    std::size_t every = 1;

    Handle file, frames, history;  // before what they hold: closed last
    Rows time, step, dt, critical_step, status;
    Rows position, velocity, stress, von_mises, pressure;
    Rows plastic_strain, yield_stress, temperature, friction_energy;
    Rows contact_begin, contact_node, contact_pair, contact_master, contact_force;
    Rows pair_force, pair_active, pair_penetration, body_velocity, body_energies, energies;
    Handle trace_group;
    std::vector<TraceWriter> traces;
    Rows history_rows, summary;
    Counter frame_count, history_count;
    std::int64_t frames_written = 0;
    std::int64_t contacts_written = 0;

    Rows number_rows(const Handle& group, const char* name, Quantity quantity, std::vector<hsize_t> shape,
                     hsize_t chunk) const {
        Rows rows(group.id(), name, H5T_NATIVE_DOUBLE, std::move(shape), chunk);
        hdf5::write_attribute(rows.id(), "unit", setup->scene.units.label(quantity));
        return rows;
    }
    static Rows integer_rows(const Handle& group, const char* name, std::vector<hsize_t> shape,
                             hsize_t chunk) {
        return {group.id(), name, H5T_NATIVE_INT32, std::move(shape), chunk};
    }

    void create_frames() {
        frames = hdf5::create_group(file.id(), "frames");
        const auto nodes = static_cast<hsize_t>(setup->mesh.node_count());
        const auto cells = static_cast<hsize_t>(setup->mesh.cell_count());
        const hsize_t pairs = setup->scene.contacts.size(), bodies = setup->scene.bodies.size();
        constexpr hsize_t few = 256, many = 4096;
        time = number_rows(frames, "time", Quantity::time, {}, few);
        dt = number_rows(frames, "dt", Quantity::time, {}, few);
        critical_step = number_rows(frames, "critical_step", Quantity::time, {}, few);
        step = Rows(frames.id(), "step", H5T_NATIVE_INT64, {}, few);
        status = integer_rows(frames, "status", {}, few);
        position = number_rows(frames, "position", Quantity::length, {nodes, 2}, 1);
        velocity = number_rows(frames, "velocity", Quantity::velocity, {nodes, 2}, 1);
        stress = number_rows(frames, "stress", Quantity::stress, {cells, 4}, 1);
        von_mises = number_rows(frames, "von_mises", Quantity::stress, {cells}, 1);
        pressure = number_rows(frames, "pressure", Quantity::stress, {cells}, 1);
        if (has_plasticity(setup->scene)) {
            plastic_strain = number_rows(frames, "plastic_strain", Quantity::dimensionless, {cells}, 1);
            yield_stress = number_rows(frames, "yield_stress", Quantity::stress, {cells}, 1);
        }
        if (ambient_temperature(setup->scene))
            temperature = number_rows(frames, "temperature", Quantity::temperature, {cells}, 1);
        if (has_friction(setup->scene))
            friction_energy = number_rows(frames, "friction_energy", Quantity::energy, {}, few);
        contact_begin = Rows(frames.id(), "contact_begin", H5T_NATIVE_INT64, {2}, few);
        contact_node = integer_rows(frames, "contact_node", {}, many);
        contact_pair = integer_rows(frames, "contact_pair", {}, many);
        contact_master = integer_rows(frames, "contact_master", {}, many);
        contact_force = number_rows(frames, "contact_force", Quantity::force, {2}, many);
        if (pairs > 0) {
            pair_force = number_rows(frames, "pair_force", Quantity::force, {pairs, 2}, few);
            pair_active = integer_rows(frames, "pair_active", {pairs}, few);
            pair_penetration = number_rows(frames, "pair_penetration", Quantity::length, {pairs}, few);
        }
        body_velocity = number_rows(frames, "body_velocity", Quantity::velocity, {bodies, 2}, few);
        body_energies = number_rows(frames, "body_energies", Quantity::energy,
                                    {bodies, layout::body_energy_columns.size()}, few);
        hdf5::write_attribute(body_energies.id(), "columns",
                              fmt::format("{}", fmt::join(layout::body_energy_columns, ",")));
        energies = number_rows(frames, "energies", Quantity::energy, {layout::energy_columns.size()}, few);
        hdf5::write_attribute(energies.id(), "columns",
                              fmt::format("{}", fmt::join(layout::energy_columns, ",")));
        frame_count = Counter(frames.id(), "count");
    }

    void create_history(const std::vector<HistoryColumn>& columns) {
        history = hdf5::create_group(file.id(), "history");
        std::vector<std::string> names, quantities, units;
        for (const HistoryColumn& column : columns) {
            names.push_back(column.name);
            quantities.emplace_back(layout::quantity_name(column.quantity));
            units.push_back(setup->scene.units.label(column.quantity));
        }
        hdf5::write_texts(history.id(), "column", names);
        hdf5::write_texts(history.id(), "quantity", quantities);
        hdf5::write_texts(history.id(), "unit", units);
        hdf5::write_attribute(history.id(), "every", static_cast<std::int64_t>(every));
        history_rows = Rows(history.id(), "rows", H5T_NATIVE_DOUBLE, {columns.size()}, 1024);
        history_count = Counter(history.id(), "count");
    }

    void create_traces(const std::vector<Trace>& recorded) {
        if (recorded.empty()) return;
        trace_group = hdf5::create_group(file.id(), "traces");
        std::vector<std::string> names;
        for (const Trace& trace : recorded) {
            names.push_back(trace.name);
            traces.emplace_back(trace_group.id(), trace, setup->scene.units);
        }
        hdf5::write_texts(trace_group.id(), "name", names);
    }

    void append_traces() {
        for (TraceWriter& trace : traces) trace.append();
        if (!traces.empty()) flush();
        for (TraceWriter& trace : traces) trace.count();
    }

    void flush() const { hdf5::check(H5Fflush(file.id(), H5F_SCOPE_LOCAL), path.string()); }

    template <class Call>
    void named(Call call) const {  // errors name the file
        try {
            call();
        } catch (const RecordError& error) {
            const std::string what = error.what();
            throw RecordError(what.starts_with(path.string()) ? what
                                                              : fmt::format("{}: {}", path.string(), what));
        }
    }

    void append_contacts(const Snapshot& snapshot) {
        std::vector<std::int32_t> node, pair, master;
        std::vector<double> force;
        for (const ContactForce& contact : snapshot.contact_forces) {
            node.push_back(contact.node);
            pair.push_back(contact.pair);
            master.push_back(contact.master ? 1 : 0);
            force.insert(force.end(), contact.force.begin(), contact.force.end());
        }
        contact_node.append(std::span<const std::int32_t>(node));
        contact_pair.append(std::span<const std::int32_t>(pair));
        contact_master.append(std::span<const std::int32_t>(master));
        contact_force.append(std::span<const double>(force));
        const auto count = static_cast<std::int64_t>(node.size());
        const std::array<std::int64_t, 2> range{contacts_written, contacts_written + count};
        contact_begin.append(std::span<const std::int64_t>(range));
        contacts_written += count;
    }

    void append_states(const Snapshot& snapshot) {
        std::vector<double> force, penetration, body;
        std::vector<std::int32_t> active;
        for (const PairState& pair : snapshot.pairs) {
            force.insert(force.end(), pair.force.begin(), pair.force.end());
            active.push_back(pair.active);
            penetration.push_back(pair.penetration);
        }
        if (pair_force) {
            pair_force.append(std::span<const double>(force));
            pair_active.append(std::span<const std::int32_t>(active));
            pair_penetration.append(std::span<const double>(penetration));
        }
        for (const BodyState& state : snapshot.bodies) {
            body.insert(body.end(), state.velocity.begin(), state.velocity.end());
        }
        body_velocity.append(std::span<const double>(body));
        std::vector<double> of_bodies;
        for (const BodyEnergies& e : snapshot.body_energies)
            of_bodies.insert(of_bodies.end(), {e.kinetic, e.elastic, e.plastic, e.hourglass, e.viscous});
        of_bodies.resize(layout::body_energy_columns.size() * snapshot.bodies.size());
        body_energies.append(std::span<const double>(of_bodies));
        const Energies& e = snapshot.energy;
        const std::array<double, layout::energy_columns.size()> energy{
            e.kinetic, e.internal, e.hourglass, e.viscous, e.contact, e.external, e.plastic};
        energies.append(std::span<const double>(energy));
    }

    void append_frame(const Snapshot& snapshot) {
        const auto one = [](Rows& rows, auto value) {
            rows.append(std::span<const decltype(value)>(&value, 1));
        };
        one(time, snapshot.time);
        one(dt, snapshot.dt);
        one(critical_step, snapshot.critical_step);
        one(step, snapshot.step);
        one(status, static_cast<std::int32_t>(snapshot.status));
        position.append(std::span<const double>(snapshot.position));
        velocity.append(std::span<const double>(snapshot.velocity));
        stress.append(std::span<const double>(snapshot.stress.front().data(), 4 * snapshot.stress.size()));
        von_mises.append(std::span<const double>(field_values(snapshot, von_mises_field)));
        pressure.append(std::span<const double>(field_values(snapshot, pressure_field)));
        if (plastic_strain) {
            plastic_strain.append(std::span<const double>(snapshot.plastic_strain));
            yield_stress.append(std::span<const double>(snapshot.yield_stress));
        }
        if (friction_energy) one(friction_energy, snapshot.energy.friction);
        if (temperature) temperature.append(std::span<const double>(snapshot.temperature));
        append_contacts(snapshot);
        append_states(snapshot);
        flush();                            // the frame first,
        frame_count.set(++frames_written);  // then the number that says it is there
    }

    void append_history(const History& source) {
        const std::size_t end = source.rows(), width = source.columns().size();
        if (width != history_rows.row_size()) throw RecordError("a history with other columns");
        if (next_history_row >= end) return;
        std::vector<double> table = source.table(next_history_row, end);
        if (every > 1) {
            std::vector<double> kept;
            for (std::size_t i = 0; i < table.size(); i += every * width) {
                kept.insert(kept.end(), table.begin() + static_cast<std::ptrdiff_t>(i),
                            table.begin() + static_cast<std::ptrdiff_t>(i + width));
            }
            table = std::move(kept);
        }
        history_rows.append(std::span<const double>(table));
        next_history_row += (table.size() / width) * every;
        flush();
        history_count.set(static_cast<std::int64_t>(next_history_row / every));
    }
};

RunFileWriter::RunFileWriter(const std::filesystem::path& file, std::shared_ptr<const RunSetup> setup,
                             const std::vector<HistoryColumn>& columns, const std::vector<Trace>& traces)
    : impl_(std::make_unique<Impl>()) {
    impl_->path = file;
    impl_->setup = std::move(setup);
    const Scene& scene = impl_->setup->scene;
    impl_->every = static_cast<std::size_t>(std::max(scene.record.history_every, 1));
    impl_->von_mises_field = find_field(scene, "von_mises");
    impl_->pressure_field = find_field(scene, "pressure");
    impl_->file = create_file(file);
    impl_->named([&] {
        write_origin(impl_->file.id(), scene);
        const Handle mesh = hdf5::create_group(impl_->file.id(), "mesh");
        write_mesh(mesh.id(), impl_->setup->mesh, scene.units.label(Quantity::length));
        impl_->create_frames();
        impl_->create_history(columns);
        impl_->create_traces(traces);
        impl_->summary = Rows(impl_->file.id(), "summary", H5T_NATIVE_UINT8, {}, 4096);
    });
    impl_->named([&] { hdf5::check(H5Fstart_swmr_write(impl_->file.id()), "live writing"); });
}

RunFileWriter::~RunFileWriter() = default;

void RunFileWriter::add_frame(const Snapshot& snapshot) {
    impl_->named([&] { impl_->append_frame(snapshot); });
}

void RunFileWriter::add_history(const History& history) {
    impl_->named([&] {
        impl_->append_history(history);
        impl_->append_traces();
    });
}

void RunFileWriter::finish(const std::string& summary_json) {
    impl_->named([&] {
        std::vector<std::uint8_t> bytes(summary_json.size());
        std::transform(summary_json.begin(), summary_json.end(), bytes.begin(),
                       std::bit_cast<std::uint8_t, char>);
        impl_->summary.append(std::span<const std::uint8_t>(bytes));
        impl_->flush();
    });
    const std::filesystem::path path = impl_->path;
    Handle file = std::move(impl_->file);
    impl_ = std::make_unique<Impl>();  // closes what the file holds
    if (!file.close()) throw RecordError(fmt::format("{}: {}", path.string(), hdf5::last_error()));
}

}  // namespace percuss
