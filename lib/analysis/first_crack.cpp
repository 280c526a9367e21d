#include "analysis/first_crack.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "analysis/box.h"
#include "analysis/neighbours.h"
#include "analysis/union_find.h"

namespace tidewater::analysis {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The ice at rest, sorted into columns along z and rows along x, each a spacing wide.
class Lattice {
public:
    Lattice(std::span<const float> points, double spacing)
        : points_(points),
          box_(bounds(points)),
          spacing_(spacing),
          heights_(bin(2, box_.high[2]) + 1),
          lengths_(bin(0, box_.high[0]) + 1) {
        const std::size_t widths = bin(1, box_.high[1]) + 1;
        base_.assign(lengths_ * widths, infinity);
        surface_.assign(lengths_ * widths, -infinity);
        front_.assign(heights_ * widths, -infinity);
        for (std::size_t p = 0; p < points.size() / 3; ++p) {
            base_[column(p)] = std::min(base_[column(p)], at(p, 2) - 0.5 * spacing);
            surface_[column(p)] = std::max(surface_[column(p)], at(p, 2) + 0.5 * spacing);
            front_[row(p)] = std::max(front_[row(p)], at(p, 0) + 0.5 * spacing);
        }
    }

    double height() const { return box_.height() + spacing_; }
    bool at_rear(std::size_t p) const { return at(p, 0) <= rear_end(box_, spacing_); }
    std::size_t rows() const { return front_.size(); }
    std::size_t row(std::size_t p) const { return bin(1, at(p, 1)) * heights_ + bin(2, at(p, 2)); }
    double above_base(std::size_t p) const { return at(p, 2) - base_[column(p)]; }
    double height_share(std::size_t p) const {
        return above_base(p) / (surface_[column(p)] - base_[column(p)]);
    }
    double behind_front(std::size_t p) const { return front_[row(p)] - at(p, 0); }

private:
    double at(std::size_t p, std::size_t axis) const { return points_[3 * p + axis]; }
    std::size_t bin(std::size_t axis, double x) const {
        return static_cast<std::size_t>((x - box_.low[axis]) / spacing_ + 0.5);
    }
    std::size_t column(std::size_t p) const { return bin(1, at(p, 1)) * lengths_ + bin(0, at(p, 0)); }

    std::span<const float> points_;
    Box box_;
    double spacing_;
    std::size_t heights_, lengths_;
    std::vector<double> base_, surface_;  // z of each column
    std::vector<double> front_;           // x of each row
};

// Bands of failed ice that grow together, with their extents in height above the base.
class Bands {
public:
    explicit Bands(const Lattice& lattice, std::size_t count) : sets_(count), rear_(count) {
        for (std::size_t p = 0; p < count; ++p) {
            low_.push_back(lattice.above_base(p));
            rear_[p] = lattice.at_rear(p);
        }
        high_ = low_;
    }

    std::uint32_t root(std::uint32_t p) { return sets_.root(p); }
    double extent(std::uint32_t p) { return high_[root(p)] - low_[root(p)]; }
    bool at_rear(std::uint32_t p) { return rear_[root(p)]; }

    void connect(std::uint32_t a, std::uint32_t b) {
        a = root(a);
        b = root(b);
        sets_.connect(a, b);
        const std::uint32_t both = root(a);
        low_[both] = std::min(low_[a], low_[b]);
        high_[both] = std::max(high_[a], high_[b]);
        rear_[both] = rear_[a] || rear_[b];
    }

private:
    UnionFind sets_;
    std::vector<double> low_, high_;  // of each root
    std::vector<bool> rear_;          // likewise: reaches into the rear
};

// A connection, there once both ends have failed.
struct Link {
    float time;
    std::uint32_t a, b;
};

// In the order in which they come; every particle has one to itself.
std::vector<Link> make_links(const IceAtRest& ice, std::span<const std::uint32_t> failed, double reach) {
    std::vector<Link> links;
    for (const std::uint32_t p : failed) links.push_back({ice.failure_time[p], p, p});
    for_each_pair(ice.points, failed, reach, [&](std::uint32_t a, std::uint32_t b) {
        links.push_back({std::max(ice.failure_time[a], ice.failure_time[b]), a, b});
    });
    std::ranges::sort(links, {}, &Link::time);
    return links;
}

struct Band {
    float time;
    std::vector<std::uint32_t> particles;
};

// The first band that is high enough; of several in one step the highest.
std::optional<Band> find_band(std::span<const Link> links, std::span<const std::uint32_t> failed,
                              double least_extent, Bands& bands) {
    for (std::size_t begin = 0, end = 0; begin < links.size(); begin = end) {
        const float time = links[begin].time;
        for (end = begin; end < links.size() && links[end].time == time; ++end)
            bands.connect(links[end].a, links[end].b);
        const Link* highest = nullptr;
        for (const Link& link : links.subspan(begin, end - begin)) {
            if (bands.at_rear(link.a) || bands.extent(link.a) < least_extent) continue;
            if (!highest || bands.extent(link.a) > bands.extent(highest->a)) highest = &link;
        }
        if (!highest) continue;
        Band band{.time = time, .particles = {}};
        for (const std::uint32_t p : failed) {
            if (bands.root(p) == bands.root(highest->a)) band.particles.push_back(p);
        }
        return band;
    }
    return {};
}

// The median height share of the earlier half of the rows, by the first failure of the band in each.
double median_start(const IceAtRest& ice, const Lattice& lattice, std::span<const std::uint32_t> band) {
    struct Row {
        double time = infinity, share = 0.0;
    };
    std::vector<Row> rows(lattice.rows());
    for (const std::uint32_t p : band) {
        Row& row = rows[lattice.row(p)];
        if (ice.failure_time[p] < row.time) row = {ice.failure_time[p], lattice.height_share(p)};
    }
    std::erase_if(rows, [](const Row& row) { return !std::isfinite(row.time); });
    std::ranges::sort(rows, {}, &Row::time);
    std::vector<double> shares;
    for (const Row& row : rows) {
        if (row.time <= rows[rows.size() / 2].time) shares.push_back(row.share);
    }
    const auto median = shares.begin() + static_cast<std::ptrdiff_t>(shares.size() / 2);
    std::ranges::nth_element(shares, median);
    return *median;
}

FirstCrack measure(const IceAtRest& ice, const Lattice& lattice, Band band) {
    const CrackStart third = crack_start(median_start(ice, lattice, band.particles));
    std::erase_if(band.particles,
                  [&](std::uint32_t p) { return crack_start(lattice.height_share(p)) != third; });
    const auto time = [&](std::uint32_t p) { return ice.failure_time[p]; };
    const float start = time(*std::ranges::min_element(band.particles, {}, time));
    FirstCrack crack{.time = band.time, .start_time = start};
    std::erase_if(band.particles, [&](std::uint32_t p) { return time(p) > start; });
    const double share = 1.0 / static_cast<double>(band.particles.size());
    for (const std::uint32_t p : band.particles) {
        crack.start_height += share * lattice.height_share(p);
        crack.position += share * lattice.behind_front(p);
    }
    return crack;
}

}  // namespace

std::optional<FirstCrack> first_crack(const IceAtRest& ice, const FirstCrackSettings& settings) {
    assert(ice.points.size() == 3 * ice.failure_time.size() && settings.spacing > 0.0);
    if (ice.failure_time.empty()) return {};
    const Lattice lattice(ice.points, settings.spacing);
    std::vector<std::uint32_t> failed;
    for (std::uint32_t p = 0; p < ice.failure_time.size(); ++p) {
        if (!std::isnan(ice.failure_time[p]) && lattice.above_base(p) > settings.layer * lattice.height())
            failed.push_back(p);
    }
    const auto links = make_links(ice, failed, settings.reach * settings.spacing);
    Bands bands(lattice, ice.failure_time.size());
    // A band of n rows has n − 1 spacings between the first and the last.
    const double extent = settings.extent * lattice.height() - settings.spacing;
    auto band = find_band(links, failed, extent - 1e-6 * settings.spacing, bands);
    if (!band) return {};
    return measure(ice, lattice, std::move(*band));
}

}  // namespace tidewater::analysis
