#include "analysis/fragments.h"

#include <algorithm>
#include <cassert>

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

}  // namespace tidewater::analysis
