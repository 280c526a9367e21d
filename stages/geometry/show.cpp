#include "show.h"

#include "io/level_set_files.h"

namespace tidewater {
namespace {

constexpr double most_values = 50e6;  // of distances in the image; of more voxels it has the materials alone

// What is shown of a grid: nothing of the tank, of heights, and of ice that is there to be seeded.
std::uint8_t number_of(const std::string& name) {
    if (name == "bed") return 1;
    if (name == "water") return 2;
    if (name == "ice") return 3;
    if (name == "shelf") return 4;
    return name.starts_with("block") ? 5 : 0;
}

}  // namespace

void show(const StageContext& context, const Bodies& bodies,
          const std::vector<openvdb::FloatGrid::Ptr>& grids) {
    const scene::Scene& scene = context.scene;
    std::vector<io::NumberedLevelSet> shown;
    for (const auto& grid : grids) {
        if (const std::uint8_t number = number_of(grid->getName()); number != 0)
            shown.push_back({grid, number});
    }
    io::write_surfaces(context.folder / "surfaces.vtp", shown, context.provenance);
    const geometry::Extent tank = extent_of(bodies.tank);
    const io::ImageExtent extent{.dimension = scene.dimension,
                                 .low = {tank.low[0], tank.low[1], tank.low[2]},
                                 .high = {tank.high[0], tank.high[1], tank.high[2]}};
    double values = static_cast<double>(shown.size());
    for (const double length : scene.domain.size) values *= length / scene.domain.cell_size + 1.0;
    io::write_image(context.folder / "image.vti", shown, extent, values < most_values, context.provenance);
}

}  // namespace tidewater
