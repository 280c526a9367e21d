#include "analysis/iceberg_track.h"

#include <algorithm>
#include <cassert>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "analysis/fragments.h"

namespace tidewater::analysis {
namespace {

using Kind = IcebergEvent::Kind;

constexpr std::uint32_t none = IcebergEvent::none;

// What an iceberg of the frame before and a fragment of this one share.
struct Overlap {
    std::uint32_t iceberg, label;
    double volume;
    std::uint32_t lowest;  // particle id
};

// One particle of a fragment.
struct Piece {
    std::uint32_t id, label;
    float volume;
};

std::vector<Piece> pieces_by_id(const FragmentFrame& frame) {
    const auto in_fragment = [](std::uint32_t label) { return label != Fragments::none; };
    std::vector<Piece> pieces;
    pieces.reserve(static_cast<std::size_t>(std::ranges::count_if(frame.label, in_fragment)));
    for (std::size_t i = 0; i < frame.id.size(); ++i) {
        if (in_fragment(frame.label[i])) pieces.push_back({frame.id[i], frame.label[i], frame.volume[i]});
    }
    std::ranges::sort(pieces, {}, &Piece::id);
    return pieces;
}

// The largest first. Both lists are sorted by particle id, in which order volumes are summed.
std::vector<Overlap> find_overlaps(std::span<const Piece> pieces, std::span<const IcebergMember> members) {
    std::vector<Overlap> overlaps;
    std::unordered_map<std::uint64_t, std::size_t> place;  // of each pair in overlaps
    auto before = members.begin();
    for (const Piece& piece : pieces) {
        while (before != members.end() && before->particle < piece.id) ++before;
        if (before == members.end()) break;
        if (before->particle != piece.id) continue;
        const std::uint64_t pair = std::uint64_t{before->iceberg} << 32 | piece.label;
        const auto [at, is_new] = place.try_emplace(pair, overlaps.size());
        if (is_new) overlaps.push_back({before->iceberg, piece.label, 0.0, piece.id});
        overlaps[at->second].volume += piece.volume;
    }
    std::ranges::sort(overlaps, {}, [](const Overlap& o) { return std::pair(-o.volume, o.lowest); });
    return overlaps;
}

// The icebergs of the frame before, rising.
std::vector<std::uint32_t> icebergs_before(const IcebergTracks& tracks) {
    std::vector<std::uint8_t> there(tracks.count, 0);
    for (const IcebergMember& member : tracks.members) there[member.iceberg] = 1;
    std::vector<std::uint32_t> icebergs;
    for (std::uint32_t i = 0; i < tracks.count; ++i) {
        if (there[i]) icebergs.push_back(i);
    }
    return icebergs;
}

// How the icebergs of the frame before and the fragments of this one belong together; by label or iceberg.
struct Partners {
    std::vector<std::uint32_t> iceberg;     // that each label goes on as
    std::vector<std::uint32_t> parent;      // that each label has most of
    std::vector<const Overlap*> successor;  // with the label that has most of each iceberg
    std::vector<std::uint8_t> kept;         // whether the iceberg goes on
};

Partners find_partners(std::span<const Overlap> overlaps, std::uint32_t labels, std::uint32_t icebergs,
                       std::uint32_t glacier) {
    Partners partners{std::vector(labels, none), std::vector(labels, none),
                      std::vector<const Overlap*>(icebergs, nullptr), std::vector<std::uint8_t>(icebergs, 0)};
    partners.kept[glacier_id] = 1;
    if (glacier != none) partners.iceberg[glacier] = glacier_id;
    for (const Overlap& o : overlaps) {
        if (partners.parent[o.label] == none) partners.parent[o.label] = o.iceberg;
        if (!partners.successor[o.iceberg]) partners.successor[o.iceberg] = &o;
        if (partners.iceberg[o.label] != none || partners.kept[o.iceberg]) continue;
        partners.iceberg[o.label] = o.iceberg;
        partners.kept[o.iceberg] = 1;
    }
    return partners;
}

std::vector<double> label_volumes(std::span<const Piece> pieces, std::uint32_t labels) {
    std::vector<double> volumes(labels, 0.0);
    for (const Piece& piece : pieces) volumes[piece.label] += piece.volume;
    return volumes;
}

}  // namespace

std::vector<std::uint32_t> follow_icebergs(const FragmentFrame& frame, IcebergTracks& tracks) {
    assert(frame.id.size() == frame.label.size() && frame.id.size() == frame.volume.size());
    const std::vector<Piece> pieces = pieces_by_id(frame);
    const std::vector<Overlap> overlaps = find_overlaps(pieces, tracks.members);
    std::uint32_t labels = frame.glacier == none ? 0 : frame.glacier + 1;
    for (const Piece& piece : pieces) labels = std::max(labels, piece.label + 1);
    Partners partners = find_partners(overlaps, labels, tracks.count, frame.glacier);

    tracks.events.clear();
    for (const std::uint32_t before : icebergs_before(tracks)) {
        if (partners.kept[before]) continue;
        const Overlap* into = partners.successor[before];
        tracks.events.push_back({frame.time, into ? Kind::merge : Kind::gone, before,
                                 into ? partners.iceberg[into->label] : none, into ? into->volume : 0.0});
    }
    const std::vector<double> volumes = label_volumes(pieces, labels);
    for (const Piece& piece : pieces) {
        std::uint32_t& iceberg = partners.iceberg[piece.label];
        if (iceberg != none) continue;
        iceberg = tracks.count++;
        tracks.events.push_back(
            {frame.time, Kind::split, iceberg, partners.parent[piece.label], volumes[piece.label]});
    }
    tracks.members.clear();
    tracks.members.reserve(pieces.size());
    for (const Piece& piece : pieces) tracks.members.push_back({piece.id, partners.iceberg[piece.label]});
    return partners.iceberg;
}

}  // namespace tidewater::analysis
