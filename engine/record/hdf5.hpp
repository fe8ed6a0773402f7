#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <hdf5.h>

#include "record/run_file.hpp"

/// The little of HDF5's C interface that run.h5 needs: owned handles, errors as RecordError with HDF5's own
/// reason. Private to engine/record.
namespace percuss::hdf5 {

/// Owns one HDF5 identifier of any kind.
class Handle {
  public:
    Handle() = default;
    /// @throws RecordError "what: HDF5's reason" when `id` is negative.
    Handle(hid_t id, std::string_view what);
    ~Handle() { close(); }
    Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)) {}
    Handle& operator=(Handle&& other) noexcept {
        if (this != &other) {
            close();
            id_ = std::exchange(other.id_, H5I_INVALID_HID);
        }
        return *this;
    }
    [[nodiscard]] hid_t id() const { return id_; }
    [[nodiscard]] explicit operator bool() const { return id_ >= 0; }
    /// @returns false when HDF5 reports an error (a full disk shows here).
    bool close() noexcept;

  private:
    hid_t id_ = H5I_INVALID_HID;
};

/// HDF5's innermost reason for its last error; turns its printing to stderr off.
[[nodiscard]] std::string last_error();
void silence_errors();
/// @throws RecordError when an HDF5 call returned a negative status.
void check(herr_t status, std::string_view what);

/// Memory types of the numbers that run.h5 holds.
template <class T>
[[nodiscard]] hid_t native_type();
template <>
[[nodiscard]] inline hid_t native_type<double>() {
    return H5T_NATIVE_DOUBLE;
}
template <>
[[nodiscard]] inline hid_t native_type<std::int32_t>() {
    return H5T_NATIVE_INT32;
}
template <>
[[nodiscard]] inline hid_t native_type<std::int64_t>() {
    return H5T_NATIVE_INT64;
}
template <>
[[nodiscard]] inline hid_t native_type<std::uint8_t>() {
    return H5T_NATIVE_UINT8;
}

void write_attribute(hid_t object, const char* name, const std::string& text);
void write_attribute(hid_t object, const char* name, std::int64_t value);
[[nodiscard]] std::string read_text_attribute(hid_t object, const char* name);
[[nodiscard]] std::int64_t read_integer_attribute(hid_t object, const char* name);

[[nodiscard]] Handle create_group(hid_t parent, const char* name);
[[nodiscard]] bool has_object(hid_t parent, const char* name);

/// Fixed-length UTF-8 strings (one dimension; none: a scalar), readable by every HDF5 tool.
void write_text(hid_t parent, const char* name, const std::string& text);
[[nodiscard]] std::string read_text(hid_t parent, const char* name);
void write_texts(hid_t parent, const char* name, const std::vector<std::string>& texts);
[[nodiscard]] std::vector<std::string> read_texts(hid_t parent, const char* name);

/// A dataset that grows along its first dimension by rows of fixed shape.
class Rows {
  public:
    Rows() = default;
    /// Creates it empty. @param row_shape the other dimensions, each > 0; @param chunk_rows rows per chunk.
    Rows(hid_t parent, const char* name, hid_t type, std::vector<hsize_t> row_shape, hsize_t chunk_rows);
    /// Opens an existing one.
    Rows(hid_t parent, const char* name);

    [[nodiscard]] hid_t id() const { return dataset_.id(); }
    [[nodiscard]] explicit operator bool() const { return static_cast<bool>(dataset_); }
    /// Numbers in one row.
    [[nodiscard]] std::size_t row_size() const;
    /// Rows on disk; a killed run may have left more than its counters promise.
    [[nodiscard]] hsize_t rows() const;
    [[nodiscard]] const std::vector<hsize_t>& row_shape() const { return shape_; }

    template <class T>
    void append(std::span<const T> values) {
        append_raw(values.data(), values.size(), native_type<T>());
    }
    template <class T>
    [[nodiscard]] std::vector<T> read(hsize_t begin, hsize_t count) const {
        std::vector<T> values(count * row_size());
        read_raw(values.data(), begin, count, native_type<T>());
        return values;
    }

  private:
    void append_raw(const void* values, std::size_t count, hid_t type);
    void read_raw(void* values, hsize_t begin, hsize_t count, hid_t type) const;
    [[nodiscard]] Handle select(hsize_t begin, hsize_t count, std::vector<hsize_t>& extent) const;

    Handle dataset_;
    std::vector<hsize_t> shape_;
    hsize_t rows_ = 0;
};

/// One number that is raised while the file is open.
class Counter {
  public:
    Counter() = default;
    Counter(hid_t parent, const char* name);  ///< creates it with value 0
    void set(std::int64_t value);             ///< on disk when the call returns
    [[nodiscard]] static std::int64_t read(hid_t parent, const char* name);

  private:
    Handle dataset_;
};

/// Whole arrays, written once. Zero-sized dimensions are allowed.
template <class T>
void write_array(hid_t parent, const char* name, std::span<const T> values, std::vector<hsize_t> shape);
template <class T>
[[nodiscard]] std::vector<T> read_array(hid_t parent, const char* name);

}  // namespace percuss::hdf5
