#include "io/water_surface.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkXMLPolyDataWriter.h>

#include <cmath>
#include <stdexcept>
#include <vector>

#include "io/text.h"
#include "io/vtk_file.h"

namespace tidewater::io {
namespace {

constexpr vtkIdType none = -1;

// The points' numbers by place; `none` where there is no surface.
using Numbers = std::vector<vtkIdType>;

Numbers number_places(const Surface& surface) {
    Numbers numbers(surface.place_count(), none);
    vtkIdType count = 0;
    for (std::size_t place = 0; place < numbers.size(); ++place) {
        if (std::isfinite(surface.elevation[place])) numbers[place] = count++;
    }
    return numbers;
}

vtkNew<vtkPoints> points_of(const Surface& surface, const Numbers& numbers) {
    vtkNew<vtkPoints> points;
    for (std::size_t place = 0; place < numbers.size(); ++place) {
        if (numbers[place] == none) continue;
        points->InsertNextPoint(surface.x[place % surface.x.size()], surface.y[place / surface.x.size()],
                                surface.still_level + static_cast<double>(surface.elevation[place]));
    }
    return points;
}

void add_column(const char* name, std::span<const float> values, const Numbers& numbers, vtkPolyData* data) {
    vtkNew<vtkFloatArray> array;
    array->SetName(name);
    for (std::size_t place = 0; place < numbers.size(); ++place) {
        if (numbers[place] != none) array->InsertNextValue(values[place]);
    }
    data->GetPointData()->AddArray(array);
}

// Each run of neighbouring places with water as one line.
vtkNew<vtkCellArray> lines(const Numbers& numbers) {
    vtkNew<vtkCellArray> cells;
    std::vector<vtkIdType> line;
    const auto end_line = [&] {
        if (line.size() > 1) cells->InsertNextCell(static_cast<vtkIdType>(line.size()), line.data());
        line.clear();
    };
    for (const vtkIdType number : numbers) number == none ? end_line() : line.push_back(number);
    end_line();
    return cells;
}

// Two triangles between four places, one where one of them is missing, counterclockwise seen from above.
vtkNew<vtkCellArray> triangles(const Numbers& numbers, std::size_t columns, std::size_t rows) {
    vtkNew<vtkCellArray> cells;
    std::vector<vtkIdType> corners;
    for (std::size_t j = 0; j + 1 < rows; ++j) {
        for (std::size_t i = 0; i + 1 < columns; ++i) {
            const std::size_t low = i + columns * j, high = low + columns;
            corners.clear();
            for (const std::size_t place : {low, low + 1, high + 1, high}) {
                if (numbers[place] != none) corners.push_back(numbers[place]);
            }
            for (std::size_t third = 2; third < corners.size(); ++third) {
                const vtkIdType triangle[] = {corners[0], corners[third - 1], corners[third]};
                cells->InsertNextCell(3, triangle);
            }
        }
    }
    return cells;
}

std::vector<float> depths(const Surface& surface) {
    std::vector<float> depth(surface.place_count());
    for (std::size_t place = 0; place < depth.size(); ++place) {
        depth[place] =
            static_cast<float>(surface.still_level) + surface.elevation[place] - surface.bed[place];
    }
    return depth;
}

}  // namespace

std::string water_surface_name(std::size_t frame) { return numbered_name("water_surface", frame, "vtp"); }

void write_water_surface(const std::filesystem::path& path, const Surface& surface,
                         std::span<const float> speed, const Provenance& provenance) {
    const std::size_t count = surface.place_count();
    if (surface.elevation.size() != count || surface.bed.size() != count || speed.size() != count)
        throw std::invalid_argument("write_water_surface: a column does not have one entry per place");
    const Numbers numbers = number_places(surface);
    vtkNew<vtkPolyData> data;
    data->SetPoints(points_of(surface, numbers));
    if (surface.y.size() > 1)
        data->SetPolys(triangles(numbers, surface.x.size(), surface.y.size()));
    else
        data->SetLines(lines(numbers));
    add_column("elevation", surface.elevation, numbers, data);
    add_column("speed", speed, numbers, data);
    add_column("depth", depths(surface), numbers, data);
    add_provenance(data, "tidewater-water-surface", water_surface_format_version, provenance);
    write_vtk<vtkXMLPolyDataWriter>(path, data);
}

}  // namespace tidewater::io
