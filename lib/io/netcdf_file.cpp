#include "io/netcdf_file.h"

#include <netcdf.h>

#include <cassert>
#include <limits>
#include <utility>

#include "core/error.h"

namespace tidewater::io {
namespace {

template <class Value>
constexpr nc_type type_of = NC_DOUBLE;
template <>
constexpr nc_type type_of<float> = NC_FLOAT;
template <>
constexpr nc_type type_of<char> = NC_CHAR;

}  // namespace

NetcdfWriter::NetcdfWriter(std::filesystem::path path) : path_(std::move(path)) {
    require(nc_create(path_.c_str(), NC_CLOBBER | NC_64BIT_OFFSET, &file_), "it cannot be created");
}

NetcdfWriter::~NetcdfWriter() {
    if (file_ >= 0) nc_abort(file_);
}

void NetcdfWriter::require(int status, const std::string& what) const {
    if (status == NC_NOERR) return;
    throw OutputError(path_.string() + ": " + what + ": " + nc_strerror(status) +
                      "; free disk space and run again");
}

int NetcdfWriter::find(const std::string& variable) const {
    if (variable.empty()) return NC_GLOBAL;
    int id = 0;
    require(nc_inq_varid(file_, variable.c_str(), &id), "variable " + variable);
    return id;
}

int NetcdfWriter::dimension(const std::string& name, std::size_t size) {
    assert(size > 0);
    int id = 0;
    require(nc_def_dim(file_, name.c_str(), size, &id), "dimension " + name);
    return id;
}

template <class Value>
void NetcdfWriter::variable(const std::string& name, const std::vector<int>& dimensions) {
    int id = 0;
    require(nc_def_var(file_, name.c_str(), type_of<Value>, static_cast<int>(dimensions.size()),
                       dimensions.data(), &id),
            "variable " + name);
}

void NetcdfWriter::attribute(const std::string& variable, const std::string& name, const std::string& text) {
    require(nc_put_att_text(file_, find(variable), name.c_str(), text.size(), text.c_str()),
            "attribute " + name);
}

void NetcdfWriter::missing_is_nan(const std::string& variable) {
    const int id = find(variable);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    nc_type type = NC_DOUBLE;
    require(nc_inq_vartype(file_, id, &type), "variable " + variable);
    require(nc_put_att_double(file_, id, "_FillValue", type, 1, &nan), "attribute _FillValue");
}

void NetcdfWriter::attributes(const Provenance& provenance) {
    for (const auto& [name, text] : provenance_fields(provenance)) attribute("", name, text);
}

void NetcdfWriter::end_definitions() { require(nc_enddef(file_), "its header cannot be written"); }

template <class Value>
void NetcdfWriter::values(const std::string& variable, std::span<const Value> values) {
    require(nc_put_var(file_, find(variable), values.data()), "variable " + variable + " cannot be written");
}

void NetcdfWriter::close() { require(nc_close(std::exchange(file_, -1)), "it cannot be completed"); }

template void NetcdfWriter::variable<double>(const std::string&, const std::vector<int>&);
template void NetcdfWriter::variable<float>(const std::string&, const std::vector<int>&);
template void NetcdfWriter::variable<char>(const std::string&, const std::vector<int>&);
template void NetcdfWriter::values<double>(const std::string&, std::span<const double>);
template void NetcdfWriter::values<float>(const std::string&, std::span<const float>);
template void NetcdfWriter::values<char>(const std::string&, std::span<const char>);

}  // namespace tidewater::io
