#include "pictures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <string>

#include "common/tank.h"
#include "core/error.h"
#include "core/types.h"
#include "io/axis.h"
#include "io/movie.h"
#include "io/picture.h"
#include "io/rasterise.h"
#include "io/slides.h"
#include "io/table.h"
#include "io/text.h"
#include "particles.h"

namespace tidewater::postprocess {
namespace {

constexpr std::size_t default_picture_count = 5;

// The colour scale ends where this share of the water is slower, so that single drops do not darken all else.
constexpr double speed_quantile = 0.995;

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

io::PictureSettings picture_settings(const scene::Scene& scene, const Ground& ground, double greatest_speed) {
    io::PictureSettings settings{.dimension = scene.dimension,
                                 .low = {},
                                 .high = make_tank(scene).size,
                                 .particle_spacing = scene::particle_spacing(scene),
                                 .still_level = scene.water.depth,
                                 .greatest_speed = greatest_speed,
                                 .title = scene.title,
                                 .gauges = {},
                                 .ground_x = {},
                                 .ground_z = {},
                                 .width = scene.postprocess.picture_width};
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

// The upper end of the colour scale, m/s.
double speed_scale(const StageContext& context, const std::vector<std::size_t>& chosen) {
    if (context.scene.postprocess.picture_speed > 0.0) return context.scene.postprocess.picture_speed;
    double fastest = 0.0;
    for (const std::size_t frame : chosen) {
        const auto path = context.folder / frame_file("speed", frame);
        fastest = std::max(fastest, io::require_column(io::read_table(path), "fast_water", path).at(0));
    }
    return fastest > 0.0 ? io::round_up(fastest) : 1.0;
}

std::string picture_name(double time, int decimals, const char* ending) {
    return "frame_t=" + io::format_fixed(time, decimals) + ending;
}

std::vector<std::filesystem::path> picture_paths(const StageContext& context, const Frames& frames,
                                                 const std::vector<std::size_t>& chosen) {
    const int decimals = time_decimals(frames.times);
    std::vector<std::filesystem::path> paths;
    for (const std::size_t frame : chosen)
        paths.push_back(context.folder / picture_name(frames.times[frame], decimals, ".png"));
    return paths;
}

// The keys that a picture shows, and the scale of its colours.
std::string picture_depends_on(const scene::Scene& scene, const io::PictureSettings& settings) {
    constexpr std::array<std::string_view, 7> keys{"title",
                                                   "simulate.gauges",
                                                   "postprocess.gauges",
                                                   "postprocess.picture_width",
                                                   "postprocess.picture_window",
                                                   "postprocess.picture_speed",
                                                   "postprocess.picture_ice"};
    return scene::values_of(scene, keys) + io::format_number(settings.greatest_speed);
}

// Of each particle, 0 of the glacier and of what is in no iceberg; empty if none were looked for.
std::vector<std::uint32_t> iceberg_numbers(const std::filesystem::path& folder, std::size_t frame,
                                           const io::Snapshot& snapshot) {
    std::vector<std::uint32_t> numbers;
    for (const std::int32_t iceberg : icebergs_of(folder, frame, snapshot))
        numbers.push_back(static_cast<std::uint32_t>(std::max(iceberg, 0)));
    return numbers;
}

FrameProduct picture_product(const StageContext& context, const Frames& frames,
                             const std::vector<std::size_t>& chosen, const io::PictureSettings& settings,
                             const FrameProduct& icebergs) {
    const int decimals = time_decimals(frames.times);
    const bool by_iceberg = context.scene.postprocess.picture_ice == scene::IceColors::iceberg;
    const auto name = [=, &frames](std::size_t frame, const char* ending) {
        return picture_name(frames.times[frame], decimals, ending);
    };
    return {.name = "picture",
            .settings = picture_depends_on(context.scene, settings) + (by_iceberg ? icebergs.settings : ""),
            .files =
                [=, &chosen](std::size_t frame) {
                    const bool drawn = std::ranges::binary_search(chosen, frame);
                    if (!drawn) return std::vector<std::string>{};
                    return std::vector{name(frame, ".png"), name(frame, ".svg")};
                },
            .make =
                [=, folder = context.folder](std::size_t frame, const io::Snapshot& snapshot,
                                             const Provenance& provenance) {
                    io::PictureSettings of_frame = settings;
                    of_frame.time = snapshot.time;
                    std::vector<std::uint32_t> numbers;
                    if (by_iceberg) numbers = iceberg_numbers(folder, frame, snapshot);
                    const io::Drawing picture = io::draw_picture(
                        {snapshot.points, snapshot.velocity, snapshot.material, snapshot.damage, numbers},
                        of_frame);
                    io::write_svg_and_png(folder / name(frame, ".svg"), picture.svg(provenance), 1.0,
                                          provenance);
                },
            .follows = false};
}

}  // namespace

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

FrameProduct speed_product(const StageContext& context, const std::vector<std::size_t>& chosen) {
    const bool needed = context.scene.postprocess.picture_speed == 0.0;
    return {.name = "speed",
            .settings = {},
            .files =
                [needed, chosen](std::size_t frame) {
                    const bool drawn = needed && std::ranges::binary_search(chosen, frame);
                    return drawn ? std::vector{frame_file("speed", frame)} : std::vector<std::string>{};
                },
            .make =
                [folder = context.folder](std::size_t frame, const io::Snapshot& snapshot,
                                          const Provenance& provenance) {
                    io::TableWriter table(folder / frame_file("speed", frame), provenance,
                                          {"time", "fast_water"});
                    table.append(std::array{snapshot.time, fast_water(snapshot)});
                    table.finish();
                },
            .follows = false};
}

void make_pictures(const StageContext& context, const Frames& frames, const std::vector<std::size_t>& chosen,
                   const Ground& ground, const FrameProduct& icebergs, Stamps& stamps) {
    const io::PictureSettings settings =
        picture_settings(context.scene, ground, speed_scale(context, chosen));
    const std::array products{picture_product(context, frames, chosen, settings, icebergs)};
    make_frame_products(context, frames, products, "pictures", stamps);
    std::vector<io::Slide> slides;
    const auto paths = picture_paths(context, frames, chosen);
    for (std::size_t i = 0; i < chosen.size(); ++i) slides.push_back({frames.times[chosen[i]], paths[i]});
    io::write_slides(context.folder / "frames.html", context.scene.title, slides, context.provenance);
}

void make_movie(const StageContext& context, const Frames& frames) {
    const auto ffmpeg = io::find_on_path("ffmpeg");
    if (!ffmpeg) {
        std::puts(
            "no frames.mp4: ffmpeg is not there; install it (Debian: apt-get install ffmpeg) and run again");
        return;
    }
    const auto chosen = choose_pictures(frames.times, context.scene);
    if (chosen.size() < 2) {
        std::puts("no frames.mp4: one picture makes no movie; set postprocess.picture_interval");
        return;
    }
    std::vector<double> times;
    for (const std::size_t frame : chosen) times.push_back(frames.times[frame]);
    io::write_movie(*ffmpeg, picture_paths(context, frames, chosen), io::movie_rate(times),
                    context.folder / "frames.mp4");
}

}  // namespace tidewater::postprocess
