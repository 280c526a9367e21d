#include "surface.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <utility>

#include "analysis/surface_field.h"
#include "common/tank.h"
#include "wave_source.h"

namespace tidewater::postprocess {
namespace {

constexpr double cells_of_open_water = 2.0;

std::string surface_path(std::size_t frame) { return frame_file("surface", frame, "h5"); }

std::vector<float> bed_of(const Ground& ground, const analysis::Lattice& lattice) {
    std::vector<float> bed;
    for (int j = 0; j < lattice.across; ++j) {
        for (int i = 0; i < lattice.along; ++i)
            bed.push_back(static_cast<float>(ground.height(lattice.x(i), lattice.y(j))));
    }
    return bed;
}

// The rows beside the middle; twice the same if their number is odd.
std::pair<std::size_t, std::size_t> middle_rows(const io::Surface& surface) {
    const std::size_t across = surface.y.size();
    return {(across - 1) / 2, across / 2};
}

template <class Value>
std::span<const Value> row_of(const std::vector<Value>& values, const io::Surface& surface, std::size_t row) {
    return std::span(values).subspan(row * surface.x.size(), surface.x.size());
}

FarEnd look_at_far_end(const io::Surface& surface, const scene::Scene& scene) {
    const analysis::Shore shore{.to_the_right = main_wave_path(scene, analysis::none).to_the_right(),
                                .still_level = surface.still_level,
                                .depth_of_open_water = cells_of_open_water * scene.domain.cell_size};
    FarEnd highest{.time = surface.time, .y = surface.y.front(), .waterline = {}};
    for (std::size_t row = 0; row < surface.y.size(); ++row) {
        const auto bed = row_of(surface.bed, surface, row), eta = row_of(surface.elevation, surface, row);
        const analysis::Waterline line =
            analysis::find_waterline(surface.x, std::vector<double>(bed.begin(), bed.end()),
                                     std::vector<double>(eta.begin(), eta.end()), shore);
        if (std::isnan(line.height) || line.height <= highest.waterline.height) continue;
        highest.y = surface.y[row];
        highest.waterline = line;
    }
    return highest;
}

// Where the water begins along the middle, to the right of ice or land.
double front_of(const io::Surface& surface) {
    const std::vector<double> line = middle_line(surface);
    const auto wet = std::ranges::find_if(line, [](double eta) { return !std::isnan(eta); });
    if (wet == line.begin() || wet == line.end()) return analysis::none;
    const auto i = static_cast<std::size_t>(wet - line.begin());
    return 0.5 * (surface.x[i - 1] + surface.x[i]);
}

}  // namespace

bool makes_first_wave(const scene::Scene& scene) {
    return scene.has("rigid") && scene.has("water") && scene.domain.gravity > 0.0;
}

FrameProduct surface_product(const StageContext& context, const Ground& ground) {
    const scene::Scene& scene = context.scene;
    const analysis::Tank tank = make_tank(scene);
    const analysis::Lattice lattice = analysis::cell_lattice(tank);
    io::Surface empty{
        .time = 0.0, .still_level = tank.still_level, .x = {}, .y = {}, .bed = {}, .elevation = {}};
    for (int i = 0; i < lattice.along; ++i) empty.x.push_back(lattice.x(i));
    for (int j = 0; j < lattice.across; ++j) empty.y.push_back(tank.dimension == 3 ? lattice.y(j) : 0.0);
    const bool any = scene.has("water");
    if (any) empty.bed = bed_of(ground, lattice);
    return {.name = "surface",
            .settings = {},
            .files =
                [any](std::size_t frame) {
                    return any ? std::vector{surface_path(frame)} : std::vector<std::string>{};
                },
            .make =
                [empty, tank, folder = context.folder](std::size_t frame, const io::Snapshot& snapshot,
                                                       const Provenance& provenance) {
                    io::Surface surface = empty;
                    surface.time = snapshot.time;
                    surface.elevation = analysis::surface_field(
                        {snapshot.points, snapshot.volume, snapshot.material}, tank, empty.bed);
                    io::write_surface(folder / surface_path(frame), surface, provenance);
                },
            .follows = false};
}

std::vector<double> middle_line(const io::Surface& surface) {
    const auto [first, second] = middle_rows(surface);
    const auto a = row_of(surface.elevation, surface, first), b = row_of(surface.elevation, surface, second);
    std::vector<double> line;
    for (std::size_t i = 0; i < a.size(); ++i)
        line.push_back(0.5 * (static_cast<double>(a[i]) + static_cast<double>(b[i])));
    return line;
}

Surfaces gather_surfaces(const StageContext& context, const Frames& frames) {
    Surfaces gathered;
    if (!context.scene.has("water")) return gathered;
    for (std::size_t frame = 0; frame < frames.times.size(); ++frame) {
        const io::Surface surface = io::read_surface(context.folder / surface_path(frame));
        if (frame == 0) {
            gathered.profiles.x = surface.x;
            const auto bed = row_of(surface.bed, surface, middle_rows(surface).first);
            gathered.profiles.bed.assign(bed.begin(), bed.end());
            gathered.front = front_of(surface);
        }
        gathered.profiles.of_time.push_back({surface.time, middle_line(surface)});
        gathered.far_end.push_back(look_at_far_end(surface, context.scene));
    }
    return gathered;
}

}  // namespace tidewater::postprocess
