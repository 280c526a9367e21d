#include "geometry/crevasses.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <span>

#include "core/error.h"
#include "core/random.h"
#include "geometry/noise.h"
#include "geometry/notch.h"

namespace tidewater::geometry {
namespace {

constexpr double variation = 1.0 / 3.0;
constexpr double bridge_share = 1.0 / 6.0;  // whole ice between crevasses of a trace, of their length
constexpr double least_bridge = 0.25;       // between traces, of the greatest opening
constexpr double least_length = 2.0;        // of a crevasse that ends, of the greatest depth
constexpr double most_jitter = 0.3;         // of a trace's place, of the spacing
constexpr double coherence = 4.0;           // wavelengths across over which traces meander together
constexpr double knots_per_wavelength = 16.0;
constexpr double infinite = std::numeric_limits<double>::infinity();

// What the noise is asked for.
enum class Field : std::uint64_t { jitter, wander, depth, opening, depth_along, opening_along, cuts };

std::uint64_t field_seed(const CrevasseSettings& settings, Field field) {
    return mix64(settings.seed ^ mix64(0x6372657600ULL + static_cast<std::uint64_t>(field)));
}

double wander_at(const CrevasseSettings& s, double along, double across) {
    if (s.wander == 0.0) return 0.0;
    return s.wander * simplex_noise(field_seed(s, Field::wander), along / s.wavelength,
                                    across / (coherence * s.wavelength));
}

std::string meters(double value) {
    std::string text = std::to_string(std::round(100.0 * value) / 100.0);
    return text.substr(0, text.find('.') + 3) + " m";
}

void require(bool right, const std::string& line) {
    if (!right) throw SceneError("crevasses: " + line);
}

void check(const CrevasseSettings& s) {
    require(s.depth[0] > 0.0 && s.depth[1] >= s.depth[0], "depth must be a range above 0, least first");
    require(s.opening[0] > 0.0 && s.opening[1] >= s.opening[0],
            "opening must be a range above 0, least first");
    require(s.depth[0] >= 0.5 * s.opening[1], "depth " + meters(s.depth[0]) +
                                                  " is less than half the opening " + meters(s.opening[1]) +
                                                  "; make them deeper or narrower");
    require(s.spacing > 0.0, "spacing must be above 0");
    require(std::abs(s.angle) <= 80.0, "angle must lie between -80 and 80 degrees");
    require(s.wander >= 0.0 && s.length >= 0.0 && s.width >= 0.0,
            "wander, length and width must not be negative");
    require(s.width == 0.0 || s.wavelength > 0.0, "wavelength must be above 0");
    require(s.width > 0.0 || s.angle == 0.0, "in 2D, angle must be 0");
    require(s.length == 0.0 || s.length >= least_length * s.depth[1],
            "a length of " + meters(s.length) + " is less than twice the depth " + meters(s.depth[1]) +
                "; make them longer or shallower");
    require(s.to - s.from >= s.opening[1], "the stretch from " + meters(s.from) + " to " + meters(s.to) +
                                               " has no room for one; move from or to");
}

// By how much traces may leave even places, m across, so that crevasses stay apart.
double jitter_room(const CrevasseSettings& s, double cosine) {
    const double drift = s.wander == 0.0 ? 0.0 : plane_noise_slope * s.wander / (coherence * s.wavelength);
    const double needed = (1.0 + least_bridge) * s.opening[1] / (1.0 - drift);
    const double room = s.spacing * cosine - needed;
    require(drift < 1.0, "wander " + meters(s.wander) + " over a wavelength of " + meters(s.wavelength) +
                             " makes traces cross; lower it below " +
                             meters(coherence / plane_noise_slope * s.wavelength));
    require(room >= 0.0, "with openings up to " + meters(s.opening[1]) +
                             " they would overlap at a spacing of " + meters(s.spacing) +
                             "; it must be at least " + meters(needed / cosine) +
                             (s.wander > 0.0 ? ", or wander less" : ""));
    return std::min(most_jitter * s.spacing * cosine, 0.5 * room);
}

// The k-th of `count` values by rank, in the middle of its share of the range.
std::vector<double> spread_by_rank(const std::vector<double>& values, const std::array<double, 2>& range) {
    std::vector<std::size_t> order(values.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return values[a] < values[b]; });
    std::vector<double> spread(values.size());
    for (std::size_t rank = 0; rank < order.size(); ++rank) {
        const double share = (static_cast<double>(rank) + 0.5) / static_cast<double>(order.size());
        spread[order[rank]] = range[0] + share * (range[1] - range[0]);
    }
    return spread;
}

// A stretch along a trace.
struct Stretch {
    double from = 0.0, to = 0.0;

    Stretch shared(const Stretch& other) const {
        return {std::max(from, other.from), std::min(to, other.to)};
    }
    double length() const { return to - from; }
};

// Which part of the trace that crosses the middle of the width at `across` lies on the glacier, y, and which
// between `from` and `to`, x.
struct Region {
    Stretch y, x;

    Region(const CrevasseSettings& s, const std::array<double, 2>& axis, double across) {
        const auto [cosine, sine] = axis;
        const double middle = across * sine / cosine, half = 0.5 * s.width / cosine;
        y = {middle - half, middle + half};
        const double margin = 0.5 * s.opening[1] / cosine, place = across * cosine;
        const double low = s.from + margin - place, high = s.to - margin - place;
        x = {-infinite, infinite};
        if (sine != 0.0)
            x = {std::min(low / sine, high / sine), std::max(low / sine, high / sine)};
        else if (low > 0.0 || high < 0.0)
            x = {0.0, -1.0};
    }
};

struct Taper {
    double from = 0.0, to = 0.0;  // m from the ends; 0: none
};

double taper(const Taper& taper, const Stretch& stretch, double along) {
    const auto ease = [](double way, double length) {
        const double rest = length > 0.0 ? 1.0 - std::clamp(way / length, 0.0, 1.0) : 0.0;
        return 1.0 - rest * rest;
    };
    return ease(along - stretch.from, taper.from) * ease(stretch.to - along, taper.to);
}

struct Piece {
    std::size_t trace;
    Stretch stretch;
    Taper taper;
};

// Across the whole width, or cut where the seed says.
std::vector<Piece> cut(const CrevasseSettings& s, const Region& region, std::size_t trace, double across) {
    std::vector<Piece> pieces;
    if (s.length == 0.0 || s.width == 0.0) {
        const Stretch all = region.y.shared(region.x);
        const bool whole = all.length() == region.y.length();
        if (!whole && all.length() < least_length * s.depth[1]) return {};
        const double way = std::min(0.5 * all.length(), 3.0 * s.depth[1]);
        return {{trace, all, {all.from > region.y.from ? way : 0.0, all.to < region.y.to ? way : 0.0}}};
    }
    const double bridge = bridge_share * s.length, pitch = s.length + bridge;
    const auto stream = static_cast<std::uint64_t>(std::llround(across));
    const auto end = [&](long k) {
        const double u = random_uniform(field_seed(s, Field::cuts), stream, static_cast<std::uint64_t>(k));
        return region.y.from + (static_cast<double>(k) - 2.0 + 0.5 * u) * pitch;
    };
    for (long k = 0; end(k) < region.y.to; ++k) {
        const Stretch piece = Stretch{end(k), end(k + 1) - bridge}.shared(region.x);
        const double inside = piece.shared(region.y).length();
        if (inside <= 0.0 || piece.length() < least_length * s.depth[1]) continue;
        pieces.push_back({trace, piece, {0.5 * piece.length(), 0.5 * piece.length()}});
    }
    return pieces;
}

// Depth and opening along the crevasse, each at most its greatest.
std::vector<CrevasseKnot> make_knots(const CrevasseSettings& s, const Piece& piece, double across,
                                     const Crevasse& crevasse) {
    if (s.width == 0.0) return {{across + wander_at(s, 0.0, across), crevasse.depth, crevasse.opening, 0.0}};
    const double length = piece.stretch.length();
    const auto count =
        static_cast<std::size_t>(std::max(16.0, std::ceil(length * knots_per_wavelength / s.wavelength)));
    std::vector<CrevasseKnot> knots(count + 1);
    CrevasseKnot most;
    for (std::size_t n = 0; n <= count; ++n) {
        const double along =
            piece.stretch.from + length * static_cast<double>(n) / static_cast<double>(count);
        const auto share = [&](Field field) {
            const double noise = simplex_noise(field_seed(s, field), along / s.wavelength,
                                               static_cast<double>(crevasse.trace) * std::numbers::pi);
            return taper(piece.taper, piece.stretch, along) * (1.0 - 0.5 * variation * (1.0 + noise));
        };
        knots[n] = {across + wander_at(s, along, across), share(Field::depth_along),
                    share(Field::opening_along), 0.0};
        most.depth = std::max(most.depth, knots[n].depth);
        most.opening = std::max(most.opening, knots[n].opening);
    }
    for (CrevasseKnot& knot : knots) {
        knot.depth *= crevasse.depth / most.depth;
        knot.opening *= crevasse.opening / most.opening;
    }
    return knots;
}

// How far the notch's outline moves per m along the trace, at most: its upper edges, and its tip's circle.
double segment_slope(const CrevasseKnot& a, const CrevasseKnot& b, double step) {
    const double across = std::abs(b.across - a.across), half = 0.5 * std::abs(b.opening - a.opening);
    const double radius = Notch::tip_share * (b.opening - a.opening), center = b.depth - a.depth - radius;
    return std::max(across + half, std::hypot(across, center) + std::abs(radius)) / step;
}

struct Trail {
    std::span<CrevasseKnot> knots;
    double step;  // m between two
};

Trail trail(Crevasses& crevasses, const Crevasse& crevasse) {
    const auto pieces = static_cast<double>(std::max<std::size_t>(crevasse.knots, 2) - 1);
    return {std::span(crevasses.knots).subspan(crevasse.knot, crevasse.knots),
            (crevasse.to - crevasse.from) / pieces};
}

// At each knot the greater of its two segments', then raised until it falls by no more than slope_growth.
void bound_slopes(Crevasses& crevasses) {
    for (const Crevasse& crevasse : crevasses.list) {
        const auto [knots, step] = trail(crevasses, crevasse);
        for (std::size_t n = 1; n < knots.size(); ++n) {
            const double slope = segment_slope(knots[n - 1], knots[n], step);
            knots[n - 1].slope = std::max(knots[n - 1].slope, slope);
            knots[n].slope = slope;
            crevasses.steepest = std::max(crevasses.steepest, slope);
        }
    }
    if (crevasses.settings.width == 0.0) return;
    crevasses.slope_growth = 4.0 * crevasses.steepest / crevasses.settings.wavelength;
    for (const Crevasse& crevasse : crevasses.list) {
        const auto [knots, step] = trail(crevasses, crevasse);
        const double fall = crevasses.slope_growth * step;
        for (std::size_t n = 1; n < knots.size(); ++n)
            knots[n].slope = std::max(knots[n].slope, knots[n - 1].slope - fall);
        for (std::size_t n = knots.size() - 1; n > 0; --n)
            knots[n - 1].slope = std::max(knots[n - 1].slope, knots[n].slope - fall);
    }
}

// At even places, moved; the first and the last stay, so that the mean spacing is as asked.
std::vector<double> place_traces(const CrevasseSettings& s, const std::array<double, 2>& axis) {
    const auto [cosine, sine] = axis;
    const double jitter = jitter_room(s, cosine), room = s.to - s.from;
    const long count = std::max(1L, static_cast<long>(std::floor(room / s.spacing + 1e-9)));
    const double begin = s.from + 0.5 * (room - static_cast<double>(count - 1) * s.spacing);
    const long beside = static_cast<long>(std::ceil(0.5 * s.width * std::abs(sine) / cosine / s.spacing));
    std::vector<double> traces;
    std::vector<std::uint64_t> counters;
    for (long k = -beside; k < count + beside; ++k) {
        const double across = (begin + static_cast<double>(k) * s.spacing) * cosine;
        if (cut(s, Region(s, axis, across), 0, across).empty()) continue;
        traces.push_back(across);
        counters.push_back(static_cast<std::uint64_t>(k));
    }
    for (std::size_t n = 1; n + 1 < traces.size(); ++n)
        traces[n] += jitter * (2.0 * random_uniform(field_seed(s, Field::jitter), 0, counters[n]) - 1.0);
    return traces;
}

}  // namespace

Crevasses make_crevasses(const CrevasseSettings& settings) {
    check(settings);
    Crevasses result;
    result.settings = settings;
    const double angle = settings.angle * std::numbers::pi / 180.0;
    result.axis = {std::cos(angle), settings.angle == 0.0 ? 0.0 : std::sin(angle)};
    std::vector<Piece> pieces;
    for (const double across : place_traces(settings, result.axis)) {
        const auto cuts = cut(settings, Region(settings, result.axis, across), result.traces.size(), across);
        if (cuts.empty()) continue;
        pieces.insert(pieces.end(), cuts.begin(), cuts.end());
        result.traces.push_back(across);
    }
    require(!pieces.empty(), "none fits between " + meters(settings.from) + " and " + meters(settings.to) +
                                 "; give them more room, or make them shorter");

    std::vector<double> depths, openings;
    for (const Piece& piece : pieces) {
        const double across = result.traces[piece.trace] / (3.0 * settings.spacing);
        const double along = 0.5 * (piece.stretch.from + piece.stretch.to) / (3.0 * settings.spacing);
        depths.push_back(simplex_noise(field_seed(settings, Field::depth), across, along));
        openings.push_back(simplex_noise(field_seed(settings, Field::opening), across, along));
    }
    depths = spread_by_rank(depths, settings.depth);
    openings = spread_by_rank(openings, settings.opening);
    for (std::size_t n = 0; n < pieces.size(); ++n) {
        while (result.first.size() <= pieces[n].trace) result.first.push_back(n);
        const Stretch& stretch = pieces[n].stretch;
        Crevasse crevasse{
            depths[n], openings[n], stretch.from, stretch.to, pieces[n].trace, result.knots.size(), 1};
        const auto knots = make_knots(settings, pieces[n], result.traces[pieces[n].trace], crevasse);
        crevasse.knots = knots.size();
        result.knots.insert(result.knots.end(), knots.begin(), knots.end());
        result.list.push_back(crevasse);
    }
    result.first.push_back(pieces.size());
    bound_slopes(result);
    return result;
}

}  // namespace tidewater::geometry
