// A thin layer over the NetCDF C library for files of its classic format, which every reader opens and whose
// bytes follow from the contents alone: no times are stored, nor versions of libraries.
//
//     NetcdfWriter file(part.part_path());
//     const int time = file.dimension("time", 3);
//     file.variable<double>("time", {time});
//     file.attribute("time", "units", "s");
//     file.end_definitions();
//     file.values<double>("time", seconds);
//     file.close();
#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "core/provenance.h"

namespace tidewater::io {

// One file being written. Members throw OutputError; call close() to learn that everything arrived. All
// definitions come before end_definitions(), all values after it.
class NetcdfWriter {
public:
    // Creates or truncates path.
    explicit NetcdfWriter(std::filesystem::path path);
    ~NetcdfWriter();
    NetcdfWriter(const NetcdfWriter&) = delete;
    NetcdfWriter& operator=(const NetcdfWriter&) = delete;

    // The dimension's number; size ≥ 1 (0 would mean unlimited).
    int dimension(const std::string& name, std::size_t size);

    // Value: double, float or char; the last dimension varies fastest.
    template <class Value>
    void variable(const std::string& name, const std::vector<int>& dimensions);

    // Of a variable, or of the file with variable = "".
    void attribute(const std::string& variable, const std::string& name, const std::string& text);
    // What stands for a value that is missing: NaN, of a variable of doubles or floats.
    void missing_is_nan(const std::string& variable);
    // The provenance as attributes of the file.
    void attributes(const Provenance& provenance);

    void end_definitions();

    // As many values as the variable's dimensions say.
    template <class Value>
    void values(const std::string& variable, std::span<const Value> values);

    void close();

private:
    int find(const std::string& variable) const;
    void require(int status, const std::string& what) const;

    std::filesystem::path path_;
    int file_ = -1;
};

}  // namespace tidewater::io
