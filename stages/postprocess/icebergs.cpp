#include "icebergs.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_map>

#include "analysis/box.h"
#include "analysis/fragments.h"
#include "core/types.h"
#include "io/snapshot.h"
#include "io/table.h"
#include "io/text.h"

namespace tidewater::postprocess {
namespace {

constexpr float never = std::numeric_limits<float>::quiet_NaN();

bool is_ice(const io::Snapshot& snapshot, std::size_t p) {
    return static_cast<Material>(snapshot.material[p]) == Material::ice;
}

double particle_spacing(const scene::Scene& scene) {
    return scene.domain.cell_size / scene.particles.per_axis;
}

// The ice of the first frame in the order of ids, with the failure times of the last.
struct Ice {
    std::vector<float> points, volume, failure_time;
};

Ice match(const io::Snapshot& first, const io::Snapshot& last) {
    std::vector<std::size_t> order;
    for (std::size_t p = 0; p < first.particle_count(); ++p) {
        if (is_ice(first, p)) order.push_back(p);
    }
    std::ranges::sort(order, {}, [&](std::size_t p) { return first.id[p]; });
    std::unordered_map<std::uint32_t, float> failure_time;
    for (std::size_t p = 0; p < last.particle_count(); ++p) {
        if (is_ice(last, p)) failure_time[last.id[p]] = last.failure_time[p];
    }
    Ice ice;
    for (const std::size_t p : order) {
        ice.points.insert(ice.points.end(), &first.points[3 * p], &first.points[3 * p] + 3);
        ice.volume.push_back(first.volume[p]);
        const auto found = failure_time.find(first.id[p]);
        ice.failure_time.push_back(found == failure_time.end() ? never : found->second);
    }
    return ice;
}

double failed_share(const Ice& ice) {
    double failed = 0.0, all = 0.0;
    for (std::size_t p = 0; p < ice.volume.size(); ++p) {
        all += ice.volume[p];
        if (!std::isnan(ice.failure_time[p])) failed += ice.volume[p];
    }
    return failed / all;
}

// Ice counts as intact if it has not failed and kept more of its strength than iceberg_damage takes.
std::vector<Fragment> find_fragments(const io::Snapshot& frame, double reach, double greatest_damage,
                                     double smallest) {
    std::vector<std::uint8_t> intact;
    for (std::size_t p = 0; p < frame.particle_count(); ++p) {
        const bool damaged = !frame.damage.empty() && frame.damage[p] >= greatest_damage;
        intact.push_back(is_ice(frame, p) && std::isnan(frame.failure_time[p]) && !damaged);
    }
    const auto labels = analysis::label_fragments(frame.points, intact, reach);
    std::vector<Fragment> fragments(labels.size.size());
    constexpr double far = std::numeric_limits<double>::infinity();
    for (Fragment& fragment : fragments) {
        fragment.low.fill(far);
        fragment.high.fill(-far);
    }
    for (std::size_t p = 0; p < frame.particle_count(); ++p) {
        if (!intact[p]) continue;
        Fragment& fragment = fragments[labels.label[p]];
        fragment.volume += frame.volume[p];
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const double x = frame.points[3 * p + axis];
            fragment.center[axis] += frame.volume[p] * x;
            fragment.low[axis] = std::min(fragment.low[axis], x);
            fragment.high[axis] = std::max(fragment.high[axis], x);
        }
    }
    std::erase_if(fragments, [&](const Fragment& fragment) { return fragment.volume < smallest; });
    for (Fragment& fragment : fragments) {
        for (double& x : fragment.center) x /= fragment.volume;
    }
    std::ranges::stable_sort(fragments, std::ranges::greater(), &Fragment::volume);
    return fragments;
}

std::string percent(double share) { return io::format_fixed(100.0 * share, 1) + " %"; }

// "1234 m³", "1234 m² per m of width"
std::string volume_text(double volume, int dimension) {
    return io::format_fixed(volume, 0) + (dimension == 2 ? " m² per m of width" : " m³");
}

std::string place_text(double length) {
    return std::isnan(length) ? "nowhere" : io::format_fixed(length, 1) + " m";
}

// "at the top", "from the bottom", "inside", "from inside".
std::string start_text(analysis::CrackStart start, const std::string& preposition) {
    if (start == analysis::CrackStart::inside) return preposition == "from" ? "from inside" : "inside";
    return preposition + (start == analysis::CrackStart::top ? " the top" : " the bottom");
}

std::string describe(const analysis::FirstCrack& crack, double height) {
    return "first crack: " + start_text(crack.start(), "from") + ", " + io::format_fixed(crack.position, 0) +
           " m (" + io::format_fixed(crack.position / height, 2) + " H) behind the front, at " +
           io::format_fixed(crack.start_time, 1) + " s\n";
}

std::string describe(const analysis::Calving& calving, int dimension) {
    std::string text = "first iceberg: came off at " + io::format_fixed(calving.time, 2) + " s, " +
                       volume_text(calving.volume, dimension);
    if (std::isnan(calving.length)) return text + ", from above or below the rest\n";
    return text + ", " + io::format_fixed(calving.length, 1) + " m long, " +
           io::format_fixed(calving.length / calving.height, 3) + " of its height of " +
           io::format_fixed(calving.height, 1) + " m\nits crack: began " + start_text(calving.start(), "at") +
           " at " + io::format_fixed(calving.start_time, 2) + " s; behind the front by " +
           place_text(calving.length_top) + " at the top, " + place_text(calving.length_middle) +
           " halfway, " + place_text(calving.length_bottom) + " at the bottom\n";
}

}  // namespace

std::optional<Icebergs> find_icebergs(const Frames& frames, const scene::Scene& scene) {
    const io::Snapshot last = io::read_snapshot(frames.files.back());
    if (last.failure_time.empty()) return {};
    const Ice ice = match(io::read_snapshot(frames.files.front()), last);
    if (ice.volume.empty()) return {};
    const analysis::IceAtRest at_rest{ice.points, ice.volume, ice.failure_time};
    const double spacing = particle_spacing(scene);
    const analysis::CalvingSettings settings{
        .dimension = scene.dimension, .spacing = spacing, .smallest_share = scene.postprocess.iceberg_share};
    Icebergs icebergs{.crack = analysis::first_crack(at_rest, {.spacing = spacing}),
                      .first = analysis::first_detachment(at_rest, settings),
                      .fragments = {},
                      .end_time = last.time,
                      .failed_share = failed_share(ice),
                      .smallest = analysis::smallest_iceberg(at_rest, settings),
                      .height = analysis::bounds(ice.points).height() + spacing,
                      .dimension = scene.dimension};
    icebergs.fragments = find_fragments(last, analysis::usual_reach * spacing,
                                        scene.postprocess.iceberg_damage, icebergs.smallest);
    return icebergs;
}

void write_icebergs(const std::filesystem::path& path, const Icebergs& icebergs, double ice_density,
                    const Provenance& provenance) {
    io::TableWriter table(
        path, provenance,
        {"time", "length", "length_ratio", "length_top", "length_middle", "length_bottom", "height", "volume",
         "mass", "start_height", "start_time", "crack_time", "crack_start_height", "crack_start_time",
         "crack_position", "failed_share", "end_time"});
    const analysis::Calving first = icebergs.first.value_or(analysis::Calving{});
    constexpr double none = analysis::none;
    const analysis::FirstCrack crack = icebergs.crack.value_or(analysis::FirstCrack{none, none, none, none});
    table.append(std::array{first.time, first.length, first.length / first.height, first.length_top,
                            first.length_middle, first.length_bottom, first.height, first.volume,
                            ice_density * first.volume, first.start_height, first.start_time, crack.time,
                            crack.start_height, crack.start_time, crack.position, icebergs.failed_share,
                            icebergs.end_time});
    table.finish();
}

void write_fragments(const std::filesystem::path& path, const Icebergs& icebergs,
                     const Provenance& provenance) {
    io::TableWriter table(
        path, provenance,
        {"volume", "x", "y", "z", "least_x", "greatest_x", "least_y", "greatest_y", "least_z", "greatest_z"});
    for (const Fragment& f : icebergs.fragments) {
        table.append(std::array{f.volume, f.center[0], f.center[1], f.center[2], f.low[0], f.high[0],
                                f.low[1], f.high[1], f.low[2], f.high[2]});
    }
    table.finish();
}

std::string describe(const Icebergs& icebergs) {
    const std::string crack =
        icebergs.crack ? describe(*icebergs.crack, icebergs.height) : "no crack formed\n";
    const std::string first =
        icebergs.first ? describe(*icebergs.first, icebergs.dimension)
                       : "no iceberg came off: " + percent(icebergs.failed_share) + " of the ice failed\n";
    return crack + first + "fragments of intact ice at " + io::format_fixed(icebergs.end_time, 2) +
           " s: " + std::to_string(icebergs.fragments.size()) + " of at least " +
           volume_text(icebergs.smallest, icebergs.dimension) + "\n";
}

}  // namespace tidewater::postprocess
