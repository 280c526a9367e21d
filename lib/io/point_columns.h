// Where the values of a snapshot's column come from in the points of another program's file.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include <vtkDataArray.h>

#include "io/particle_files.h"
#include "io/point_cloud.h"

namespace tidewater::io {

// A file that is being read. The members throw InputError.
struct PointSource {
    const std::filesystem::path& path;
    const ParticleImport& import;
    const PointCloud& cloud;

    std::size_t count() const { return static_cast<std::size_t>(cloud.data->GetNumberOfPoints()); }

    // "<path>: <problem>"
    [[noreturn]] void fail(const std::string& problem) const;
    // "<path>: <problem>; its arrays are vel, Idp"
    [[noreturn]] void fail_with_arrays(const std::string& problem) const;
};

// One number per particle: scale × a component of an array + shift. Without an array the component's place
// is taken by the row where `row` says so, else by 0.
struct Component {
    vtkDataArray* array = nullptr;
    int component = 0;
    double scale = 1.0, shift = 0.0;
    bool row = false;

    double operator()(std::size_t p) const {
        if (array) return scale * array->GetComponent(static_cast<vtkIdType>(p), component) + shift;
        return row ? static_cast<double>(p) : shift;
    }
};

// Nothing if the file has no array of that name.
vtkDataArray* find_array(const PointSource& source, const std::string& name);

// All that the column is made of, along the files' axes. Throws InputError if one of its arrays is missing.
std::vector<Component> column_components(const PointSource& source, const std::string& column);

// From the components of a vector along the files' axes those along ours; empty if they make no vector.
std::vector<Component> turn(std::vector<Component> file, const ParticleImport& import);

}  // namespace tidewater::io
