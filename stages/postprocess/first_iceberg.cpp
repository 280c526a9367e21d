#include "first_iceberg.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string_view>
#include <vector>

#include "analysis/box.h"
#include "analysis/failure_surface.h"
#include "analysis/iceberg_track.h"
#include "ice_pieces.h"
#include "iceberg_frames.h"
#include "io/snapshot.h"
#include "io/table.h"

namespace tidewater::postprocess {
namespace {

// The ice of the first frame in the order of ids, with the failure times of the last.
struct Ice {
    std::vector<std::uint32_t> id;
    std::vector<float> points, volume, failure_time;

    analysis::IceAtRest at_rest() const { return {points, volume, failure_time}; }
};

// By particle id, whether it is in an iceberg from the start, beside a glacier.
std::vector<bool> apart_from_glacier(const io::Members& first) {
    std::vector<bool> apart;
    if (!std::ranges::count(first.iceberg, analysis::glacier_id)) return apart;
    if (!first.particle.empty()) apart.resize(std::size_t{first.particle.back()} + 1, false);
    for (std::size_t i = 0; i < first.particle.size(); ++i)
        apart[first.particle[i]] = first.iceberg[i] != analysis::glacier_id;
    return apart;
}

// Without what floats apart from the start.
Ice read_ice(const io::Snapshot& first, const io::Members& members) {
    const std::vector<bool> apart = apart_from_glacier(members);
    std::vector<std::uint32_t> places;
    const auto ids = particle_ids(first, places);
    std::vector<std::uint32_t> order = ice_by_id(first, ids);
    std::erase_if(order, [&](std::uint32_t p) { return ids[p] < apart.size() && apart[ids[p]]; });
    Ice ice;
    ice.id.reserve(order.size());
    ice.volume.reserve(order.size());
    ice.points.reserve(3 * order.size());
    for (const std::uint32_t p : order) {
        ice.id.push_back(ids[p]);
        ice.volume.push_back(first.volume[p]);
        ice.points.insert(ice.points.end(), &first.points[3 * p], &first.points[3 * p] + 3);
    }
    return ice;
}

void add_failure_times(const io::Snapshot& last, Ice& ice) {
    if (last.failure_time.empty()) return;
    ice.failure_time.assign(ice.id.size(), std::numeric_limits<float>::quiet_NaN());
    std::vector<std::uint32_t> places;
    const auto ids = particle_ids(last, places);
    for (std::size_t p = 0; p < last.particle_count(); ++p) {
        if (!is_ice(last, p)) continue;
        const auto at = std::ranges::lower_bound(ice.id, ids[p]);
        if (at != ice.id.end() && *at == ids[p])
            ice.failure_time[static_cast<std::size_t>(at - ice.id.begin())] = last.failure_time[p];
    }
}

double failed_share(const Ice& ice) {
    double failed = 0.0, all = 0.0;
    for (std::size_t p = 0; p < ice.volume.size(); ++p) {
        all += ice.volume[p];
        if (!std::isnan(ice.failure_time[p])) failed += ice.volume[p];
    }
    return failed / all;
}

analysis::CalvingSettings calving_settings(const scene::Scene& scene) {
    return {.dimension = scene.dimension,
            .spacing = particle_spacing(scene),
            .reach = scene.postprocess.iceberg_reach,
            .smallest_share = scene.postprocess.iceberg_share};
}

FirstIceberg find_first(const Ice& ice, double end_time, const scene::Scene& scene) {
    const analysis::CalvingSettings settings = calving_settings(scene);
    FirstIceberg first;
    first.end_time = end_time;
    if (ice.volume.empty()) return first;
    const auto crack =
        analysis::first_crack(ice.at_rest(), {.spacing = settings.spacing, .reach = settings.reach});
    first.crack = crack.value_or(first.crack);
    first.calving = analysis::first_detachment(ice.at_rest(), settings).value_or(analysis::Calving{});
    first.failed_share = failed_share(ice);
    first.ice_height = analysis::bounds(ice.points).height() + settings.spacing;
    return first;
}

// What came off the glacier in a frame.
struct Detached {
    std::size_t frame = 0;
    double volume = 0.0, largest_volume = 0.0;
    std::vector<std::uint32_t> icebergs;  // the largest first
};

Detached read_detached(const std::filesystem::path& folder, std::size_t frame) {
    const auto path = folder / frame_file("iceberg_events", frame);
    const io::Table table = io::read_table(path);
    const auto &kind = io::require_column(table, "kind", path),
               &iceberg = io::require_column(table, "iceberg", path),
               &other = io::require_column(table, "other", path),
               &volume = io::require_column(table, "volume", path);
    Detached detached;
    detached.frame = frame;
    for (std::size_t r = 0; r < kind.size(); ++r) {
        const bool split = kind[r] == static_cast<double>(analysis::IcebergEvent::Kind::split);
        if (!split || other[r] != analysis::glacier_id) continue;
        detached.volume += volume[r];
        detached.icebergs.push_back(static_cast<std::uint32_t>(iceberg[r]));
        if (volume[r] <= detached.largest_volume) continue;
        detached.largest_volume = volume[r];
        std::swap(detached.icebergs.front(), detached.icebergs.back());
    }
    return detached;
}

MainEvent find_main_event(const Ice& ice, const Frames& frames, const StageContext& context) {
    Detached main;
    for (std::size_t frame = 1; frame < frames.files.size(); ++frame) {
        Detached detached = read_detached(context.folder, frame);
        if (detached.volume > main.volume) main = std::move(detached);
    }
    if (main.icebergs.empty()) return {};
    const io::Members members = read_members(context.folder, main.frame);
    std::vector<std::uint8_t> came_off(members.given, 0);
    for (const std::uint32_t iceberg : main.icebergs) came_off[iceberg] = 1;
    std::vector<analysis::Side> sides(ice.id.size(), analysis::Side::neither);
    for (std::size_t i = 0, p = 0; i < members.particle.size(); ++i) {
        while (p < ice.id.size() && ice.id[p] < members.particle[i]) ++p;
        if (p == ice.id.size()) break;
        if (ice.id[p] != members.particle[i]) continue;
        if (came_off[members.iceberg[i]]) sides[p] = analysis::Side::iceberg;
        if (members.iceberg[i] == analysis::glacier_id) sides[p] = analysis::Side::rear;
    }
    return {.frame = static_cast<double>(main.frame),
            .time_before = frames.times[main.frame - 1],
            .icebergs = static_cast<double>(main.icebergs.size()),
            .largest = static_cast<double>(main.icebergs.front()),
            .calving = analysis::measure_calving(ice.at_rest(), sides, frames.times[main.frame],
                                                 calving_settings(context.scene))};
}

}  // namespace

FrameProduct first_iceberg_product(const StageContext& context, const Frames& frames) {
    constexpr std::array<std::string_view, 4> keys{"postprocess.iceberg_damage", "postprocess.iceberg_reach",
                                                   "postprocess.iceberg_volume", "postprocess.iceberg_share"};
    const bool breaks = context.scene.has("fracture");
    return {
        .name = "first_iceberg",
        .settings = scene::values_of(context.scene, keys),
        .files =
            [&frames, breaks, any = context.scene.has("ice")](std::size_t frame) {
                std::vector<std::string> names;
                if (!any || frame + 1 != frames.files.size()) return names;
                if (breaks) names.push_back(first_iceberg_file);
                names.push_back(main_event_file);
                return names;
            },
        .make =
            [&context, &frames, breaks](std::size_t, const io::Snapshot& last, const Provenance& provenance) {
                const scene::Scene& scene = context.scene;
                Ice ice = read_ice(read_frame(frames, 0, scene), read_members(context.folder, 0));
                add_failure_times(last, ice);
                const double density = scene.ice.model.density;
                if (breaks && !ice.failure_time.empty()) {
                    write_first_iceberg(context.folder, find_first(ice, last.time, scene), density,
                                        provenance);
                }
                write_main_event(context.folder, find_main_event(ice, frames, context), density, provenance);
            },
        .follows = true};
}

}  // namespace tidewater::postprocess
