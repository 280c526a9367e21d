#include "io/level_set_files.h"

#include <openvdb/tools/VolumeToMesh.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>
#include <vtkXMLImageDataWriter.h>
#include <vtkXMLPolyDataWriter.h>

#include <cassert>
#include <cmath>
#include <string>

#include "core/parallel.h"
#include "io/vtk_file.h"

namespace tidewater::io {
namespace {

std::string legend(const std::vector<NumberedLevelSet>& level_sets) {
    std::string text;
    for (const auto& [grid, number] : level_sets) {
        text += (text.empty() ? "" : ", ") + std::to_string(number) + " " + grid->getName();
    }
    return text;
}

// The voxels of an image, x fastest, z slowest.
struct Voxels {
    openvdb::Coord low;
    std::array<int, 3> count;

    std::size_t slice() const {
        return static_cast<std::size_t>(count[0]) * static_cast<std::size_t>(count[1]);
    }
    std::size_t size() const { return slice() * static_cast<std::size_t>(count[2]); }
};

Voxels voxels_of(const ImageExtent& extent, double voxel_size) {
    Voxels voxels;
    std::array<int, 3> low{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const bool flat = extent.dimension == 2 && axis == 1;
        low[axis] = flat ? 0 : static_cast<int>(std::ceil(extent.low[axis] / voxel_size - 1e-4));
        const int high = flat ? 0 : static_cast<int>(std::floor(extent.high[axis] / voxel_size + 1e-4));
        voxels.count[axis] = std::max(high - low[axis] + 1, 1);
    }
    voxels.low = {low[0], low[1], low[2]};
    return voxels;
}

// Calls use(index, value) for each voxel, in parallel.
template <class Use>
void for_each_value(const openvdb::FloatGrid& grid, const Voxels& voxels, const Use& use) {
    parallel_for(static_cast<std::size_t>(voxels.count[2]), [&](std::size_t slice) {
        const auto values = grid.getConstAccessor();
        std::size_t index = slice * voxels.slice();
        for (int y = 0; y < voxels.count[1]; ++y) {
            for (int x = 0; x < voxels.count[0]; ++x, ++index) {
                use(index, values.getValue(voxels.low.offsetBy(x, y, static_cast<int>(slice))));
            }
        }
    });
}

}  // namespace

void write_surfaces(const std::filesystem::path& path, const std::vector<NumberedLevelSet>& level_sets,
                    const Provenance& provenance) {
    vtkNew<vtkPoints> points;
    vtkNew<vtkCellArray> cells;
    vtkNew<vtkUnsignedCharArray> body;
    body->SetName("body");
    for (const auto& [grid, number] : level_sets) {
        std::vector<openvdb::Vec3s> corners;
        std::vector<openvdb::Vec4I> quads;
        openvdb::tools::volumeToMesh(*grid, corners, quads);
        const vtkIdType first = points->GetNumberOfPoints();
        for (const auto& corner : corners) {
            points->InsertNextPoint(corner.x(), corner.y(), corner.z());
            body->InsertNextValue(number);
        }
        for (const auto& quad : quads) {  // OpenVDB's go around clockwise
            const std::array<vtkIdType, 4> around{first + quad[3], first + quad[2], first + quad[1],
                                                  first + quad[0]};
            cells->InsertNextCell(4, around.data());
        }
    }
    vtkNew<vtkPolyData> data;
    data->SetPoints(points);
    data->SetPolys(cells);
    data->GetPointData()->AddArray(body);
    add_field(data, "bodies", legend(level_sets));
    add_provenance(data, "tidewater-surfaces", surfaces_format_version, provenance);
    write_vtk<vtkXMLPolyDataWriter>(path, data);
}

void write_image(const std::filesystem::path& path, const std::vector<NumberedLevelSet>& level_sets,
                 const ImageExtent& extent, bool distances, const Provenance& provenance) {
    assert(!level_sets.empty());
    const double voxel_size = level_sets.front().grid->voxelSize()[0];
    const Voxels voxels = voxels_of(extent, voxel_size);
    vtkNew<vtkImageData> data;
    data->SetDimensions(voxels.count.data());
    data->SetSpacing(voxel_size, voxel_size, voxel_size);
    data->SetOrigin(voxels.low.x() * voxel_size, voxels.low.y() * voxel_size, voxels.low.z() * voxel_size);

    vtkNew<vtkUnsignedCharArray> material;
    material->SetName("material");
    material->SetNumberOfValues(static_cast<vtkIdType>(voxels.size()));
    material->FillValue(0);
    unsigned char* const materials = material->GetPointer(0);
    data->GetPointData()->SetScalars(material);
    for (const auto& [grid, number] : level_sets) {
        assert(grid->voxelSize()[0] == voxel_size);
        vtkNew<vtkFloatArray> distance;
        if (distances) {
            distance->SetName(grid->getName().c_str());
            distance->SetNumberOfValues(static_cast<vtkIdType>(voxels.size()));
            data->GetPointData()->AddArray(distance);
        }
        float* const to = distances ? distance->GetPointer(0) : nullptr;
        for_each_value(*grid, voxels, [&, body = number](std::size_t index, float value) {
            if (value < 0.0f) materials[index] = body;
            if (to != nullptr) to[index] = value;
        });
    }
    add_field(data, "bodies", legend(level_sets));
    add_provenance(data, "tidewater-image", image_format_version, provenance);
    write_vtk<vtkXMLImageDataWriter>(path, data);
}

}  // namespace tidewater::io
