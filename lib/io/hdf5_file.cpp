#include "io/hdf5_file.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/error.h"

namespace tidewater::io {
namespace {

// 2^16 rows: 256 kB a chunk for a column of float, 2 MiB for nodes in double.
constexpr hsize_t chunk_rows = 65536;

Hdf5Handle timeless_properties(hid_t list_class) {
    Hdf5Handle properties(H5Pcreate(list_class));
    H5Pset_obj_track_times(properties.id(), false);
    return properties;
}

Hdf5Handle array_properties(std::size_t rows, int components, Packing packing) {
    Hdf5Handle properties = timeless_properties(H5P_DATASET_CREATE);
    if (rows == 0) return properties;
    const std::array<hsize_t, 2> chunk{std::min<hsize_t>(rows, chunk_rows), static_cast<hsize_t>(components)};
    H5Pset_chunk(properties.id(), components > 0 ? 2 : 1, chunk.data());
    if (packing == Packing::deflate) {
        H5Pset_shuffle(properties.id());
        H5Pset_deflate(properties.id(), 1);
    }
    H5Pset_fletcher32(properties.id());
    return properties;
}

// HDF5 1.10's own forms have checksums on all that is no array data.
Hdf5Handle access_properties(Metadata metadata) {
    Hdf5Handle properties(H5Pcreate(H5P_FILE_ACCESS));
    if (metadata == Metadata::checksummed) {
        H5Pset_libver_bounds(properties.id(), H5F_LIBVER_V110, H5F_LIBVER_V110);
    }
    return properties;
}

H5T_class_t attribute_class(const Hdf5Handle& attribute) {
    const Hdf5Handle type(H5Aget_type(attribute.id()));
    return H5Tget_class(type.id());
}

std::size_t value_count(const Hdf5Handle& attribute) {
    const Hdf5Handle space(H5Aget_space(attribute.id()));
    return static_cast<std::size_t>(std::max<hssize_t>(H5Sget_simple_extent_npoints(space.id()), 0));
}

// Of the n-th link in a group, in the order of the alphabet.
std::string link_name(const Hdf5Handle& group, hsize_t n) {
    std::array<char, 256> name{};
    H5Lget_name_by_idx(group.id(), ".", H5_INDEX_NAME, H5_ITER_INC, n, name.data(), name.size(), H5P_DEFAULT);
    return name.data();
}

}  // namespace

Hdf5Handle& Hdf5Handle::operator=(Hdf5Handle&& other) noexcept {
    if (this != &other) {
        close();
        id_ = std::exchange(other.id_, H5I_INVALID_HID);
    }
    return *this;
}

bool Hdf5Handle::close() {
    const hid_t id = std::exchange(id_, H5I_INVALID_HID);
    if (id < 0) return true;
    switch (H5Iget_type(id)) {
        case H5I_FILE:
            return H5Fclose(id) >= 0;
        case H5I_GROUP:
            return H5Gclose(id) >= 0;
        case H5I_DATASET:
            return H5Dclose(id) >= 0;
        case H5I_ATTR:
            return H5Aclose(id) >= 0;
        case H5I_DATATYPE:
            return H5Tclose(id) >= 0;
        case H5I_DATASPACE:
            return H5Sclose(id) >= 0;
        case H5I_GENPROP_LST:
            return H5Pclose(id) >= 0;
        default:
            return false;
    }
}

QuietHdf5::QuietHdf5() {
    // HDF5 would try at exit to finish a file that a full disk kept from being closed, and crash.
    static const herr_t first_call = H5dont_atexit();
    static_cast<void>(first_call);
    H5Eget_auto2(H5E_DEFAULT, &handler_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

QuietHdf5::~QuietHdf5() { H5Eset_auto2(H5E_DEFAULT, handler_, data_); }

// ---- writing ----

Hdf5Writer::Hdf5Writer(std::filesystem::path path, Metadata metadata) : path_(std::move(path)) {
    const QuietHdf5 quiet;
    const Hdf5Handle properties = timeless_properties(H5P_FILE_CREATE);
    const Hdf5Handle access = access_properties(metadata);
    file_ = Hdf5Handle(H5Fcreate(path_.c_str(), H5F_ACC_TRUNC, properties.id(), access.id()));
    require(file_.valid(), "it cannot be created");
}

void Hdf5Writer::require(bool succeeded, const std::string& what) const {
    if (!succeeded) throw OutputError(path_.string() + ": " + what + "; free disk space and run again");
}

void Hdf5Writer::group(const std::string& name) {
    const QuietHdf5 quiet;
    const Hdf5Handle properties = timeless_properties(H5P_GROUP_CREATE);
    const Hdf5Handle made(H5Gcreate2(file_.id(), name.c_str(), H5P_DEFAULT, properties.id(), H5P_DEFAULT));
    require(made.valid(), "group " + name + " cannot be written");
}

void Hdf5Writer::attribute(const std::string& object, const std::string& name, double value) {
    write_attribute(object, name, H5T_NATIVE_DOUBLE, 0, &value);
}

void Hdf5Writer::attribute(const std::string& object, const std::string& name,
                           std::span<const std::int64_t> values) {
    write_attribute(object, name, H5T_NATIVE_INT64, values.size() == 1 ? 0 : values.size(), values.data());
}

void Hdf5Writer::attribute(const std::string& object, const std::string& name, const std::string& text) {
    const Hdf5Handle type(H5Tcopy(H5T_C_S1));
    H5Tset_size(type.id(), std::max<std::size_t>(text.size(), 1));
    H5Tset_strpad(type.id(), H5T_STR_NULLPAD);
    write_attribute(object, name, type.id(), 0, text.c_str());
}

// count == 0: a scalar.
void Hdf5Writer::write_attribute(const std::string& object, const std::string& name, hid_t type,
                                 std::size_t count, const void* data) {
    const QuietHdf5 quiet;
    const hsize_t size = count;
    const Hdf5Handle space(count == 0 ? H5Screate(H5S_SCALAR) : H5Screate_simple(1, &size, nullptr));
    const Hdf5Handle made(H5Acreate_by_name(file_.id(), object.c_str(), name.c_str(), type, space.id(),
                                            H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
    require(made.valid() && H5Awrite(made.id(), type, data) >= 0, "attribute " + name + " cannot be written");
}

void Hdf5Writer::write_array(const std::string& name, hid_t type, const void* data, std::size_t rows,
                             int components, Packing packing) {
    const QuietHdf5 quiet;
    const std::array<hsize_t, 2> shape{rows, static_cast<hsize_t>(components)};
    const Hdf5Handle space(H5Screate_simple(components > 0 ? 2 : 1, shape.data(), nullptr));
    const Hdf5Handle properties = array_properties(rows, components, packing);
    const Hdf5Handle made(
        H5Dcreate2(file_.id(), name.c_str(), type, space.id(), H5P_DEFAULT, properties.id(), H5P_DEFAULT));
    const bool written =
        made.valid() && (rows == 0 || H5Dwrite(made.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) >= 0);
    require(written, "array " + name + " cannot be written");
}

void Hdf5Writer::close() {
    const QuietHdf5 quiet;
    require(file_.close(), "it cannot be completed");
}

// ---- reading ----

Hdf5Reader::Hdf5Reader(std::filesystem::path path, std::string remedy)
    : path_(std::move(path)), remedy_(std::move(remedy)) {
    if (!std::filesystem::exists(path_)) fail("the file does not exist");
    const QuietHdf5 quiet;
    file_ = Hdf5Handle(H5Fopen(path_.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT));
    if (!file_.valid()) fail("it is truncated or no HDF5 file");
}

void Hdf5Reader::fail(const std::string& problem) const {
    throw InputError(path_.string() + ": " + problem + "; " + remedy_);
}

void Hdf5Reader::require_format(const std::string& what, std::int64_t newest) const {
    if (!has_attribute("/", "format") || text("/", "format") != "tidewater-" + what) {
        fail("it is an HDF5 file but no tidewater " + what);
    }
    const std::int64_t version = integer("/", "format_version");
    if (version <= newest) return;
    fail("its format version " + std::to_string(version) + " is newer than this program's " +
         std::to_string(newest));
}

bool Hdf5Reader::has_attribute(const std::string& object, const std::string& name) const {
    const QuietHdf5 quiet;
    return H5Aexists_by_name(file_.id(), object.c_str(), name.c_str(), H5P_DEFAULT) > 0;
}

Hdf5Handle Hdf5Reader::open_attribute(const std::string& object, const std::string& name) const {
    const QuietHdf5 quiet;
    Hdf5Handle found(H5Aopen_by_name(file_.id(), object.c_str(), name.c_str(), H5P_DEFAULT, H5P_DEFAULT));
    if (!found.valid()) fail("attribute " + name + " is missing");
    return found;
}

Hdf5Handle Hdf5Reader::open_one_value(const std::string& object, const std::string& name) const {
    Hdf5Handle found = open_attribute(object, name);
    if (value_count(found) != 1)
        fail("attribute " + name + " does not hold one value; the file is of another program");
    return found;
}

double Hdf5Reader::number(const std::string& object, const std::string& name) const {
    const Hdf5Handle found = open_one_value(object, name);
    const QuietHdf5 quiet;
    double value = 0.0;
    const H5T_class_t kind = attribute_class(found);
    if ((kind != H5T_FLOAT && kind != H5T_INTEGER) || H5Aread(found.id(), H5T_NATIVE_DOUBLE, &value) < 0)
        fail("attribute " + name + " is not a number");
    return value;
}

std::int64_t Hdf5Reader::integer(const std::string& object, const std::string& name) const {
    const Hdf5Handle found = open_one_value(object, name);
    const QuietHdf5 quiet;
    std::int64_t value = 0;
    if (attribute_class(found) != H5T_INTEGER || H5Aread(found.id(), H5T_NATIVE_INT64, &value) < 0)
        fail("attribute " + name + " is no integer");
    return value;
}

std::string Hdf5Reader::text(const std::string& object, const std::string& name) const {
    const Hdf5Handle found = open_one_value(object, name);
    const QuietHdf5 quiet;
    const Hdf5Handle type(H5Aget_type(found.id()));
    if (H5Tget_class(type.id()) != H5T_STRING || H5Tis_variable_str(type.id()) > 0) {
        fail("attribute " + name + " is no fixed-size text");
    }
    std::string value(H5Tget_size(type.id()), '\0');
    if (H5Aread(found.id(), type.id(), value.data()) < 0) fail("attribute " + name + " cannot be read");
    return value.substr(0, value.find('\0'));
}

std::vector<std::int64_t> Hdf5Reader::integers(const std::string& object, const std::string& name) const {
    const Hdf5Handle found = open_attribute(object, name);
    const QuietHdf5 quiet;
    std::vector<std::int64_t> values(value_count(found));
    if (attribute_class(found) != H5T_INTEGER || H5Aread(found.id(), H5T_NATIVE_INT64, values.data()) < 0)
        fail("attribute " + name + " holds no integers");
    return values;
}

bool Hdf5Reader::has_array(const std::string& name) const {
    const QuietHdf5 quiet;
    return H5Lexists(file_.id(), name.c_str(), H5P_DEFAULT) > 0;
}

std::vector<std::string> Hdf5Reader::array_names(const std::string& group) const {
    const QuietHdf5 quiet;
    std::vector<std::string> names;
    const Hdf5Handle found(H5Gopen2(file_.id(), group.c_str(), H5P_DEFAULT));
    H5G_info_t info{};
    if (!found.valid() || H5Gget_info(found.id(), &info) < 0) return names;
    for (hsize_t n = 0; n < info.nlinks; ++n) names.push_back(link_name(found, n));
    return names;
}

std::vector<std::size_t> Hdf5Reader::shape(const std::string& name) const {
    const QuietHdf5 quiet;
    const Hdf5Handle found(H5Dopen2(file_.id(), name.c_str(), H5P_DEFAULT));
    if (!found.valid()) fail("array " + name + " is missing");
    const Hdf5Handle space(H5Dget_space(found.id()));
    std::vector<hsize_t> lengths(static_cast<std::size_t>(H5Sget_simple_extent_ndims(space.id())));
    H5Sget_simple_extent_dims(space.id(), lengths.data(), nullptr);
    return {lengths.begin(), lengths.end()};
}

Hdf5Handle Hdf5Reader::open_array(const std::string& name, int components, std::size_t& count) const {
    const QuietHdf5 quiet;
    Hdf5Handle found(H5Dopen2(file_.id(), name.c_str(), H5P_DEFAULT));
    if (!found.valid()) fail("array " + name + " is missing");
    const Hdf5Handle space(H5Dget_space(found.id()));
    std::array<hsize_t, 2> shape{};
    const int rank = H5Sget_simple_extent_ndims(space.id());
    if (rank != (components > 0 ? 2 : 1)) fail("array " + name + " has an unexpected shape");
    H5Sget_simple_extent_dims(space.id(), shape.data(), nullptr);
    if (components > 0 && shape[1] != static_cast<hsize_t>(components)) {
        fail("array " + name + " does not have " + std::to_string(components) + " components");
    }
    count = shape[0] * (components > 0 ? shape[1] : 1);
    return found;
}

void Hdf5Reader::require_type(const Hdf5Handle& array, hid_t type, const std::string& name) const {
    const QuietHdf5 quiet;
    const Hdf5Handle found(H5Dget_type(array.id()));
    if (H5Tequal(found.id(), type) <= 0) fail("array " + name + " holds numbers of another type");
}

void Hdf5Reader::read_array(const Hdf5Handle& array, hid_t type, const std::string& name, void* to) const {
    const QuietHdf5 quiet;
    if (H5Dread(array.id(), type, H5S_ALL, H5S_ALL, H5P_DEFAULT, to) < 0) {
        fail("array " + name + " is damaged (its checksum does not match)");
    }
}

}  // namespace tidewater::io
