#include "analysis/detachment.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>
#include <vector>

#include "analysis/neighbours.h"
#include "analysis/union_find.h"

namespace tidewater::analysis {
namespace {

constexpr float never = std::numeric_limits<float>::infinity();

// A connection, there until one of its ends fails.
struct Link {
    float time;
    std::uint32_t a, b;
};

// Parts of the ice that grow together, with their volumes. The rear is one more thing, behind the particles.
class Parts {
public:
    Parts(std::span<const float> volume, double smallest)
        : sets_(volume.size() + 1),
          volume_(volume.begin(), volume.end()),
          smallest_(smallest),
          rear_(static_cast<std::uint32_t>(volume.size())) {
        volume_.push_back(0.0);
    }

    std::uint32_t rear() const { return rear_; }
    std::uint32_t root(std::uint32_t p) { return sets_.root(p); }
    double volume(std::uint32_t p) { return volume_[root(p)]; }
    bool at_rear(std::uint32_t p) { return root(p) == root(rear_); }
    bool is_iceberg(std::uint32_t p) { return volume(p) >= smallest_ && !at_rear(p); }

    void connect(std::uint32_t a, std::uint32_t b) {
        a = root(a);
        b = root(b);
        if (a == b) return;
        volume_[std::min(a, b)] += volume_[std::max(a, b)];
        sets_.connect(a, b);
    }

private:
    UnionFind sets_;
    std::vector<double> volume_;  // of each root
    double smallest_;
    std::uint32_t rear_;
};

// Makes the connections that last, and returns the others from the last to break to the first.
std::vector<Link> connect_what_lasts(const IceAtRest& ice, std::span<const float> times,
                                     const DetachmentSettings& settings, Parts& parts) {
    std::vector<Link> links;
    const auto link = [&](float time, std::uint32_t a, std::uint32_t b) {
        if (time == never) {
            parts.connect(a, b);
        } else {
            links.push_back({time, a, b});
        }
    };
    std::vector<std::uint32_t> all(times.size());
    std::iota(all.begin(), all.end(), 0u);
    for_each_pair(ice.points, all, settings.reach,
                  [&](std::uint32_t a, std::uint32_t b) { link(std::min(times[a], times[b]), a, b); });
    for (const std::uint32_t p : all) {
        if (ice.points[3 * p] <= settings.end_of_rear) parts.connect(p, parts.rear());
    }
    std::ranges::sort(links, std::ranges::greater(), &Link::time);
    return links;
}

// A part large enough that is not connected to the rear yet.
struct Iceberg {
    std::uint32_t particle;  // one of it
    double volume;
};

// The icebergs among the parts that the candidates belong to, each once.
std::vector<Iceberg> find_icebergs(std::vector<std::uint32_t> candidates, Parts& parts) {
    for (std::uint32_t& p : candidates) p = parts.root(p);
    std::ranges::sort(candidates);
    const auto repeated = std::ranges::unique(candidates);
    candidates.erase(repeated.begin(), repeated.end());
    std::vector<Iceberg> icebergs;
    for (const std::uint32_t p : candidates) {
        if (parts.is_iceberg(p)) icebergs.push_back({p, parts.volume(p)});
    }
    return icebergs;
}

}  // namespace

std::optional<Detachment> find_detachment(const IceAtRest& ice, std::span<const float> times,
                                          const DetachmentSettings& settings) {
    Parts parts(ice.volume, settings.smallest_volume);
    const auto links = connect_what_lasts(ice, times, settings, parts);
    std::vector<std::uint32_t> candidates(times.size());
    std::iota(candidates.begin(), candidates.end(), 0u);
    auto icebergs = find_icebergs(candidates, parts);
    std::optional<Detachment> found;
    for (std::size_t begin = 0, end = 0; begin < links.size(); begin = end) {
        const float time = links[begin].time;  // what failed in one step comes back in one
        candidates.clear();
        for (end = begin; end < links.size() && links[end].time == time; ++end) {
            parts.connect(links[end].a, links[end].b);
            candidates.push_back(links[end].a);
        }
        double greatest = 0.0;
        for (const Iceberg& iceberg : icebergs) {
            candidates.push_back(iceberg.particle);
            if (!parts.at_rear(iceberg.particle) || iceberg.volume <= greatest) continue;
            if (times[iceberg.particle] <= time) continue;  // a single one that fails now
            greatest = iceberg.volume;
            found = {time, iceberg.particle};
        }
        icebergs = find_icebergs(std::move(candidates), parts);
        candidates = {};
    }
    return found;
}

}  // namespace tidewater::analysis
