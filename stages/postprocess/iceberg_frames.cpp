#include "iceberg_frames.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/box.h"
#include "analysis/fragments.h"
#include "analysis/glacier_front.h"
#include "analysis/iceberg_state.h"
#include "analysis/iceberg_track.h"
#include "core/types.h"
#include "io/table.h"

namespace tidewater::postprocess {
namespace {

constexpr std::uint32_t none = analysis::Fragments::none;

// Of the ice's height, above and below the still level: between both the front is measured.
constexpr double front_band = 0.1;

bool is_ice(const io::Snapshot& snapshot, std::size_t p) {
    return static_cast<Material>(snapshot.material[p]) == Material::ice;
}

// The particles' ids; where the file has none, `places` is made to hold their places in it.
std::span<const std::uint32_t> particle_ids(const io::Snapshot& snapshot,
                                            std::vector<std::uint32_t>& places) {
    if (!snapshot.id.empty()) return snapshot.id;
    places.resize(snapshot.particle_count());
    std::iota(places.begin(), places.end(), 0u);
    return places;
}

// What the first frame tells of the ice.
struct Start {
    std::vector<bool> rear;  // by particle id; those beyond are not the rear's
    std::vector<std::pair<std::uint32_t, float>>
        weak;                       // id and damage of what was damaged but had not failed
    std::vector<std::uint32_t> id;  // of the ice, rising
    std::vector<float> points;      // of each where it is at rest, (x, y, z), m
    double front_low = -INFINITY, front_high = INFINITY;  // between which z the front is measured, m
};

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
    std::vector<std::uint32_t> order;
    for (std::uint32_t p = 0; p < first.particle_count(); ++p) {
        if (is_ice(first, p)) order.push_back(p);
    }
    std::ranges::sort(order, {}, [&](std::uint32_t p) { return ids[p]; });
    start.id.reserve(order.size());
    start.points.reserve(3 * order.size());
    for (const std::uint32_t p : order) {
        start.id.push_back(ids[p]);
        start.points.insert(start.points.end(), &first.points[3 * p], &first.points[3 * p] + 3);
    }
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

// The glacier and the icebergs of a frame, without crumbs.
struct Pieces {
    analysis::Fragments fragments;
    std::uint32_t glacier = none;  // its label
    double failed_volume = 0.0;    // of the ice that is not intact, and of crumbs, m³ (2D: m²)
    double crumb_volume = 0.0;
};

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

// The ground that ice may lie on: the bed, or the shelf where there is one.
std::function<double(double, double)> ground_height(const scene::Scene& scene, const Ground& ground,
                                                    double time) {
    const bool shelf = scene.has("shelf");
    return [&ground, shelf, end = scene.shelf.length - scene.shelf.retreat * time, top = scene.shelf.height](
               double x, double y) {
        const double height = ground.height(x, y);
        return shelf && x <= end ? std::max(top, height) : height;
    };
}

const std::vector<std::string> state_columns{
    "time",       "iceberg",    "volume",     "mass",       "length",     "width",
    "height",     "tilt",       "x",          "y",          "z",          "velocity_x",
    "velocity_y", "velocity_z", "rotation_x", "rotation_y", "rotation_z", "draft",
    "freeboard",  "area",       "buoyancy",   "clearance",  "grounded"};

// The densities of what floats in what.
double buoyancy(const analysis::IcebergState& s, const scene::Scene& scene) {
    if (!scene.has("water")) return analysis::none;
    return scene.water.model.density * s.submerged / scene.ice.model.density;
}

std::vector<double> state_row(double time, std::uint32_t iceberg, const analysis::IcebergState& s,
                              const scene::Scene& scene) {
    const bool grounded = s.clearance <= particle_spacing(scene);
    return {time,
            static_cast<double>(iceberg),
            s.volume,
            scene.ice.model.density * s.volume,
            s.length,
            s.width,
            s.height,
            s.tilt(),
            s.centroid[0],
            s.centroid[1],
            s.centroid[2],
            s.velocity[0],
            s.velocity[1],
            s.velocity[2],
            s.rotation[0],
            s.rotation[1],
            s.rotation[2],
            s.draft,
            s.freeboard,
            s.area,
            buoyancy(s, scene),
            s.clearance,
            grounded ? 1.0 : 0.0};
}

// Goes from frame to frame. What it keeps of the frame before can also be read from that one's files.
class Follower {
public:
    Follower(const StageContext& context, const Frames& frames, const Ground& ground)
        : context_(context), frames_(frames), ground_(ground) {}

    void make(std::size_t frame, const io::Snapshot& snapshot, const Provenance& provenance) {
        const scene::Scene& scene = context_.scene;
        go_to(frame, snapshot);
        std::vector<std::uint32_t> places;
        const auto ids = particle_ids(snapshot, places);
        const Pieces pieces = find_pieces(snapshot, ids, *start_, scene);
        const std::vector<std::uint32_t> iceberg = analysis::follow_icebergs(
            {snapshot.time, ids, pieces.fragments.label, snapshot.volume, pieces.glacier}, tracks_);
        std::vector<std::uint32_t> label(tracks_.count, none);  // of each iceberg
        for (std::uint32_t f = 0; f < iceberg.size(); ++f) {
            if (iceberg[f] != none) label[iceberg[f]] = f;
        }
        const analysis::FragmentMembers members = analysis::collect_members(pieces.fragments);
        const double in_icebergs = write_states(frame, snapshot, label, members, provenance);
        write_events(frame, provenance);
        analysis::FrontRows front;
        if (pieces.glacier != none)
            front = analysis::find_front(snapshot.points, members.of(pieces.glacier), heights());
        double in_glacier = 0.0;
        if (pieces.glacier != none) {
            for (const std::uint32_t p : members.of(pieces.glacier)) in_glacier += snapshot.volume[p];
        }
        io::TableWriter glacier(
            file("glacier", frame), provenance,
            {"time", "glacier_volume", "iceberg_volume", "failed_volume", "crumb_volume", "front_position"});
        glacier.append(std::array{snapshot.time, in_glacier, in_icebergs, pieces.failed_volume,
                                  pieces.crumb_volume, front.median()});
        glacier.finish();
        write_members(frame, snapshot.time, provenance);
        at_ = frame;
    }

private:
    std::filesystem::path file(const std::string& product, std::size_t frame,
                               const std::string& extension = "csv") const {
        return context_.folder / frame_file(product, frame, extension);
    }

    // So that start_, tracks_ and front_ are as they were after the frame before.
    void go_to(std::size_t frame, const io::Snapshot& snapshot) {
        if (frame == 0) start_ = read_start(snapshot, context_.scene);
        if (!start_) start_ = read_start(read_frame(frames_, 0, context_.scene), context_.scene);
        if (frame > 0 && at_ == frame - 1) return;
        tracks_ = {};
        front_ = {};
        if (frame == 0) return;
        const io::Members before = read_members(context_.folder, frame - 1);
        tracks_.count = before.given;
        for (std::size_t i = 0; i < before.particle.size(); ++i)
            tracks_.members.push_back({before.particle[i], before.iceberg[i]});
        front_ = {before.front_row, before.front};
    }

    // Returns the icebergs' volume.
    double write_states(std::size_t frame, const io::Snapshot& snapshot, std::span<const std::uint32_t> label,
                        const analysis::FragmentMembers& members, const Provenance& provenance) const {
        const scene::Scene& scene = context_.scene;
        const analysis::Surroundings surroundings{.dimension = scene.dimension,
                                                  .spacing = particle_spacing(scene),
                                                  .still_level = scene.water.depth,
                                                  .ground = ground_height(scene, ground_, snapshot.time)};
        io::TableWriter table(file("icebergs", frame), provenance, state_columns);
        double volume = 0.0;
        for (std::uint32_t i = analysis::glacier_id + 1; i < label.size(); ++i) {
            if (label[i] == none) continue;
            const analysis::IcebergState state = analysis::describe_iceberg(
                {snapshot.points, snapshot.velocity, snapshot.volume}, members.of(label[i]), surroundings);
            table.append(state_row(snapshot.time, i, state, scene));
            volume += state.volume;
        }
        table.finish();
        return volume;
    }

    analysis::FrontSettings heights() const {
        return {particle_spacing(context_.scene), start_->front_low, start_->front_high};
    }

    // What the glacier and the icebergs that have just come off it consist of, as places in start_.
    std::map<std::uint32_t, std::vector<std::uint32_t>> members_at_rest() const {
        std::map<std::uint32_t, std::vector<std::uint32_t>> members{{analysis::glacier_id, {}}};
        for (const analysis::IcebergEvent& event : tracks_.events) {
            if (event.calved()) members[event.iceberg] = {};
        }
        std::vector<std::vector<std::uint32_t>*> list(tracks_.count, nullptr);
        for (auto& [iceberg, particles] : members) list[iceberg] = &particles;
        std::uint32_t at = 0;
        for (const analysis::IcebergMember& member : tracks_.members) {
            while (at < start_->id.size() && start_->id[at] < member.particle) ++at;
            if (at == start_->id.size()) break;
            if (start_->id[at] == member.particle && list[member.iceberg])
                list[member.iceberg]->push_back(at);
        }
        return members;
    }

    // Breaks are measured where the ice was at rest, so that nothing that moves between two frames counts:
    // from what was the glacier's front a frame before.
    void write_events(std::size_t frame, const Provenance& provenance) {
        io::TableWriter table(file("iceberg_events", frame), provenance,
                              {"time", "kind", "iceberg", "other", "volume", "break_distance"});
        const auto at_rest = members_at_rest();
        for (const analysis::IcebergEvent& event : tracks_.events) {
            const double distance = event.calved()
                                        ? analysis::break_distance(start_->points, at_rest.at(event.iceberg),
                                                                   front_, particle_spacing(context_.scene))
                                        : analysis::none;
            const double other = event.other == none ? analysis::none : static_cast<double>(event.other);
            table.append(std::array{event.time, static_cast<double>(event.kind),
                                    static_cast<double>(event.iceberg), other, event.volume, distance});
        }
        table.finish();
        front_ = analysis::find_front(start_->points, at_rest.at(analysis::glacier_id), heights());
    }

    void write_members(std::size_t frame, double time, const Provenance& provenance) const {
        io::Members members{.time = time,
                            .given = tracks_.count,
                            .particle = {},
                            .iceberg = {},
                            .front = front_.x,
                            .front_row = front_.first};
        members.particle.reserve(tracks_.members.size());
        members.iceberg.reserve(tracks_.members.size());
        for (const analysis::IcebergMember& member : tracks_.members) {
            members.particle.push_back(member.particle);
            members.iceberg.push_back(member.iceberg);
        }
        io::write_members(file("members", frame, "h5"), members, provenance);
    }

    const StageContext& context_;
    const Frames& frames_;
    const Ground& ground_;
    std::optional<Start> start_;
    std::optional<std::size_t> at_;  // the frame that the following are of
    analysis::IcebergTracks tracks_;
    analysis::FrontRows front_;  // of the glacier, where it was at rest
};

}  // namespace

double particle_spacing(const scene::Scene& scene) {
    return scene.domain.cell_size / scene.particles.per_axis;
}

double least_iceberg(const scene::Scene& scene) {
    const double least = scene.postprocess.iceberg_volume;
    return least > 0.0 ? least : std::pow(2.0 * scene.domain.cell_size, scene.dimension);
}

io::Members read_members(const std::filesystem::path& folder, std::size_t frame) {
    return io::read_members(folder / frame_file("members", frame, "h5"));
}

FrameProduct icebergs_product(const StageContext& context, const Frames& frames, const Ground& ground) {
    constexpr std::array<std::string_view, 3> keys{"postprocess.iceberg_damage", "postprocess.iceberg_reach",
                                                   "postprocess.iceberg_volume"};
    const auto follower = std::make_shared<Follower>(context, frames, ground);
    return {.name = "icebergs",
            .settings = scene::values_of(context.scene, keys),
            .files =
                [any = context.scene.has("ice")](std::size_t frame) {
                    if (!any) return std::vector<std::string>{};
                    return std::vector{frame_file("icebergs", frame), frame_file("glacier", frame),
                                       frame_file("iceberg_events", frame),
                                       frame_file("members", frame, "h5")};
                },
            .make = [follower](std::size_t frame, const io::Snapshot& snapshot,
                               const Provenance& provenance) { follower->make(frame, snapshot, provenance); },
            .follows = true};
}

}  // namespace tidewater::postprocess
