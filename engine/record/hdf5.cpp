#include "record/hdf5.hpp"

#include <algorithm>
#include <cassert>
#include <numeric>

#include <fmt/format.h>

namespace percuss::hdf5 {
namespace {

[[noreturn]] void fail(std::string_view what) {
    throw RecordError(fmt::format("{}: {}", what, last_error()));
}

std::size_t product(const std::vector<hsize_t>& shape) {
    return std::accumulate(shape.begin(), shape.end(), std::size_t{1}, std::multiplies<>());
}

Handle text_type(std::size_t length) {
    Handle type(H5Tcopy(H5T_C_S1), "text type");
    check(H5Tset_size(type.id(), std::max<std::size_t>(length, 1)), "text length");
    check(H5Tset_cset(type.id(), H5T_CSET_UTF8), "text encoding");
    check(H5Tset_strpad(type.id(), H5T_STR_NULLPAD), "text padding");
    return type;
}

Handle scalar() { return {H5Screate(H5S_SCALAR), "scalar"}; }

Handle open_dataset(hid_t parent, const char* name) {
    return {H5Dopen2(parent, name, H5P_DEFAULT), fmt::format("dataset '{}'", name)};
}

std::string without_padding(std::string text) {
    text.erase(std::find(text.begin(), text.end(), '\0'), text.end());
    return text;
}

}  // namespace

Handle::Handle(hid_t id, std::string_view what) : id_(id) {
    if (id < 0) fail(what);
}

bool Handle::close() noexcept {
    if (id_ < 0) return true;
    const hid_t id = std::exchange(id_, H5I_INVALID_HID);
    switch (H5Iget_type(id)) {
        case H5I_FILE:
            return H5Fclose(id) >= 0;
        case H5I_GROUP:
            return H5Gclose(id) >= 0;
        case H5I_DATASET:
            return H5Dclose(id) >= 0;
        case H5I_DATASPACE:
            return H5Sclose(id) >= 0;
        case H5I_DATATYPE:
            return H5Tclose(id) >= 0;
        case H5I_ATTR:
            return H5Aclose(id) >= 0;
        default:
            return H5Pclose(id) >= 0;  // property lists are what remains
    }
}

std::string last_error() {
    std::string reason;
    H5Ewalk2(
        H5E_DEFAULT, H5E_WALK_UPWARD,
        [](unsigned n, const H5E_error2_t* error, void* text) -> herr_t {
            if (n == 0) *static_cast<std::string*>(text) = error->desc;
            return 0;
        },
        &reason);
    return reason.empty() ? "HDF5 gave no reason" : reason;
}

void silence_errors() { H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); }

void check(herr_t status, std::string_view what) {
    if (status < 0) fail(what);
}

void write_attribute(hid_t object, const char* name, const std::string& text) {
    const Handle type = text_type(text.size()), space = scalar();
    const Handle attribute(H5Acreate2(object, name, type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT), name);
    check(H5Awrite(attribute.id(), type.id(), text.empty() ? "\0" : text.data()), name);
}

void write_attribute(hid_t object, const char* name, std::int64_t value) {
    const Handle space = scalar();
    const Handle attribute(H5Acreate2(object, name, H5T_NATIVE_INT64, space.id(), H5P_DEFAULT, H5P_DEFAULT),
                           name);
    check(H5Awrite(attribute.id(), H5T_NATIVE_INT64, &value), name);
}

std::string read_text_attribute(hid_t object, const char* name) {
    const Handle attribute(H5Aopen(object, name, H5P_DEFAULT), fmt::format("attribute '{}'", name));
    const Handle type(H5Aget_type(attribute.id()), name);
    if (H5Tget_class(type.id()) != H5T_STRING || H5Tis_variable_str(type.id()) != 0) {
        throw RecordError(fmt::format("attribute '{}' is not a text of fixed length", name));
    }
    std::string text(H5Tget_size(type.id()), '\0');
    check(H5Aread(attribute.id(), type.id(), text.data()), name);
    return without_padding(text);
}

std::int64_t read_integer_attribute(hid_t object, const char* name) {
    const Handle attribute(H5Aopen(object, name, H5P_DEFAULT), fmt::format("attribute '{}'", name));
    std::int64_t value = 0;
    check(H5Aread(attribute.id(), H5T_NATIVE_INT64, &value), name);
    return value;
}

Handle create_group(hid_t parent, const char* name) {
    return {H5Gcreate2(parent, name, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), name};
}

bool has_object(hid_t parent, const char* name) { return H5Lexists(parent, name, H5P_DEFAULT) > 0; }

void write_text(hid_t parent, const char* name, const std::string& text) {
    const Handle type = text_type(text.size()), space = scalar();
    const Handle dataset(
        H5Dcreate2(parent, name, type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), name);
    check(H5Dwrite(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, text.empty() ? "\0" : text.data()),
          name);
}

std::string read_text(hid_t parent, const char* name) {
    const std::vector<std::string> texts = read_texts(parent, name);
    if (texts.size() != 1) throw RecordError(fmt::format("dataset '{}' is not one text", name));
    return texts.front();
}

void write_texts(hid_t parent, const char* name, const std::vector<std::string>& texts) {
    std::size_t length = 1;
    for (const std::string& text : texts) length = std::max(length, text.size());
    std::string padded;
    for (const std::string& text : texts) (padded += text).append(length - text.size(), '\0');
    const Handle type = text_type(length);
    const hsize_t extent = texts.size();
    const Handle space(H5Screate_simple(1, &extent, nullptr), name);
    const Handle dataset(
        H5Dcreate2(parent, name, type.id(), space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), name);
    if (texts.empty()) return;
    check(H5Dwrite(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, padded.data()), name);
}

std::vector<std::string> read_texts(hid_t parent, const char* name) {
    const Handle dataset = open_dataset(parent, name);
    const Handle type(H5Dget_type(dataset.id()), name), space(H5Dget_space(dataset.id()), name);
    if (H5Tget_class(type.id()) != H5T_STRING || H5Tis_variable_str(type.id()) != 0) {
        throw RecordError(fmt::format("dataset '{}' does not hold texts of fixed length", name));
    }
    const std::size_t length = H5Tget_size(type.id());
    const auto count =
        static_cast<std::size_t>(std::max<hssize_t>(H5Sget_simple_extent_npoints(space.id()), 0));
    std::string padded(length * count, '\0');
    if (count > 0)
        check(H5Dread(dataset.id(), type.id(), H5S_ALL, H5S_ALL, H5P_DEFAULT, padded.data()), name);
    std::vector<std::string> texts;
    for (std::size_t i = 0; i < count; ++i)
        texts.push_back(without_padding(padded.substr(i * length, length)));
    return texts;
}

Rows::Rows(hid_t parent, const char* name, hid_t type, std::vector<hsize_t> row_shape, hsize_t chunk_rows)
    : shape_(std::move(row_shape)) {
    std::vector<hsize_t> extent{0}, limit{H5S_UNLIMITED}, chunk{chunk_rows};
    for (const hsize_t size : shape_) {
        assert(size > 0);
        extent.push_back(size);
        limit.push_back(size);
        chunk.push_back(size);
    }
    const Handle space(H5Screate_simple(static_cast<int>(extent.size()), extent.data(), limit.data()), name);
    const Handle layout(H5Pcreate(H5P_DATASET_CREATE), name);
    check(H5Pset_chunk(layout.id(), static_cast<int>(chunk.size()), chunk.data()), name);
    dataset_ =
        Handle(H5Dcreate2(parent, name, type, space.id(), H5P_DEFAULT, layout.id(), H5P_DEFAULT), name);
}

Rows::Rows(hid_t parent, const char* name) : dataset_(open_dataset(parent, name)) {
    const Handle space(H5Dget_space(dataset_.id()), name);
    const int rank = H5Sget_simple_extent_ndims(space.id());
    if (rank < 1) throw RecordError(fmt::format("dataset '{}' has no rows", name));
    std::vector<hsize_t> extent(static_cast<std::size_t>(rank));
    H5Sget_simple_extent_dims(space.id(), extent.data(), nullptr);
    rows_ = extent.front();
    shape_.assign(extent.begin() + 1, extent.end());
}

std::size_t Rows::row_size() const { return product(shape_); }
hsize_t Rows::rows() const { return rows_; }

Handle Rows::select(hsize_t begin, hsize_t count, std::vector<hsize_t>& extent) const {
    Handle space(H5Dget_space(dataset_.id()), "rows");
    std::vector<hsize_t> start(shape_.size() + 1, 0);
    start[0] = begin;
    extent.assign(1, count);
    extent.insert(extent.end(), shape_.begin(), shape_.end());
    check(H5Sselect_hyperslab(space.id(), H5S_SELECT_SET, start.data(), nullptr, extent.data(), nullptr),
          "rows");
    return space;
}

void Rows::append_raw(const void* values, std::size_t count, hid_t type) {
    assert(count % row_size() == 0);
    const hsize_t added = count / row_size();
    if (added == 0) return;
    std::vector<hsize_t> extent{rows_ + added};
    extent.insert(extent.end(), shape_.begin(), shape_.end());
    check(H5Dset_extent(dataset_.id(), extent.data()), "growing a dataset");
    const Handle target = select(rows_, added, extent);
    const Handle source(H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr), "rows");
    check(H5Dwrite(dataset_.id(), type, source.id(), target.id(), H5P_DEFAULT, values), "writing rows");
    rows_ += added;
}

void Rows::read_raw(void* values, hsize_t begin, hsize_t count, hid_t type) const {
    if (begin + count > rows_) throw RecordError("a dataset is shorter than the file's counters say");
    if (count == 0) return;
    std::vector<hsize_t> extent;
    const Handle source = select(begin, count, extent);
    const Handle target(H5Screate_simple(static_cast<int>(extent.size()), extent.data(), nullptr), "rows");
    check(H5Dread(dataset_.id(), type, target.id(), source.id(), H5P_DEFAULT, values), "reading rows");
}

Counter::Counter(hid_t parent, const char* name) {
    const Handle space = scalar();
    dataset_ = Handle(
        H5Dcreate2(parent, name, H5T_STD_I64LE, space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), name);
    set(0);
}

void Counter::set(std::int64_t value) {
    check(H5Dwrite(dataset_.id(), H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, &value), "counter");
    check(H5Dflush(dataset_.id()), "counter");
}

std::int64_t Counter::read(hid_t parent, const char* name) {
    const Handle dataset = open_dataset(parent, name);
    std::int64_t value = 0;
    check(H5Dread(dataset.id(), H5T_NATIVE_INT64, H5S_ALL, H5S_ALL, H5P_DEFAULT, &value), name);
    return value;
}

template <class T>
void write_array(hid_t parent, const char* name, std::span<const T> values, std::vector<hsize_t> shape) {
    assert(values.size() == product(shape));
    const Handle space(H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr), name);
    const Handle dataset(
        H5Dcreate2(parent, name, native_type<T>(), space.id(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT), name);
    if (values.empty()) return;
    check(H5Dwrite(dataset.id(), native_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), name);
}

template <class T>
std::vector<T> read_array(hid_t parent, const char* name) {
    const Handle dataset = open_dataset(parent, name);
    const Handle space(H5Dget_space(dataset.id()), name);
    std::vector<T> values(
        static_cast<std::size_t>(std::max<hssize_t>(H5Sget_simple_extent_npoints(space.id()), 0)));
    if (values.empty()) return values;
    check(H5Dread(dataset.id(), native_type<T>(), H5S_ALL, H5S_ALL, H5P_DEFAULT, values.data()), name);
    return values;
}

template void write_array(hid_t, const char*, std::span<const double>, std::vector<hsize_t>);
template void write_array(hid_t, const char*, std::span<const std::int32_t>, std::vector<hsize_t>);
template std::vector<double> read_array(hid_t, const char*);
template std::vector<std::int32_t> read_array(hid_t, const char*);

}  // namespace percuss::hdf5
