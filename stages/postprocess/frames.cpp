#include "frames.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "analysis/surface.h"
#include "common/tank.h"
#include "core/error.h"
#include "core/progress.h"
#include "core/types.h"
#include "io/axis.h"
#include "io/collection.h"
#include "io/picture.h"
#include "io/slides.h"
#include "io/snapshot.h"
#include "io/text.h"

namespace tidewater::postprocess {
namespace {

constexpr std::size_t default_picture_count = 5;

// The colour scale ends where this share of the water is slower, so that single drops do not darken all else.
constexpr double speed_quantile = 0.995;

io::Snapshot read_frame(const std::filesystem::path& file, const scene::Scene& scene) {
    io::Snapshot snapshot = io::read_snapshot(file);
    if (snapshot.dimension != scene.dimension) {
        throw InputError(file.string() + ": it has " + std::to_string(snapshot.dimension) +
                         " dimensions, the scene " + std::to_string(scene.dimension) +
                         "; run tidewater-simulate again");
    }
    return snapshot;
}

std::vector<double> read_gauges(const io::Snapshot& snapshot, const scene::Scene& scene,
                                const Ground& ground) {
    const analysis::Tank tank = make_tank(scene);
    return analysis::surface_elevation({snapshot.points, snapshot.volume, snapshot.material}, tank,
                                       gauge_places(scene.postprocess.gauges, scene, ground));
}

double fast_water(const io::Snapshot& snapshot) {
    std::vector<double> speeds;
    for (std::size_t p = 0; p < snapshot.particle_count(); ++p) {
        const float* v = snapshot.velocity.data() + 3 * p;
        if (static_cast<Material>(snapshot.material[p]) == Material::water) {
            speeds.push_back(std::hypot(v[0], v[1], v[2]));
        }
    }
    if (speeds.empty()) return 0.0;
    const auto index = static_cast<std::ptrdiff_t>(speed_quantile * static_cast<double>(speeds.size() - 1));
    std::ranges::nth_element(speeds, speeds.begin() + index);
    return speeds[static_cast<std::size_t>(index)];
}

// The ground's outline at mid-width: the corners of straight lines, else its height at every node line.
void add_ground(const scene::Scene& scene, const Ground& ground, io::PictureSettings& settings) {
    if (!ground.exists()) return;
    if (ground.profile && !ground.profile->smooth) {
        settings.ground_x = ground.profile->x;
        settings.ground_z = ground.profile->z;
        return;
    }
    const auto size = make_tank(scene).size;
    const auto lines = static_cast<int>(std::lround(size[0] / scene.domain.cell_size));
    for (int n = 0; n <= lines; ++n) {
        settings.ground_x.push_back(n * scene.domain.cell_size);
        settings.ground_z.push_back(ground.height(settings.ground_x.back(), 0.5 * size[1]));
    }
}

io::PictureSettings picture_settings(const scene::Scene& scene, const Ground& ground, double fastest) {
    io::PictureSettings settings{.dimension = scene.dimension,
                                 .low = {},
                                 .high = make_tank(scene).size,
                                 .particle_spacing = scene.domain.cell_size / scene.particles.per_axis,
                                 .still_level = scene.water.depth,
                                 .greatest_speed = scene.postprocess.picture_speed,
                                 .title = scene.title,
                                 .gauges = {},
                                 .ground_x = {},
                                 .ground_z = {},
                                 .width = scene.postprocess.picture_width};
    if (settings.greatest_speed == 0.0) settings.greatest_speed = fastest > 0.0 ? io::round_up(fastest) : 1.0;
    for (const auto* gauges : {&scene.simulate.gauges, &scene.postprocess.gauges}) {
        for (const auto& place : gauge_places(*gauges, scene, ground))
            settings.gauges.push_back({place.x, place.y});
    }
    if (const auto& window = scene.postprocess.picture_window; !window.empty()) {
        settings.low = {window[0], 0.0, window[1]};
        settings.high = {window[2], 0.0, window[3]};
    }
    add_ground(scene, ground, settings);
    return settings;
}

// As few decimals, but at least two, as tell the times apart.
int time_decimals(const std::vector<double>& times) {
    for (int decimals = 2; decimals < 9; ++decimals) {
        const auto same = [&](double a, double b) {
            return io::format_fixed(a, decimals) == io::format_fixed(b, decimals);
        };
        if (std::ranges::adjacent_find(times, same) == times.end()) return decimals;
    }
    return 9;
}

void draw_pictures(const StageContext& context, const Frames& frames, const std::vector<std::size_t>& chosen,
                   const Ground& ground, double fastest, Progress& progress) {
    io::PictureSettings settings = picture_settings(context.scene, ground, fastest);
    const int decimals = time_decimals(frames.times);
    std::vector<io::Slide> slides;
    for (const std::size_t frame : chosen) {
        const io::Snapshot snapshot = read_frame(frames.files[frame], context.scene);
        settings.time = snapshot.time;
        const io::Canvas canvas = io::draw_picture(
            {snapshot.points, snapshot.velocity, snapshot.material, snapshot.damage}, settings);
        const std::string name = "frame_t=" + io::format_fixed(snapshot.time, decimals) + ".png";
        slides.push_back({snapshot.time, context.folder / name});
        canvas.write_png(slides.back().picture, context.provenance);
        progress.update(0.99, name);
    }
    io::write_slides(context.folder / "frames.html", context.scene.title, slides, context.provenance);
}

}  // namespace

Frames find_frames(const std::filesystem::path& folder) {
    Frames frames{io::list_snapshots(folder), {}};
    for (const auto& file : frames.files) frames.times.push_back(io::read_snapshot_time(file));
    return frames;
}

std::vector<std::size_t> choose_frames(const std::vector<double>& times, const std::vector<double>& wanted,
                                       std::size_t count) {
    std::vector<std::size_t> chosen;
    if (times.empty()) return chosen;
    for (const double time : wanted) {
        const auto nearer = [&](double a, double b) { return std::abs(a - time) < std::abs(b - time); };
        chosen.push_back(static_cast<std::size_t>(std::ranges::min_element(times, nearer) - times.begin()));
    }
    for (std::size_t i = 0; wanted.empty() && i < count; ++i) {
        chosen.push_back(count > 1 ? i * (times.size() - 1) / (count - 1) : 0);
    }
    std::ranges::sort(chosen);
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    return chosen;
}

std::vector<std::size_t> choose_pictures(const std::vector<double>& times, const scene::Scene& scene) {
    const double interval = scene.postprocess.picture_interval;
    std::vector<double> wanted = scene.postprocess.picture_times;
    if (interval > 0.0 && !times.empty()) {
        wanted.clear();
        const double end = times.back() + 0.5 * interval;
        for (int i = 0; i * interval < end && wanted.size() < times.size(); ++i)
            wanted.push_back(i * interval);
    }
    return choose_frames(times, wanted, default_picture_count);
}

void check_picture_window(const scene::Scene& scene) {
    const auto& window = scene.postprocess.picture_window;
    if (window.empty()) return;
    const std::string key = "postprocess.picture_window: ";
    if (scene.dimension == 3) throw SceneError(key + "there is none in 3D; leave it out");
    const auto high = make_tank(scene).size;
    const bool in_order = window.size() == 4 && window[0] < window[2] && window[1] < window[3] &&
                          window[2] <= high[0] && window[3] <= high[2];
    if (!in_order) {
        throw SceneError(key + "needs x0, z0, x1, z1 of a part of the tank, as [0, 0, " +
                         io::format_number(high[0]) + ", " + io::format_number(high[2]) + "]");
    }
}

FromFrames process_frames(const StageContext& context, const Frames& frames) {
    const scene::Scene& scene = context.scene;
    const auto chosen = choose_pictures(frames.times, scene);
    const Ground ground = read_ground(scene, geometry_file(context));
    FromFrames read{{}, start_profiles(scene)};
    for (const auto& gauge : scene.postprocess.gauges)
        read.gauges.push_back({gauge_name(gauge), "snapshots", frames.times, {}});
    std::vector<io::CollectionEntry> collection;
    double fastest = 0.0;

    Progress progress("postprocess");
    for (std::size_t frame = 0; frame < frames.files.size(); ++frame) {
        const io::Snapshot snapshot = read_frame(frames.files[frame], scene);
        collection.push_back({io::particles_name(frame), snapshot.time});
        io::write_particles(context.folder / collection.back().name, snapshot, context.provenance);
        const auto elevations = read_gauges(snapshot, scene, ground);
        for (std::size_t i = 0; i < read.gauges.size(); ++i)
            read.gauges[i].elevation.push_back(elevations[i]);
        append_profile(snapshot, scene, ground, read.profiles);
        if (std::ranges::binary_search(chosen, frame)) fastest = std::max(fastest, fast_water(snapshot));
        progress.update(0.95 * static_cast<double>(frame + 1) / static_cast<double>(frames.files.size()),
                        "t = " + io::format_fixed(snapshot.time, 2) + " s");
    }
    io::write_collection(context.folder / "particles.pvd", collection, context.provenance);
    draw_pictures(context, frames, chosen, ground, fastest, progress);
    progress.update(1.0);
    return read;
}

}  // namespace tidewater::postprocess
