#include "ice_pieces.h"

#include <algorithm>
#include <numeric>

#include "analysis/box.h"
#include "analysis/calving.h"

namespace tidewater::postprocess {
namespace {

constexpr std::uint32_t none = analysis::Fragments::none;

// Of the ice's height, above and below the still level: between both the front is measured.
constexpr double front_band = 0.1;

analysis::Box ice_box(const io::Snapshot& snapshot) {
    analysis::Box box = analysis::bounds({});
    for (std::size_t p = 0; p < snapshot.particle_count(); ++p) {
        for (std::size_t axis = 0; axis < 3 && is_ice(snapshot, p); ++axis) {
            const double x = snapshot.points[3 * p + axis];
            box.low[axis] = std::min(box.low[axis], x);
            box.high[axis] = std::max(box.high[axis], x);
        }
    }
    return box;
}

// The heights at the still level, if any ice is there; else all.
void find_front_heights(const io::Snapshot& first, const analysis::Box& box, double still_level,
                        Start& start) {
    const double half = front_band * box.height();
    for (std::size_t p = 0; p < first.particle_count(); ++p) {
        if (!is_ice(first, p) || std::abs(first.points[3 * p + 2] - still_level) > half) continue;
        start.front_low = still_level - half;
        start.front_high = still_level + half;
        return;
    }
}

void find_places_at_rest(const io::Snapshot& first, std::span<const std::uint32_t> ids, Start& start) {
    const std::vector<std::uint32_t> order = ice_by_id(first, ids);
    start.id.reserve(order.size());
    start.points.reserve(3 * order.size());
    for (const std::uint32_t p : order) {
        start.id.push_back(ids[p]);
        start.points.insert(start.points.end(), &first.points[3 * p], &first.points[3 * p] + 3);
    }
}

float first_damage(const Start& start, std::uint32_t id) {
    const auto found = std::ranges::lower_bound(start.weak, id, {}, &std::pair<std::uint32_t, float>::first);
    return found != start.weak.end() && found->first == id ? found->second : 0.0f;
}

bool is_intact(const io::Snapshot& snapshot, std::size_t p, std::uint32_t id, const Start& start,
               double greatest_damage) {
    if (!snapshot.failure_time.empty() && !std::isnan(snapshot.failure_time[p])) return false;
    if (snapshot.damage.empty() || snapshot.damage[p] < greatest_damage) return true;
    const double before = first_damage(start, id);
    return snapshot.damage[p] - before < greatest_damage * (1.0 - before);
}

}  // namespace

std::span<const std::uint32_t> particle_ids(const io::Snapshot& snapshot,
                                            std::vector<std::uint32_t>& places) {
    if (!snapshot.id.empty()) return snapshot.id;
    places.resize(snapshot.particle_count());
    std::iota(places.begin(), places.end(), 0u);
    return places;
}

std::vector<std::uint32_t> ice_by_id(const io::Snapshot& snapshot, std::span<const std::uint32_t> ids) {
    std::vector<std::uint32_t> order;
    for (std::uint32_t p = 0; p < snapshot.particle_count(); ++p) {
        if (is_ice(snapshot, p)) order.push_back(p);
    }
    std::ranges::sort(order, {}, [&](std::uint32_t p) { return ids[p]; });
    return order;
}

double least_iceberg(const scene::Scene& scene) {
    const double least = scene.postprocess.iceberg_volume;
    return least > 0.0 ? least : std::pow(2.0 * scene.domain.cell_size, scene.dimension);
}

Start read_start(const io::Snapshot& first, const scene::Scene& scene) {
    Start start;
    const analysis::Box box = ice_box(first);
    const bool glacier = box.low[0] <= scene.domain.cell_size;
    const double end_of_rear = analysis::rear_end(box, particle_spacing(scene));
    std::vector<std::uint32_t> places;
    const auto ids = particle_ids(first, places);
    for (std::size_t p = 0; p < first.particle_count(); ++p) {
        if (!is_ice(first, p)) continue;
        if (glacier && first.points[3 * p] <= end_of_rear) {
            if (ids[p] >= start.rear.size()) start.rear.resize(std::size_t{ids[p]} + 1, false);
            start.rear[ids[p]] = true;
        }
        const bool failed = !first.failure_time.empty() && !std::isnan(first.failure_time[p]);
        if (!first.damage.empty() && first.damage[p] > 0.0f && !failed)
            start.weak.emplace_back(ids[p], first.damage[p]);
    }
    std::ranges::sort(start.weak);
    find_front_heights(first, box, scene.water.depth, start);
    find_places_at_rest(first, ids, start);
    return start;
}

Pieces find_pieces(const io::Snapshot& snapshot, std::span<const std::uint32_t> ids, const Start& start,
                   const scene::Scene& scene) {
    const std::size_t count = snapshot.particle_count();
    std::vector<std::uint8_t> intact(count, 0), rear(count, 0);
    for (std::size_t p = 0; p < count; ++p) {
        if (!is_ice(snapshot, p)) continue;
        rear[p] = ids[p] < start.rear.size() && start.rear[ids[p]];
        intact[p] = rear[p] || is_intact(snapshot, p, ids[p], start, scene.postprocess.iceberg_damage);
    }
    Pieces pieces;
    pieces.fragments = analysis::label_fragments(snapshot.points, intact,
                                                 scene.postprocess.iceberg_reach * particle_spacing(scene));
    pieces.glacier = analysis::join_fragments(rear, pieces.fragments);
    analysis::drop_crumbs(snapshot.volume, least_iceberg(scene), pieces.glacier, pieces.fragments);
    for (std::size_t p = 0; p < count; ++p) {
        if (!is_ice(snapshot, p)) continue;
        if (!intact[p]) pieces.failed_volume += snapshot.volume[p];
        if (intact[p] && pieces.fragments.label[p] == none) pieces.crumb_volume += snapshot.volume[p];
    }
    return pieces;
}

}  // namespace tidewater::postprocess
