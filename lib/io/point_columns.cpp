#include "io/point_columns.h"

#include <vtkPointData.h>

#include "core/error.h"
#include "io/text.h"

namespace tidewater::io {
namespace {

// All components that a part of a column stands for: of an array, or one that is constant.
std::vector<Component> part_components(const PointSource& source, const std::string& column,
                                       const ArrayPart& part) {
    if (vtkDataArray* array = find_array(source, part.array)) {
        const int count = array->GetNumberOfComponents();
        if (part.component >= count) {
            source.fail("column " + column + ": array " + part.array + " has " + std::to_string(count) +
                        " components, counted from 0; there is no [" + std::to_string(part.component) + "]");
        }
        if (part.component >= 0) return {{.array = array, .component = part.component}};
        std::vector<Component> all;
        for (int c = 0; c < count; ++c) all.push_back({.array = array, .component = c});
        return all;
    }
    const auto material = material_named(part.array);
    if (column == "material" && material) return {{.shift = static_cast<double>(*material)}};
    if (const auto number = parse_number(part.array)) return {{.shift = *number}};
    const std::string wrong = part.array == column ? "column " + column + " is missing"
                                                   : "column " + column + ": there is no array " + part.array;
    source.fail_with_arrays(wrong + "; name one by --map " + column + "=ARRAY");
}

Component negative(Component component) {
    component.scale = -component.scale;
    component.shift = -component.shift;
    return component;
}

}  // namespace

void PointSource::fail(const std::string& problem) const { throw InputError(path.string() + ": " + problem); }

void PointSource::fail_with_arrays(const std::string& problem) const {
    std::string names;
    for (const std::string& name : cloud.arrays) names += (names.empty() ? "" : ", ") + name;
    fail(problem + (names.empty() ? "; it has no arrays" : "; its arrays are " + names));
}

vtkDataArray* find_array(const PointSource& source, const std::string& name) {
    return source.cloud.data->GetPointData()->GetArray(name.c_str());
}

std::vector<Component> column_components(const PointSource& source, const std::string& column) {
    std::vector<Component> all;
    for (const ArrayPart& part : column_source(source.import.map, column)) {
        for (const Component& component : part_components(source, column, part)) all.push_back(component);
    }
    return all;
}

std::vector<Component> turn(std::vector<Component> file, const ParticleImport& import) {
    if (file.size() == 1 && file[0].array == nullptr) file.assign(3, file[0]);
    if (file.size() == 2 && import.dimension == 2) return {file[0], {}, file[1]};
    if (file.size() != 3) return {};
    if (import.y_up) file = {file[0], negative(file[2]), file[1]};
    if (import.dimension == 2) file[1] = {};
    return file;
}

}  // namespace tidewater::io
