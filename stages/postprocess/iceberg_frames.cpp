#include "iceberg_frames.h"

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "analysis/glacier_front.h"
#include "analysis/iceberg_state.h"
#include "analysis/iceberg_track.h"
#include "ice_pieces.h"
#include "io/table.h"

namespace tidewater::postprocess {
namespace {

constexpr std::uint32_t none = analysis::Fragments::none;

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
