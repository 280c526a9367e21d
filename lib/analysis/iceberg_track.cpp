#include "analysis/iceberg_track.h"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>
#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numeric>
#include <tuple>

#include "analysis/fragments.h"

namespace tidewater::analysis {
namespace {

constexpr std::uint32_t none = IcebergEvent::none;

// What an iceberg of the frame before and a fragment of this one share.
struct Overlap {
    std::uint32_t iceberg, label;
    double volume;
    std::uint64_t lowest;  // particle id
};

// One intact particle of the frame.
struct Piece {
    std::uint64_t id;
    std::uint32_t label;
    float volume;
};

std::vector<Piece> pieces_by_id(const FragmentFrame& frame) {
    std::vector<Piece> pieces;
    for (std::size_t i = 0; i < frame.id.size(); ++i) {
        if (frame.label[i] != Fragments::none)
            pieces.push_back({frame.id[i], frame.label[i], frame.volume[i]});
    }
    std::ranges::sort(pieces, {}, &Piece::id);
    return pieces;
}

// The largest first. Both lists are sorted by particle id, in which order volumes are summed.
std::vector<Overlap> find_overlaps(std::span<const Piece> pieces, const IcebergTracks& tracks) {
    std::vector<Overlap> overlaps;
    auto before = tracks.members.begin();
    for (const Piece& piece : pieces) {
        while (before != tracks.members.end() && before->first < piece.id) ++before;
        if (before == tracks.members.end()) break;
        if (before->first == piece.id) {
            overlaps.push_back({before->second, piece.label, piece.volume, piece.id});
        }
    }
    std::ranges::stable_sort(overlaps, {}, [](const Overlap& o) { return std::pair(o.iceberg, o.label); });
    std::size_t count = 0;
    for (const Overlap& o : overlaps) {
        const bool same =
            count > 0 && overlaps[count - 1].iceberg == o.iceberg && overlaps[count - 1].label == o.label;
        if (same) {
            overlaps[count - 1].volume += o.volume;
        } else {
            overlaps[count++] = o;
        }
    }
    overlaps.resize(count);
    std::ranges::sort(overlaps, {}, [](const Overlap& o) { return std::pair(-o.volume, o.lowest); });
    return overlaps;
}

std::uint32_t label_count(std::span<const Piece> pieces) {
    std::uint32_t count = 0;
    for (const Piece& piece : pieces) count = std::max(count, piece.label + 1);
    return count;
}

}  // namespace

std::vector<std::uint32_t> follow_icebergs(const FragmentFrame& frame, IcebergTracks& tracks) {
    assert(frame.id.size() == frame.label.size() && frame.id.size() == frame.volume.size());
    const std::vector<Piece> pieces = pieces_by_id(frame);
    const std::vector<Overlap> overlaps = find_overlaps(pieces, tracks);
    std::vector<std::uint32_t> iceberg(label_count(pieces), none);
    std::vector<std::uint32_t> parent(iceberg.size(), none);
    std::vector<std::uint32_t> goes_on(tracks.count, none);  // the label that has most of each old iceberg
    std::vector<std::uint8_t> kept(tracks.count, 0);
    for (const Overlap& o : overlaps) {
        if (parent[o.label] == none) parent[o.label] = o.iceberg;
        if (goes_on[o.iceberg] == none) goes_on[o.iceberg] = o.label;
        if (iceberg[o.label] != none || kept[o.iceberg]) continue;
        iceberg[o.label] = o.iceberg;
        kept[o.iceberg] = 1;
    }
    std::vector<std::uint32_t> old;
    for (const auto& member : tracks.members) old.push_back(member.second);
    std::ranges::sort(old);
    const auto repeated = std::ranges::unique(old);
    old.erase(repeated.begin(), repeated.end());

    using Kind = IcebergEvent::Kind;
    std::vector<IcebergEvent> births;
    for (const Piece& piece : pieces) {  // by particle id
        if (iceberg[piece.label] != none) continue;
        iceberg[piece.label] = tracks.count++;
        births.push_back({frame.time, Kind::split, iceberg[piece.label], parent[piece.label]});
    }
    for (const std::uint32_t o : old) {
        if (kept[o]) continue;
        const bool merged = goes_on[o] != none;
        tracks.events.push_back(
            {frame.time, merged ? Kind::merge : Kind::gone, o, merged ? iceberg[goes_on[o]] : none});
    }
    tracks.events.insert(tracks.events.end(), births.begin(), births.end());
    tracks.members.clear();
    for (const Piece& piece : pieces) tracks.members.emplace_back(piece.id, iceberg[piece.label]);
    return iceberg;
}

IcebergState describe_iceberg(const IcebergParticles& particles, std::span<const std::uint32_t> members,
                              int dimension, double spacing, double still_level) {
    assert(!members.empty() && (dimension == 2 || dimension == 3));
    const auto vector = [](std::span<const float> values, std::uint32_t p) -> Eigen::Vector3d {
        return Eigen::Vector3f(values[3 * p], values[3 * p + 1], values[3 * p + 2]).cast<double>();
    };
    IcebergState state;
    for (const std::uint32_t p : members) {
        const double volume = particles.volume[p];
        state.volume += volume;
        state.centroid += volume * vector(particles.points, p);
        state.velocity += volume * vector(particles.velocity, p);
    }
    state.centroid /= state.volume;
    state.velocity /= state.volume;
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();  // ∫ r rᵀ dV
    Eigen::Vector3d momentum = Eigen::Vector3d::Zero();
    double low = INFINITY, high = -INFINITY;
    for (const std::uint32_t p : members) {
        const double volume = particles.volume[p];
        const Eigen::Vector3d r = vector(particles.points, p) - state.centroid;
        spread += volume * r * r.transpose();
        momentum += volume * r.cross(vector(particles.velocity, p) - state.velocity);
        low = std::min(low, state.centroid[2] + r[2]);
        high = std::max(high, state.centroid[2] + r[2]);
    }
    state.draft = still_level - (low - 0.5 * spacing);
    state.freeboard = high + 0.5 * spacing - still_level;
    if (dimension == 2) momentum = {0.0, momentum[1], 0.0};
    const Eigen::Matrix3d inertia = spread.trace() * Eigen::Matrix3d::Identity() - spread;
    state.rotation = inertia.completeOrthogonalDecomposition().solve(momentum);

    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> principal(spread);
    std::array<double, 3> edge{};
    for (int axis = 0; axis < 3; ++axis) {
        const Eigen::Vector3d along = principal.eigenvectors().col(axis);
        double least = INFINITY, greatest = -INFINITY;
        for (const std::uint32_t p : members) {
            const double place = along.dot(vector(particles.points, p) - state.centroid);
            least = std::min(least, place);
            greatest = std::max(greatest, place);
        }
        const bool across = dimension == 2 && std::abs(along[1]) > 0.5;
        edge[static_cast<std::size_t>(axis)] = across ? -1.0 : greatest - least + spacing;
    }
    std::array<int, 3> order{0, 1, 2};
    std::ranges::stable_sort(order, std::ranges::greater(),
                             [&](int axis) { return edge[static_cast<std::size_t>(axis)]; });
    if (dimension == 2) std::swap(order[1], order[2]);  // the axis across the slice is the width's
    for (int k = 0; k < 3; ++k)
        state.axes.col(k) = principal.eigenvectors().col(order[static_cast<std::size_t>(k)]);
    const auto size = [&](std::size_t k) { return std::max(0.0, edge[static_cast<std::size_t>(order[k])]); };
    state.length = size(0);
    state.width = size(1);
    state.height = size(2);
    return state;
}

}  // namespace tidewater::analysis
