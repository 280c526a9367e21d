// A thin layer over the HDF5 C API: handles that close themselves, and arrays and attributes of flat data.
// Files written here have the same bytes for the same contents: no times are stored.
#pragma once

#include <hdf5.h>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace tidewater::io {

// Owns one HDF5 identifier of any kind: file, group, data set, attribute, type, space or property list.
class Hdf5Handle {
public:
    explicit Hdf5Handle(hid_t id = H5I_INVALID_HID) : id_(id) {}
    ~Hdf5Handle() { close(); }
    Hdf5Handle(Hdf5Handle&& other) noexcept : id_(other.id_) { other.id_ = H5I_INVALID_HID; }
    Hdf5Handle& operator=(Hdf5Handle&& other) noexcept;

    hid_t id() const { return id_; }
    bool valid() const { return id_ >= 0; }

    // False if the library could not write out what the handle still held.
    bool close();

private:
    hid_t id_;
};

// While it lives, HDF5 prints no error stack on standard error; our one-line errors replace it.
class QuietHdf5 {
public:
    QuietHdf5();
    ~QuietHdf5();
    QuietHdf5(const QuietHdf5&) = delete;
    QuietHdf5& operator=(const QuietHdf5&) = delete;

private:
    H5E_auto2_t handler_ = nullptr;
    void* data_ = nullptr;
};

template <class T>
hid_t hdf5_type();

// How an array lies in the file. Every non-empty array carries Fletcher-32 checksums, which HDF5 verifies on
// reading.
enum class Packing {
    none,     // as it is: for measured or computed values, which hardly compress
    deflate,  // shuffle and deflate level 1: for regular integers
};

// How names, shapes and attributes lie in the file.
enum class Metadata {
    plain,        // as every HDF5 library reads it, VTK's own too; damage may go unnoticed
    checksummed,  // as HDF5 1.10 and later read it; damage is found
};

// One file being written. Members throw OutputError; call close() to learn that everything arrived.
class Hdf5Writer {
public:
    // Creates or truncates path.
    explicit Hdf5Writer(std::filesystem::path path, Metadata metadata = Metadata::plain);

    // Group names are absolute, such as "/VTKHDF"; parents first.
    void group(const std::string& name);
    void attribute(const std::string& object, const std::string& name, double value);
    void attribute(const std::string& object, const std::string& name, std::span<const std::int64_t> values);
    // Fixed-size and null-padded, the form that VTK asks for.
    void attribute(const std::string& object, const std::string& name, const std::string& text);

    // components == 0: shape (values.size()); else shape (values.size() / components, components).
    template <class T>
    void array(const std::string& name, std::span<const T> values, int components = 0,
               Packing packing = Packing::none);

    void close();

private:
    void require(bool succeeded, const std::string& what) const;
    void write_attribute(const std::string& object, const std::string& name, hid_t type, std::size_t count,
                         const void* data);
    void write_array(const std::string& name, hid_t type, const void* data, std::size_t rows, int components,
                     Packing packing);

    std::filesystem::path path_;
    Hdf5Handle file_;
};

// One file being read. Members throw InputError that names the file, what is wrong and `remedy`.
class Hdf5Reader {
public:
    Hdf5Reader(std::filesystem::path path, std::string remedy);

    // The root attributes `format` and `format_version` must be "tidewater-<what>" and `newest` at most.
    void require_format(const std::string& what, std::int64_t newest) const;

    bool has_attribute(const std::string& object, const std::string& name) const;
    // An attribute of one value of that kind; anything else is an error.
    double number(const std::string& object, const std::string& name) const;
    std::int64_t integer(const std::string& object, const std::string& name) const;
    std::string text(const std::string& object, const std::string& name) const;
    // An attribute of any number of integers.
    std::vector<std::int64_t> integers(const std::string& object, const std::string& name) const;

    // The groups above it must be there.
    bool has_array(const std::string& name) const;
    // The names of the arrays in a group, in the order of the alphabet; none without the group.
    std::vector<std::string> array_names(const std::string& group) const;
    // How long the array is along each of its axes.
    std::vector<std::size_t> shape(const std::string& name) const;
    // The array's values, row by row; its shape must be as `components` says (see Hdf5Writer::array).
    template <class T>
    std::vector<T> array(const std::string& name, int components = 0) const;

    // The same without a copy, for large arrays: how many rows there are, then all of them to `values`. The
    // array must have been written as numbers of type T.
    template <class T>
    std::size_t rows(const std::string& name, int components = 0) const;
    template <class T>
    void fill(const std::string& name, std::span<T> values, int components = 0) const;

    // Throws InputError: "<path>: <problem>; <remedy>".
    [[noreturn]] void fail(const std::string& problem) const;

private:
    Hdf5Handle open_attribute(const std::string& object, const std::string& name) const;
    Hdf5Handle open_one_value(const std::string& object, const std::string& name) const;
    Hdf5Handle open_array(const std::string& name, int components, std::size_t& count) const;
    void require_type(const Hdf5Handle& array, hid_t type, const std::string& name) const;
    void read_array(const Hdf5Handle& array, hid_t type, const std::string& name, void* to) const;

    std::filesystem::path path_;
    std::string remedy_;
    Hdf5Handle file_;
};

template <>
inline hid_t hdf5_type<float>() {
    return H5T_NATIVE_FLOAT;
}
template <>
inline hid_t hdf5_type<double>() {
    return H5T_NATIVE_DOUBLE;
}
template <>
inline hid_t hdf5_type<std::uint8_t>() {
    return H5T_NATIVE_UINT8;
}
template <>
inline hid_t hdf5_type<char>() {
    return H5T_NATIVE_CHAR;
}
template <>
inline hid_t hdf5_type<std::int32_t>() {
    return H5T_NATIVE_INT32;
}
template <>
inline hid_t hdf5_type<std::uint32_t>() {
    return H5T_NATIVE_UINT32;
}
template <>
inline hid_t hdf5_type<std::int64_t>() {
    return H5T_NATIVE_INT64;
}
template <>
inline hid_t hdf5_type<std::uint64_t>() {
    return H5T_NATIVE_UINT64;
}

template <class T>
void Hdf5Writer::array(const std::string& name, std::span<const T> values, int components, Packing packing) {
    const std::size_t width = components > 0 ? static_cast<std::size_t>(components) : 1;
    write_array(name, hdf5_type<T>(), values.data(), values.size() / width, components, packing);
}

template <class T>
std::vector<T> Hdf5Reader::array(const std::string& name, int components) const {
    std::size_t count = 0;
    const Hdf5Handle data = open_array(name, components, count);
    std::vector<T> values(count);
    if (count > 0) read_array(data, hdf5_type<T>(), name, values.data());
    return values;
}

template <class T>
std::size_t Hdf5Reader::rows(const std::string& name, int components) const {
    std::size_t count = 0;
    const Hdf5Handle data = open_array(name, components, count);
    require_type(data, hdf5_type<T>(), name);
    return count / (components > 0 ? static_cast<std::size_t>(components) : 1);
}

template <class T>
void Hdf5Reader::fill(const std::string& name, std::span<T> values, int components) const {
    std::size_t count = 0;
    const Hdf5Handle data = open_array(name, components, count);
    require_type(data, hdf5_type<T>(), name);
    if (count != values.size())
        fail("array " + name + " holds " + std::to_string(count) + " values instead of " +
             std::to_string(values.size()));
    if (count > 0) read_array(data, hdf5_type<T>(), name, values.data());
}

}  // namespace tidewater::io
