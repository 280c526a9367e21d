#include "analysis/first_wave.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "analysis/wave.h"

namespace tidewater::analysis {
namespace {

constexpr double smoothing = 0.1;             // deviation along x, in D
constexpr double least_smoothing = 2.0;       // and at least so many cells
constexpr double noise = 0.02;                // in cells: a smaller fall is none
constexpr double least_height = 0.04;         // of a leading crest, in cells
constexpr double leading_share = 0.15;        // and of the highest crest
constexpr double far_enough = 1.0;            // from the source, for the highest crest, in D
constexpr double wall_share = 0.2;            // at the wall, of the leading crest
constexpr double crest_fit = 0.1;             // the parabola's reach below a crest, of its height
constexpr double peak_fit = 0.02;             // likewise over time, of the greatest amplitude
constexpr double fastest = 1.6, slack = 0.1;  // of a crest, in √(gD) Δt and D
constexpr double greatest_fall = 3.0;         // of its height from one profile to the next that has it
constexpr std::size_t longest_gap = 2;        // profiles in a row without it
constexpr std::size_t recent = 5;             // points that tell its speed
constexpr double formed_distance = 2.0;       // in D
constexpr double least_run = 1.0;             // in D, for a celerity
constexpr std::size_t least_points = 4;

// The water from the wall inward to the source or to what covers it.
struct Outside {
    double time;
    std::vector<double> from_wall;  // m, rising
    std::vector<double> value;      // η, smoothed, m
};

// What is known of one time.
struct Frame {
    std::vector<CrestPoint> crests;     // from the wall inward
    std::optional<CrestPoint> leading;  // one of them
    bool wall_is_reached = false;
};

double median(std::span<const double> values) {
    std::vector<double> known;
    std::ranges::copy_if(values, std::back_inserter(known), [](double v) { return !std::isnan(v); });
    if (known.empty()) return 0.0;
    const auto middle = known.begin() + static_cast<std::ptrdiff_t>(known.size() / 2);
    std::ranges::nth_element(known, middle);
    return *middle;
}

double direction(const FirstWaveSettings& settings) { return settings.wall > settings.source ? 1.0 : -1.0; }

Outside look_outside(std::span<const double> x, const SurfaceProfile& profile, double rest,
                     const FirstWaveSettings& settings) {
    const double deviation = std::max(smoothing * settings.depth, least_smoothing * settings.cell_size);
    const std::vector<double> smoothed = smooth(x, profile.elevation, deviation);
    const double outward = direction(settings);
    Outside outside{profile.time, {}, {}};
    for (std::size_t n = 0; n < x.size(); ++n) {
        const std::size_t i = outward > 0.0 ? x.size() - 1 - n : n;
        const double from_wall = outward * (settings.wall - x[i]);
        if (from_wall < 0.0) continue;
        if (std::isnan(smoothed[i]) || outward * (x[i] - settings.source) < 0.0) break;
        outside.from_wall.push_back(from_wall);
        outside.value.push_back(smoothed[i] - rest);
    }
    return outside;
}

// All crests from the wall inward, the last maybe a hump at the inner end.
std::vector<std::size_t> find_crests(const std::vector<double>& value, double drop) {
    std::vector<double> upside_down;
    for (const double v : value) upside_down.push_back(-v);
    std::vector<std::size_t> crests;
    std::size_t trough = 0;
    while (trough < value.size()) {
        const std::size_t crest = find_crest(value, trough, drop);
        if (crest == value.size()) {
            const auto hump =
                std::max_element(value.begin() + static_cast<std::ptrdiff_t>(trough), value.end());
            if (*hump > value[trough] + drop)
                crests.push_back(static_cast<std::size_t>(hump - value.begin()));
            break;
        }
        crests.push_back(crest);
        trough = find_crest(upside_down, crest, drop);
    }
    return crests;
}

Frame look_at(const Outside& outside, const FirstWaveSettings& settings) {
    Frame frame;
    double highest = 0.0;
    for (const std::size_t peak : find_crests(outside.value, noise * settings.cell_size)) {
        const double height = outside.value[peak];
        if (!(height > least_height * settings.cell_size)) continue;
        const Extremum fit = fit_crest(outside.from_wall, outside.value, peak, crest_fit * height);
        const double x = settings.wall - direction(settings) * fit.time;
        const double distance = direction(settings) * (x - settings.source);
        frame.crests.push_back({outside.time, x, distance, fit.value});
        if (distance > far_enough * settings.depth) highest = std::max(highest, fit.value);
    }
    const auto leading = std::ranges::find_if(
        frame.crests, [&](const CrestPoint& crest) { return crest.amplitude > leading_share * highest; });
    if (leading == frame.crests.end()) return frame;
    frame.leading = *leading;
    frame.wall_is_reached = std::abs(outside.value.front()) > wall_share * leading->amplitude;
    return frame;
}

// Of the track's first points, where it is still to be followed backward from; `usual` with one point.
double recent_speed(const std::vector<CrestPoint>& backward, double usual) {
    if (backward.size() < 2) return usual;
    const CrestPoint& late = backward[backward.size() - std::min(backward.size(), recent)];
    const CrestPoint& early = backward.back();
    return std::clamp((late.distance - early.distance) / (late.time - early.time), 0.0, fastest * usual);
}

std::vector<CrestPoint> follow_back(std::span<const Frame> frames, std::span<const SurfaceProfile> profiles,
                                    std::size_t last, const FirstWaveSettings& settings) {
    const double usual = long_wave_celerity(settings.depth, settings.gravity);
    std::vector<CrestPoint> track{*frames[last].leading};
    std::size_t gap = 0;
    for (std::size_t k = last; k-- > 0 && gap <= longest_gap;) {
        const CrestPoint& from = track.back();
        const double dt = from.time - profiles[k].time, room = slack * settings.depth;
        const double expected = from.distance - recent_speed(track, usual) * dt;
        const CrestPoint* nearest = nullptr;
        for (const CrestPoint& crest : frames[k].crests) {
            const double moved = from.distance - crest.distance;
            if (moved > fastest * usual * dt + room || moved < -room) continue;
            if (crest.amplitude > greatest_fall * from.amplitude) continue;
            if (!nearest || std::abs(crest.distance - expected) < std::abs(nearest->distance - expected))
                nearest = &crest;
        }
        gap = nearest ? 0 : gap + 1;
        if (nearest) track.push_back(*nearest);
    }
    std::ranges::reverse(track);
    return track;
}

std::vector<CrestPoint> longest_track(std::span<const Frame> frames, std::span<const SurfaceProfile> profiles,
                                      const FirstWaveSettings& settings) {
    std::vector<CrestPoint> longest;
    for (std::size_t k = frames.size(); k > longest.size(); --k) {
        if (!frames[k - 1].leading) continue;
        std::vector<CrestPoint> track = follow_back(frames, profiles, k - 1, settings);
        if (track.size() > longest.size()) longest = std::move(track);
    }
    return longest;
}

// Between the track's points, linearly.
CrestPoint point_at(const std::vector<CrestPoint>& track, double time, double amplitude) {
    const auto after = std::ranges::lower_bound(track, time, {}, &CrestPoint::time);
    if (after == track.begin()) return {time, after->x, after->distance, amplitude};
    const CrestPoint &a = *(after - 1), &b = after == track.end() ? track.back() : *after;
    const double share = b.time > a.time ? (time - a.time) / (b.time - a.time) : 0.0;
    return {time, a.x + share * (b.x - a.x), a.distance + share * (b.distance - a.distance), amplitude};
}

CrestPoint find_greatest(const std::vector<CrestPoint>& track) {
    std::vector<double> time, amplitude;
    for (const CrestPoint& point : track) {
        time.push_back(point.time);
        amplitude.push_back(point.amplitude);
    }
    const auto peak = static_cast<std::size_t>(std::ranges::max_element(amplitude) - amplitude.begin());
    const Extremum greatest = fit_crest(time, amplitude, peak, peak_fit * amplitude[peak]);
    return point_at(track, greatest.time, greatest.value);
}

void fit_celerity(const FirstWaveSettings& settings, FirstWave& wave) {
    std::vector<CrestPoint> formed;
    for (const CrestPoint& point : wave.track) {
        if (point.time >= wave.greatest.time && point.distance >= formed_distance * settings.depth)
            formed.push_back(point);
    }
    if (formed.empty()) return;
    wave.formed = formed.front().time;
    if (formed.size() < least_points ||
        formed.back().distance - formed.front().distance < least_run * settings.depth)
        return;
    double mean_t = 0.0, mean_d = 0.0;
    const auto count = static_cast<double>(formed.size());
    for (const CrestPoint& point : formed) {
        mean_t += point.time / count;
        mean_d += point.distance / count;
    }
    double tt = 0.0, td = 0.0;
    for (const CrestPoint& point : formed) {
        tt += (point.time - mean_t) * (point.time - mean_t);
        td += (point.time - mean_t) * (point.distance - mean_d);
    }
    wave.celerity = td / tt;
}

}  // namespace

FirstWave follow_first_wave(std::span<const double> x, std::span<const SurfaceProfile> profiles,
                            const FirstWaveSettings& settings) {
    assert(settings.depth > 0.0 && settings.gravity > 0.0 && settings.cell_size > 0.0);
    assert(settings.wall != settings.source);
    FirstWave wave;
    if (profiles.empty()) return wave;
    const double rest = median(profiles.front().elevation);
    std::vector<Frame> frames;
    for (const SurfaceProfile& profile : profiles) {
        assert(profile.elevation.size() == x.size());
        frames.push_back(look_at(look_outside(x, profile, rest, settings), settings));
        if (!frames.back().wall_is_reached) continue;
        frames.pop_back();
        break;
    }
    wave.track = longest_track(frames, profiles, settings);
    if (wave.track.empty()) return wave;
    wave.greatest = find_greatest(wave.track);
    fit_celerity(settings, wave);
    return wave;
}

double linear_crest_distance(double depth, double gravity, double time) {
    constexpr double crest_of_airy = -1.0187929716;  // where Ai is greatest
    const double celerity = long_wave_celerity(depth, gravity);
    return celerity * time + crest_of_airy * std::cbrt(0.5 * celerity * depth * depth * time);
}

double amplitude_at(const FirstWave& wave, double distance) {
    for (std::size_t i = wave.track.size(); i-- > 1;) {
        const CrestPoint &a = wave.track[i - 1], &b = wave.track[i];
        if (!(a.distance <= distance && distance <= b.distance)) continue;
        const double share =
            b.distance > a.distance ? (distance - a.distance) / (b.distance - a.distance) : 0.0;
        return a.amplitude + share * (b.amplitude - a.amplitude);
    }
    return none;
}

}  // namespace tidewater::analysis
