#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "geometry/crevasses.h"
#include "geometry/notch.h"

namespace tidewater::geometry {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

// The crevasse's notch at a place along it.
struct Section {
    double across, slope;
    Notch notch;
};

Section section(const Crevasses& crevasses, const Crevasse& crevasse, double along) {
    const CrevasseKnot* knot = &crevasses.knots[crevasse.knot];
    if (crevasse.knots == 1) return {knot->across, 0.0, Notch(knot->depth, knot->opening)};
    const double last = static_cast<double>(crevasse.knots - 1);
    const double place =
        std::clamp((along - crevasse.from) / (crevasse.to - crevasse.from) * last, 0.0, last);
    const double before = std::min(std::floor(place), last - 1.0), share = place - before;
    knot += static_cast<std::size_t>(before);
    const auto between = [&](double CrevasseKnot::*part) {
        return knot[0].*part + share * (knot[1].*part - knot[0].*part);
    };
    return {between(&CrevasseKnot::across), between(&CrevasseKnot::slope),
            Notch(between(&CrevasseKnot::depth), between(&CrevasseKnot::opening))};
}

// The distance in the section's plane, shortened by what the walls may turn on the way there. It changes
// along the trace by at most `slope` per m; that slope holds at the place and grows with the way.
double signed_distance(const Crevasses& crevasses, const Crevasse& crevasse, double across, double along,
                       double below) {
    const Section at = section(crevasses, crevasse, along);
    const double flat = at.notch.signed_distance(std::abs(across - at.across), below);
    const double slope = std::min(crevasses.steepest, at.slope + crevasses.slope_growth * std::abs(flat));
    const double beyond = std::max({crevasse.from - along, along - crevasse.to, 0.0});
    const bool closed = at.notch.half < 1e-9;
    return std::max(flat / std::sqrt(1.0 + slope * slope), closed ? beyond : -infinite);
}

// To the nearest crevasse of a trace, if nearer than `best`.
double nearest_of_trace(const Crevasses& crevasses, std::size_t trace, double across, double along,
                        double below, double best) {
    const auto begin = crevasses.list.begin() + static_cast<long>(crevasses.first[trace]);
    const auto end = crevasses.list.begin() + static_cast<long>(crevasses.first[trace + 1]);
    if (std::next(begin) == end)  // it may go on beyond its ends
        return std::min(best, signed_distance(crevasses, *begin, across, along, below));
    const auto next =
        std::find_if(begin, end, [&](const Crevasse& crevasse) { return crevasse.to >= along; });
    for (auto it = next; it != end && it->from - along < best; ++it)
        best = std::min(best, signed_distance(crevasses, *it, across, along, below));
    for (auto it = next; it != begin && along - std::prev(it)->to < best; --it)
        best = std::min(best, signed_distance(crevasses, *std::prev(it), across, along, below));
    return best;
}

// Where a trace crosses y = 0 and y = width, along it.
std::array<double, 2> sides(const Crevasses& crevasses, std::size_t trace) {
    const auto [cosine, sine] = crevasses.axis;
    const double middle = crevasses.traces[trace] * sine / cosine;
    const double half = 0.5 * crevasses.settings.width / cosine;
    return {middle - half, middle + half};
}

CrevasseStatistics::Range range_of(const std::vector<double>& values) {
    if (values.empty()) return {};
    const auto [least, greatest] = std::minmax_element(values.begin(), values.end());
    const double sum = std::accumulate(values.begin(), values.end(), 0.0);
    return {sum / static_cast<double>(values.size()), *least, *greatest};
}

// Between two places along the trace.
double volume(const Crevasses& crevasses, const Crevasse& crevasse, const std::array<double, 2>& sides) {
    if (crevasse.knots == 1) return section(crevasses, crevasse, 0.0).notch.area();
    // Gauss's three points on each piece between knots.
    constexpr std::array<std::array<double, 2>, 3> gauss{
        {{0.5 - 0.3872983346207417, 5.0 / 18.0}, {0.5, 8.0 / 18.0}, {0.5 + 0.3872983346207417, 5.0 / 18.0}}};
    const double step = (crevasse.to - crevasse.from) / static_cast<double>(crevasse.knots - 1);
    double sum = 0.0;
    for (std::size_t n = 0; n + 1 < crevasse.knots; ++n) {
        const double begin = crevasse.from + static_cast<double>(n) * step;
        const double from = std::max(begin, sides[0]), length = std::min(begin + step, sides[1]) - from;
        if (length <= 0.0) continue;
        for (const auto& [place, weight] : gauss)
            sum += weight * length * section(crevasses, crevasse, from + place * length).notch.area();
    }
    return sum;
}

}  // namespace

// Traces farther away than the nearest walls found, even if their distance is shortened, cannot be nearer.
double signed_distance(const Crevasses& crevasses, double x, double y, double below) {
    const auto [cosine, sine] = crevasses.axis;
    const double across = x * cosine - (y - 0.5 * crevasses.settings.width) * sine;
    const double along = x * sine + (y - 0.5 * crevasses.settings.width) * cosine;
    const double reach = crevasses.settings.wander + 0.5 * crevasses.settings.opening[1];
    const double shorten = 1.0 / std::sqrt(1.0 + crevasses.steepest * crevasses.steepest);
    const auto least = [&](std::size_t trace) {
        return shorten * (std::abs(crevasses.traces[trace] - across) - reach);
    };
    const auto next =
        static_cast<std::size_t>(std::lower_bound(crevasses.traces.begin(), crevasses.traces.end(), across) -
                                 crevasses.traces.begin());
    double best = infinite;
    std::size_t up = next, down = next;
    while (true) {
        const bool go_up = up < crevasses.traces.size() && least(up) < best;
        const bool go_down = down > 0 && least(down - 1) < best;
        if (!go_up && !go_down) return best;
        if (go_up && (!go_down || least(up) <= least(down - 1)))
            best = nearest_of_trace(crevasses, up++, across, along, below, best);
        else
            best = nearest_of_trace(crevasses, --down, across, along, below, best);
    }
}

CrevasseStatistics statistics(const Crevasses& crevasses) {
    CrevasseStatistics result;
    result.count = crevasses.list.size();
    std::vector<double> depths, openings, spacings;
    for (const Crevasse& crevasse : crevasses.list) {
        depths.push_back(crevasse.depth);
        openings.push_back(crevasse.opening);
        result.volume += volume(crevasses, crevasse, sides(crevasses, crevasse.trace));
    }
    for (std::size_t n = 1; n < crevasses.traces.size(); ++n)
        spacings.push_back((crevasses.traces[n] - crevasses.traces[n - 1]) / crevasses.axis[0]);
    result.depth = range_of(depths);
    result.opening = range_of(openings);
    result.spacing = range_of(spacings);
    return result;
}

}  // namespace tidewater::geometry
