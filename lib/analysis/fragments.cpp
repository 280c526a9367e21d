#include "analysis/fragments.h"

#include <algorithm>
#include <cassert>
#include <utility>

#include "analysis/neighbours.h"
#include "analysis/union_find.h"

namespace tidewater::analysis {

Fragments label_fragments(std::span<const float> points, std::span<const std::uint8_t> intact, double reach) {
    assert(points.size() == 3 * intact.size());
    std::vector<std::uint32_t> chosen;
    for (std::uint32_t p = 0; p < intact.size(); ++p) {
        if (intact[p]) chosen.push_back(p);
    }
    UnionFind pieces(intact.size());
    for_each_pair(points, chosen, reach, [&](std::uint32_t a, std::uint32_t b) { pieces.connect(a, b); });

    std::vector<std::uint32_t> size(intact.size(), 0), roots;
    for (const std::uint32_t p : chosen) {
        if (size[pieces.root(p)]++ == 0) roots.push_back(pieces.root(p));
    }
    std::ranges::sort(roots, [&](std::uint32_t a, std::uint32_t b) {
        return size[a] != size[b] ? size[a] > size[b] : a < b;
    });
    Fragments fragments;
    fragments.label.assign(intact.size(), Fragments::none);
    for (const std::uint32_t root : roots) {
        fragments.label[root] = static_cast<std::uint32_t>(fragments.size.size());
        fragments.size.push_back(size[root]);
    }
    for (const std::uint32_t p : chosen) fragments.label[p] = fragments.label[pieces.root(p)];
    return fragments;
}

std::uint32_t join_fragments(std::span<const std::uint8_t> rear, Fragments& fragments) {
    assert(rear.size() == fragments.label.size());
    std::vector<std::uint8_t> joined(fragments.size.size(), 0);
    for (std::size_t p = 0; p < rear.size(); ++p) {
        if (rear[p] && fragments.label[p] != Fragments::none) joined[fragments.label[p]] = 1;
    }
    const auto first = std::ranges::find(joined, 1);
    if (first == joined.end()) return Fragments::none;
    const auto into = static_cast<std::uint32_t>(first - joined.begin());
    for (std::uint32_t& label : fragments.label) {
        if (label != Fragments::none && joined[label]) label = into;
    }
    for (std::uint32_t f = into + 1; f < joined.size(); ++f) {
        if (joined[f]) fragments.size[into] += std::exchange(fragments.size[f], 0);
    }
    return into;
}

void drop_crumbs(std::span<const float> volume, double least, std::uint32_t kept, Fragments& fragments) {
    assert(volume.size() == fragments.label.size());
    std::vector<double> volumes(fragments.size.size(), 0.0);
    for (std::size_t p = 0; p < volume.size(); ++p) {
        if (fragments.label[p] != Fragments::none) volumes[fragments.label[p]] += volume[p];
    }
    const auto is_crumb = [&](std::uint32_t f) { return volumes[f] < least && f != kept; };
    for (std::uint32_t& label : fragments.label) {
        if (label != Fragments::none && is_crumb(label)) label = Fragments::none;
    }
    for (std::uint32_t f = 0; f < volumes.size(); ++f) {
        if (is_crumb(f)) fragments.size[f] = 0;
    }
}

FragmentMembers collect_members(const Fragments& fragments, std::uint32_t left_out) {
    FragmentMembers members;
    members.first.push_back(0);
    for (std::uint32_t f = 0; f < fragments.size.size(); ++f)
        members.first.push_back(members.first.back() + (f == left_out ? 0 : fragments.size[f]));
    members.particles.resize(members.first.back());
    std::vector<std::uint32_t> next = members.first;
    for (std::uint32_t p = 0; p < fragments.label.size(); ++p) {
        const std::uint32_t f = fragments.label[p];
        if (f != Fragments::none && f != left_out) members.particles[next[f]++] = p;
    }
    return members;
}

}  // namespace tidewater::analysis
