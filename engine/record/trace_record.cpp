#include "record/trace_record.hpp"

#include "record/layout.hpp"

namespace percuss {
namespace {

using hdf5::Handle;
using hdf5::Rows;

Rows unit_rows(hid_t group, const char* name, const std::string& unit, std::vector<hsize_t> shape,
               hsize_t chunk) {
    Rows rows(group, name, H5T_NATIVE_DOUBLE, std::move(shape), chunk);
    hdf5::write_attribute(rows.id(), "unit", unit);
    return rows;
}

Trace read_trace(hid_t traces, const std::string& name) {
    const Handle group(H5Gopen2(traces, name.c_str(), H5P_DEFAULT), name);
    Trace trace;
    trace.name = name;
    trace.quantity = layout::quantity_of(hdf5::read_text_attribute(group.id(), "quantity"));
    trace.along = hdf5::read_array<double>(group.id(), "along");
    const auto points = hdf5::read_array<double>(group.id(), "point");
    const Rows time(group.id(), "time"), value(group.id(), "value");
    const std::size_t width = value.row_size(), count = trace.along.size();
    if (count == 0 || points.size() != 2 * count || width % count != 0)
        throw RecordError("the trace '" + name + "' is damaged");
    for (std::size_t k = 0; k < count; ++k) trace.points.emplace_back(points[2 * k], points[2 * k + 1]);
    trace.components = width / count;
    auto rows = std::make_shared<History>(trace_columns(trace));
    const auto filled = static_cast<hsize_t>(hdf5::Counter::read(group.id(), "count"));
    const auto times = time.read<double>(0, filled), values = value.read<double>(0, filled);
    std::vector<double> row;
    for (std::size_t f = 0; f < filled; ++f) {
        row.assign(1, times[f]);
        row.insert(row.end(), values.begin() + static_cast<std::ptrdiff_t>(f * width),
                   values.begin() + static_cast<std::ptrdiff_t>((f + 1) * width));
        rows->append(row);
    }
    trace.rows = std::move(rows);
    return trace;
}

}  // namespace

TraceWriter::TraceWriter(hid_t traces, const Trace& trace, const Units& units)
    : trace_(trace), group_(hdf5::create_group(traces, trace.name.c_str())) {
    hdf5::write_attribute(group_.id(), "quantity", std::string(layout::quantity_name(trace.quantity)));
    const hsize_t count = trace.points.size();
    std::vector<double> points;
    for (const Vec2& point : trace.points) points.insert(points.end(), {point.x(), point.y()});
    hdf5::write_array(group_.id(), "point", std::span<const double>(points), {count, 2});
    hdf5::write_array(group_.id(), "along", std::span<const double>(trace.along), {count});
    constexpr hsize_t few = 64;
    time_ = unit_rows(group_.id(), "time", units.label(Quantity::time), {}, few);
    std::vector<hsize_t> shape{count};
    if (trace.components > 1) shape.push_back(trace.components);
    value_ = unit_rows(group_.id(), "value", units.label(trace.quantity), std::move(shape), few);
    rows_ = hdf5::Counter(group_.id(), "count");
}

void TraceWriter::append() {
    const std::size_t end = trace_.rows->rows(), width = trace_.rows->columns().size();
    if (written_ >= end) return;
    const std::vector<double> table = trace_.rows->table(written_, end);
    std::vector<double> times, values;
    for (auto row = table.begin(); row != table.end(); row += static_cast<std::ptrdiff_t>(width)) {
        times.push_back(*row);
        values.insert(values.end(), row + 1, row + static_cast<std::ptrdiff_t>(width));
    }
    time_.append(std::span<const double>(times));
    value_.append(std::span<const double>(values));
    written_ = end;
}

void TraceWriter::count() { rows_.set(static_cast<std::int64_t>(written_)); }

std::vector<Trace> read_traces(hid_t file) {
    std::vector<Trace> traces;
    if (!hdf5::has_object(file, "traces")) return traces;
    const Handle group(H5Gopen2(file, "traces", H5P_DEFAULT), "/traces");
    for (const std::string& name : hdf5::read_texts(group.id(), "name"))
        traces.push_back(read_trace(group.id(), name));
    return traces;
}

}  // namespace percuss
