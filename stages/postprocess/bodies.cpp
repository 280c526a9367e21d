#include "bodies.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/error.h"
#include "io/table.h"

namespace tidewater::postprocess {
namespace {

constexpr const char* remedy = "; run tidewater-simulate again";

// The angle turned by, in 2D a column, in 3D the length of the rotation vector.
std::vector<double> read_angle(const io::Table& table, const std::filesystem::path& path) {
    if (const auto* angle = table.find("angle")) return *angle;
    const auto& x = io::require_column(table, "rotation_x", path);
    const auto& y = io::require_column(table, "rotation_y", path);
    const auto& z = io::require_column(table, "rotation_z", path);
    std::vector<double> angle;
    for (std::size_t r = 0; r < x.size(); ++r) angle.push_back(std::hypot(x[r], y[r], z[r]));
    return angle;
}

}  // namespace

std::vector<Body> read_bodies(const std::filesystem::path& path) {
    const io::Table table = io::read_table(path);
    const auto column = [&](const char* name) -> const std::vector<double>& {
        return io::require_column(table, name, path);
    };
    const auto &time = column("time"), &number = column("body"), &height = column("z"),
               &fastest = column("fastest"), &kinetic = column("kinetic"), &potential = column("potential"),
               &mass = column("mass");
    const std::vector<double> angle = read_angle(table, path);
    std::map<int, Body> by_number;
    for (std::size_t r = 0; r < time.size(); ++r) {
        Body& body = by_number[static_cast<int>(number[r])];
        body.number = static_cast<int>(number[r]);
        body.mass = mass[r];
        body.time.push_back(time[r]);
        body.height.push_back(height[r]);
        body.angle.push_back(angle[r]);
        body.fastest.push_back(fastest[r]);
        body.energy.push_back(kinetic[r] + potential[r]);
    }
    if (by_number.empty()) throw InputError(path.string() + ": it has no rows" + remedy);
    std::vector<Body> bodies;
    for (auto& [at, body] : by_number) bodies.push_back(std::move(body));
    for (const Body& body : bodies) {
        if (std::ranges::is_sorted(body.time, std::ranges::less_equal())) continue;
        throw InputError(path.string() + ": the times of body " + std::to_string(body.number) +
                         " do not rise" + remedy);
    }
    return bodies;
}

const Body& heaviest(const std::vector<Body>& bodies) {
    return *std::ranges::max_element(bodies, {}, &Body::mass);
}

BlockShape shape_of(int number, const scene::Scene& scene) {
    const auto& blocks = scene.blocks;
    if (number >= 1 && static_cast<std::size_t>(number) <= blocks.size()) {
        const auto& block = blocks[static_cast<std::size_t>(number) - 1];
        return {block.size, block.center, block.angle};
    }
    throw InputError("bodies.csv: body " + std::to_string(number) + " is no block of the scene" + remedy);
}

analysis::Slide slide_of(const Body& body, const scene::Scene& scene) {
    const std::vector<double> size = shape_of(body.number, scene).size;
    return {.speed = std::ranges::max(body.fastest),
            .thickness = std::min(size.front(), size.back()),
            .mass = body.mass,
            .width = scene.dimension == 3 ? size[1] : 1.0,
            .depth = scene.water.depth,
            .water_density = scene.water.model.density,
            .gravity = scene.domain.gravity};
}

}  // namespace tidewater::postprocess
