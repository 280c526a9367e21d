#include "geometry/height_grid.h"

#include "core/error.h"

namespace tidewater::geometry {

openvdb::FloatGrid::Ptr height_grid(const std::string& name, const HeightField& field) {
    openvdb::initialize();
    auto grid = openvdb::FloatGrid::create(0.0f);
    grid->setName(name);
    grid->setTransform(openvdb::math::Transform::createLinearTransform(field.spacing));
    auto accessor = grid->getAccessor();
    std::size_t n = 0;
    for (int i = 0; i < field.nx; ++i) {
        for (int j = 0; j < field.ny; ++j) accessor.setValue({i, j, 0}, static_cast<float>(field.heights[n++]));
    }
    return grid;
}

HeightField height_field(const openvdb::FloatGrid& grid) {
    const auto box = grid.evalActiveVoxelBoundingBox();
    if (box.empty() || box.min() != openvdb::Coord(0, 0, 0) || box.max().z() != 0)
        throw InputError("grid '" + grid.getName() + "' holds no heights; run tidewater-geometry again");
    HeightField field;
    field.heights.clear();
    field.spacing = grid.voxelSize().x();
    field.nx = box.max().x() + 1;
    field.ny = box.max().y() + 1;
    const auto accessor = grid.getConstAccessor();
    for (int i = 0; i < field.nx; ++i) {
        for (int j = 0; j < field.ny; ++j) field.heights.push_back(accessor.getValue({i, j, 0}));
    }
    return field;
}

}  // namespace tidewater::geometry
