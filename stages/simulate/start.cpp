#include "start.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>

#include "analysis/wave_theory.h"
#include "common/ground.h"
#include "core/error.h"
#include "core/hash.h"
#include "cut_ice.h"
#include "geometry/seeding.h"
#include "io/vdb.h"

namespace tidewater {
namespace {

template <int D>
mpm::Walls<D> make_walls(const scene::Scene::Domain& domain) {
    mpm::Walls<D> walls;
    walls[0] = {domain.wall_left, domain.wall_right};
    if constexpr (D == 3) walls[1] = {domain.wall_front, domain.wall_back};
    walls[D - 1] = {domain.wall_bottom, domain.wall_top};
    return walls;
}

// How the ground acts, in SI units.
mpm::GroundRule make_rule(const scene::Scene& scene, const scene::Ground& ground) {
    return {.ice = {.friction = ground.friction,
                    .regular_speed = ground.sliding_speed / scene::seconds_per_year,
                    .weertman =
                        ground.weertman * std::pow(scene::seconds_per_year, 1.0 / ground.sliding_exponent),
                    .exponent = ground.sliding_exponent,
                    .pore_pressure = ground.pore_pressure},
            .holds_water = std::isinf(ground.drag),
            .sea_level = scene.has("water") ? scene.water.depth : 0.0,
            .sea_weight = scene.water.model.density * scene.domain.gravity,
            .ice_density = scene.ice.model.density};
}

mpm::DragLaw make_drag(const scene::Ground& ground) {
    return {.coefficient = std::isinf(ground.drag) ? 0.0 : ground.drag, .manning = ground.manning};
}

// The ground at every node line; a profile is the same for all y.
template <int D>
mpm::Bed<D> make_bed(const scene::Scene& scene, const Ground& ground) {
    mpm::Bed<D> bed;
    bed.rule = make_rule(scene, scene.bed.ground);
    bed.spacing = scene.domain.cell_size;
    bed.points.fill(1);
    bed.points[0] = static_cast<int>(std::lround(scene.domain.size[0] / bed.spacing)) + 1;
    if (D == 3 && ground.field)
        bed.points.back() = static_cast<int>(std::lround(scene.domain.size[1] / bed.spacing)) + 1;
    for (int n = 0; n < bed.points[0]; ++n) {
        for (int m = 0; m < (D == 3 ? bed.points.back() : 1); ++m)
            bed.heights.push_back(ground.height(n * bed.spacing, m * bed.spacing));
    }
    return bed;
}

mpm::Piston make_piston(const scene::Scene& scene) {
    return {.motion = scene.piston.motion,
            .height = scene.piston.height,
            .depth = scene.water.depth,
            .gravity = scene.domain.gravity,
            .amplitude = scene.piston.amplitude,
            .period = scene.piston.period,
            .ramp = scene.piston.ramp};
}

mpm::Sponge make_sponge(const scene::Scene& scene) {
    const double width = scene.sponge.width, celerity = std::sqrt(scene.domain.gravity * scene.water.depth);
    return {.from = scene.domain.size.front() - width,
            .width = width,
            .rate = scene.sponge.strength * celerity / width,
            .level = scene.water.depth};
}

mpm::Outlet make_outlet(const scene::Scene& scene) {
    return {.from = scene.domain.size.front() - scene.outlet.width, .level = scene.water.depth};
}

template <int D>
mpm::Boundaries<D> make_boundaries(const scene::Scene& scene, const Ground& ground) {
    mpm::Boundaries<D> boundaries;
    boundaries.walls = make_walls<D>(scene.domain);
    if (scene.has("shelf")) {
        boundaries.shelf = {.end = scene.shelf.length,
                            .top = scene.shelf.height,
                            .rule = make_rule(scene, scene.shelf.ground),
                            .retreat = scene.shelf.retreat};
        boundaries.shelf.rule.holds_down = scene.shelf.holds_down;
        boundaries.drag.shelf = make_drag(scene.shelf.ground);
    }
    if (scene.has("bed")) {
        boundaries.bed = make_bed<D>(scene, ground);
        boundaries.drag.bed = make_drag(scene.bed.ground);
    }
    if (scene.has("push")) boundaries.push = {scene.push.speed, scene.push.ramp};
    if (scene.has("piston")) boundaries.piston = make_piston(scene);
    if (scene.has("sponge")) boundaries.sponge = make_sponge(scene);
    if (scene.has("outlet")) boundaries.outlet = make_outlet(scene);
    return boundaries;
}

// In the order of the scene.
template <int D>
std::vector<mpm::RigidStart<D>> make_blocks(const scene::Scene& scene) {
    std::vector<mpm::RigidStart<D>> blocks;
    if (!scene.has("rigid")) return blocks;
    using Vec = Eigen::Map<const Vector<D, double>>;
    constexpr double radians = std::numbers::pi / 180.0;
    for (const scene::Block& block : scene.blocks) {
        blocks.push_back({.size = Vec(block.size.data()),
                          .center = Vec(block.center.data()),
                          .angle = radians * block.angle,
                          .density = block.density,
                          .contact = block.contact,
                          .friction = block.friction,
                          .drag = block.drag,
                          .velocity = Vec(block.velocity.data()),
                          .spin = radians * block.spin});
    }
    return blocks;
}

void check_made_for(const scene::Scene& scene, const openvdb::FloatGrid& grid,
                    const std::filesystem::path& file) {
    const std::string part = stage_part(scene, scene::Stage::geometry);
    if (geometry::marked_scene(grid) != hash_hex(hash_text(part))) {
        throw InputError(file.string() +
                         ": made for another scene or other settings; run tidewater-geometry again");
    }
}

// So that a wave's surface is no staircase of lattice rows, the lattice of the still water is put where the
// wave displaces it to: a lattice cut off at the surface starts up to 9 mm off a wave of 5 cm with cells of 4
// cm, this one by less than 0.05 mm. Its columns end at the right wall: their spacing differs from the
// lattice's by less than half a column in all of them.
void displace_lattice(const analysis::InitialWave& wave, double length, geometry::Seeding& seeding) {
    const double added = analysis::elevated_area(wave, length) / wave.depth;
    const double columns = (length + added) * seeding.per_axis / seeding.cell_size;
    const double stretch = columns / std::max(std::round(columns), 1.0);
    seeding.margin = std::abs(added) + wave.height;
    seeding.place = [wave, stretch](const geometry::Point& still) {
        const auto [x, z] = analysis::displace(wave, still[0] * stretch, still[2]);
        return geometry::Point(x, still[1], z);
    };
}

// The wave's velocity and pressure at each point.
template <int D>
void start_wave(const analysis::InitialWave& wave, typename mpm::Start<D>::Body& water) {
    for (const auto& point : water.points) {
        const auto flow = analysis::wave_flow(wave, point[0], point[D - 1]);
        Vector<D, double> velocity = Vector<D, double>::Zero();
        Matrix<D, double> gradient = Matrix<D, double>::Zero();
        velocity[0] = flow.u;
        velocity[D - 1] = flow.w;
        gradient(0, 0) = flow.u_x;
        gradient(D - 1, D - 1) = -flow.u_x;
        gradient(0, D - 1) = gradient(D - 1, 0) = flow.u_z;
        water.velocity.push_back(velocity);
        water.gradient.push_back(gradient);
        water.head.push_back(flow.head);
    }
}

}  // namespace

template <int D>
mpm::Start<D> make_start(const scene::Scene& scene, const std::filesystem::path& file) {
    mpm::Start<D> start;
    start.cell_size = scene.domain.cell_size;
    if (!std::filesystem::exists(file))
        throw InputError(file.string() + ": missing; run tidewater-geometry first");
    for (std::size_t axis = 0; axis < D; ++axis) {
        start.cells[axis] = static_cast<int>(std::lround(scene.domain.size[axis] / scene.domain.cell_size));
    }
    start.parameters = {.gravity = scene.domain.gravity,
                        .cfl = scene.simulate.cfl,
                        .water = scene.water.model,
                        .ice = ice_model(scene),
                        .boundaries = make_boundaries<D>(scene, read_ground(scene, file)),
                        .transfer = scene.simulate.transfer};
    start.rigid = make_blocks<D>(scene);
    std::size_t count = 0;
    const auto grids = io::read_level_sets(file);
    const Cuts cuts = read_cuts(scene, grids, file);
    for (const auto& grid : grids) {
        check_made_for(scene, *grid, file);
        if (!geometry::is_body(*grid) || geometry::body_material(*grid) == Material::rigid) continue;
        auto& body = start.bodies.emplace_back();
        body.material = geometry::body_material(*grid);
        body.volume = geometry::body_volume(*grid);
        const bool water = body.material == Material::water;
        body.mass = body.volume * (water ? scene.water.model.density : scene.ice.model.density);
        body.surface = scene.water.depth;
        geometry::Seeding seeding{.cell_size = scene.domain.cell_size,
                                  .per_axis = scene.particles.per_axis,
                                  .jitter = scene.particles.jitter,
                                  .seed = scene.seed,
                                  .stream = start.bodies.size()};
        if (scene.particles.pattern == scene::Pattern::blue_noise)
            seeding.pattern = geometry::SeedPattern::blue_noise;
        if (body.material == Material::ice) seeding.keep = cuts.keep();
        const bool wave = scene.has("wave") && water;
        if (wave) displace_lattice(initial_wave(scene), scene.domain.size.front(), seeding);
        body.points = geometry::seed_points<D>(*grid, seeding);
        if (body.material == Material::ice && cuts.cracks) crack<D>(*cuts.cracks, scene, body);
        if (wave) start_wave<D>(initial_wave(scene), body);
        count += body.points.size();
    }
    if (count == 0 && start.rigid.empty())
        throw SceneError("the scene has no particles: its bodies are empty; see water.*, ice.* and block.*");
    return start;
}

template <int D>
std::string start_fingerprint(const mpm::Start<D>& start) {
    std::uint64_t hash = hash_start;
    for (const auto& body : start.bodies) {
        const std::array numbers{static_cast<double>(body.material), body.mass, body.volume, body.surface};
        hash = hash_bytes(std::as_bytes(std::span(numbers)), hash);
        hash = hash_bytes(std::as_bytes(std::span(body.points)), hash);
        hash = hash_bytes(std::as_bytes(std::span(body.velocity)), hash);
        hash = hash_bytes(std::as_bytes(std::span(body.head)), hash);
        hash = hash_bytes(std::as_bytes(std::span(body.strength)), hash);
    }
    for (const auto& body : start.rigid) {
        const std::array numbers{body.angle,    body.density, static_cast<double>(body.contact),
                                 body.friction, body.drag,    body.spin};
        hash = hash_bytes(std::as_bytes(std::span(numbers)), hash);
        for (const auto* vector : {&body.size, &body.center, &body.velocity}) {
            hash = hash_bytes(std::as_bytes(std::span(vector->data(), static_cast<std::size_t>(D))), hash);
        }
    }
    return hash_hex(hash);
}

template mpm::Start<2> make_start<2>(const scene::Scene&, const std::filesystem::path&);
template mpm::Start<3> make_start<3>(const scene::Scene&, const std::filesystem::path&);
template std::string start_fingerprint(const mpm::Start<2>&);
template std::string start_fingerprint(const mpm::Start<3>&);

}  // namespace tidewater
