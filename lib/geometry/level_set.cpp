#include "geometry/level_set.h"

#include <openvdb/tools/SignedFloodFill.h>

#include <cmath>
#include <vector>

#include "core/error.h"
#include "core/parallel.h"

namespace tidewater::geometry {
namespace {

constexpr int half_band = 3;  // voxels
constexpr const char* material_key = "material";
constexpr const char* volume_key = "volume";
constexpr const char* scene_key = "scene_part";

using Leaf = openvdb::FloatTree::LeafNodeType;

openvdb::Coord voxel_at(const Point& point, double voxel_size, int margin) {
    const auto index = [&](int axis) {
        return static_cast<int>(std::floor(point[axis] / voxel_size)) + margin;
    };
    return {index(0), index(1), index(2)};
}

// The leaf's values inside the band; null if it has none.
Leaf* make_leaf(const openvdb::Coord& origin, double voxel_size,
                const std::function<double(const Point&)>& signed_distance) {
    const double background = half_band * voxel_size;
    const Point low = voxel_size * Point(origin.x(), origin.y(), origin.z());
    const double half_width = 0.5 * (Leaf::DIM - 1) * voxel_size;
    const double reach = std::sqrt(3.0) * half_width + background;
    if (std::abs(signed_distance(low + Point::Constant(half_width))) > reach) return nullptr;
    auto leaf = std::make_unique<Leaf>(origin, static_cast<float>(background));
    for (openvdb::Index n = 0; n < Leaf::SIZE; ++n) {
        const openvdb::Coord voxel = leaf->offsetToGlobalCoord(n);
        const double distance = signed_distance(voxel_size * Point(voxel.x(), voxel.y(), voxel.z()));
        if (std::abs(distance) < background) {
            leaf->setValueOn(n, static_cast<float>(distance));
        } else {
            leaf->setValueOff(n, static_cast<float>(distance < 0.0 ? -background : background));
        }
    }
    return leaf->isEmpty() ? nullptr : leaf.release();
}

template <class Meta>
auto metadata(const openvdb::FloatGrid& grid, const char* key) {
    const auto meta = grid.getMetadata<Meta>(key);
    if (!meta) {
        throw InputError("level set '" + grid.getName() + "' has no metadata '" + key +
                         "': it was not made by tidewater-geometry; run that stage again");
    }
    return meta->value();
}

}  // namespace

openvdb::FloatGrid::Ptr make_level_set(const std::string& name, double voxel_size, const Extent& extent,
                                       const std::function<double(const Point&)>& signed_distance) {
    openvdb::initialize();
    auto grid = openvdb::FloatGrid::create(static_cast<float>(half_band * voxel_size));
    grid->setName(name);
    grid->setGridClass(openvdb::GRID_LEVEL_SET);
    grid->setTransform(openvdb::math::Transform::createLinearTransform(voxel_size));

    const openvdb::Coord low = voxel_at(extent.low, voxel_size, -half_band);
    const openvdb::Coord high = voxel_at(extent.high, voxel_size, half_band + 1);
    std::vector<openvdb::Coord> origins;
    constexpr int width = static_cast<int>(Leaf::DIM), mask = ~(width - 1);
    for (int x = low.x() & mask; x <= high.x(); x += width) {
        for (int y = low.y() & mask; y <= high.y(); y += width) {
            for (int z = low.z() & mask; z <= high.z(); z += width) origins.emplace_back(x, y, z);
        }
    }
    std::vector<Leaf*> leaves(origins.size());
    parallel_for(origins.size(),
                 [&](std::size_t n) { leaves[n] = make_leaf(origins[n], voxel_size, signed_distance); });
    for (Leaf* leaf : leaves) {
        if (leaf) grid->tree().addLeaf(leaf);
    }
    openvdb::tools::signedFloodFill(grid->tree());
    return grid;
}

void describe_body(openvdb::FloatGrid& level_set, Material material, double volume) {
    level_set.insertMeta(material_key, openvdb::StringMetadata(std::string(material_name(material))));
    level_set.insertMeta(volume_key, openvdb::DoubleMetadata(volume));
}

bool is_body(const openvdb::FloatGrid& level_set) {
    return static_cast<bool>(level_set.getMetadata<openvdb::StringMetadata>(material_key));
}

Material body_material(const openvdb::FloatGrid& level_set) {
    const std::string name = metadata<openvdb::StringMetadata>(level_set, material_key);
    for (const Material material : all_materials) {
        if (name == material_name(material)) return material;
    }
    throw InputError("level set '" + level_set.getName() + "' has the unknown material '" + name +
                     "'; run tidewater-geometry again");
}

double body_volume(const openvdb::FloatGrid& level_set) {
    return metadata<openvdb::DoubleMetadata>(level_set, volume_key);
}

void mark_scene(openvdb::FloatGrid& level_set, const std::string& fingerprint) {
    level_set.insertMeta(scene_key, openvdb::StringMetadata(fingerprint));
}

std::string marked_scene(const openvdb::FloatGrid& level_set) {
    return metadata<openvdb::StringMetadata>(level_set, scene_key);
}

}  // namespace tidewater::geometry
