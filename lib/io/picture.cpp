#include "io/picture.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/types.h"
#include "io/axis.h"
#include "io/picture_notes.h"
#include "io/text.h"

namespace tidewater::io {
namespace {

// In 2D what is beyond the frame is cut off.
void draw_substances(Drawing& drawing, const PictureParticles& particles, const PictureSettings& settings,
                     const Layout& layout) {
    const bool flat = settings.dimension == 2;
    const Pixel shift = flat ? layout.low : Pixel{};
    View view = layout.view;
    view.origin = {view.origin.x - shift.x, view.origin.y - shift.y};
    const auto whole = [](double length) { return std::max(static_cast<int>(std::lround(length)), 1); };
    const int width = flat ? whole(layout.high.x - layout.low.x) : layout.width;
    const int height = flat ? whole(layout.high.y - layout.low.y) : layout.height;
    drawing.image(draw_particles(particles, view, width, height, settings.particle_spacing,
                                 settings.greatest_speed, 1.5 * layout.unit, !flat),
                  shift);
}

// Height of the ground between its corners, which rise in x; level beyond them.
double ground_at(const PictureSettings& settings, double place) {
    const auto& x = settings.ground_x;
    const auto& z = settings.ground_z;
    const auto next = static_cast<std::size_t>(std::ranges::upper_bound(x, place) - x.begin());
    if (next == 0) return z.front();
    if (next == x.size()) return z.back();
    return z[next - 1] + (z[next] - z[next - 1]) * (place - x[next - 1]) / (x[next] - x[next - 1]);
}

// The ground as a filled shape from the tank's bottom up, with a corner at each pixel.
void draw_ground(Drawing& drawing, const PictureSettings& settings, const Layout& layout) {
    if (settings.dimension != 2 || settings.ground_x.empty()) return;
    const double bottom = settings.low[2];
    const auto at = [&](double x, double z) { return layout.view.project({x, 0.0, z}); };
    const Pixel left = at(settings.low[0], bottom), right = at(settings.high[0], bottom);
    std::vector<Pixel> top;
    const auto pixels = static_cast<int>(std::ceil(right.x - left.x));
    for (int i = 0; i <= pixels; ++i) {
        const double x = std::lerp(settings.low[0], settings.high[0], static_cast<double>(i) / pixels);
        top.push_back(at(x, std::clamp(ground_at(settings, x), bottom, settings.high[2])));
    }
    std::vector<Pixel> corners = top;
    corners.insert(corners.end(), {right, left});
    drawing.polygon(corners, palette::ground);
    drawing.polyline(top, 1.5 * layout.unit, palette::ink);
}

void draw_axes(Drawing& drawing, const PictureSettings& settings, const Layout& layout) {
    const double u = layout.unit, thin = 1.5 * u;
    const auto& view = layout.view;
    const auto &low = settings.low, &high = settings.high;
    const Pixel left = view.project(low), right = view.project({high[0], low[1], low[2]});
    const Pixel upper = view.project({low[0], low[1], high[2]});
    const Ticks along =
        make_ticks(low[0], high[0], std::max(2, static_cast<int>((right.x - left.x) / (85 * u))));
    for (std::size_t i = 0; i < along.values.size(); ++i) {
        const Pixel at = view.project({along.values[i], low[1], low[2]});
        drawing.line(at, {at.x, at.y + 6 * u}, thin, palette::ink);
        drawing.text({at.x, at.y + 20 * u}, Align::center, layout.letters, along.labels[i]);
    }
    drawing.text({0.5 * (left.x + right.x), 0.5 * (left.y + right.y) + 48 * u}, Align::center, layout.letters,
                 "x (m)");
    const Ticks upward =
        make_ticks(low[2], high[2], std::max(2, static_cast<int>((left.y - upper.y) / (50 * u))));
    for (std::size_t i = 0; i < upward.values.size(); ++i) {
        const Pixel at = view.project({low[0], low[1], upward.values[i]});
        drawing.line({at.x - 6 * u, at.y}, at, thin, palette::ink);
        drawing.text({at.x - 11 * u, at.y}, Align::right, layout.letters, upward.labels[i]);
    }
    drawing.text({upper.x - 6 * u, upper.y - 22 * u}, Align::right, layout.letters, "z (m)");
}

// The edges of the tank's box: those behind the particles or those before them.
void draw_edges(Drawing& drawing, const PictureSettings& settings, const Layout& layout, bool front) {
    for (int a = 0; a < 8; ++a) {
        for (const int axis : {1, 2, 4}) {
            const int b = a | axis;
            if (b == a || (settings.dimension == 2 && ((a | b) & 2))) continue;
            const bool behind = settings.dimension == 3 && (a & 2) && (b & 2) && !((a & 4) && (b & 4));
            const bool far_left = settings.dimension == 3 && axis == 2 && !(a & 1) && !(a & 4);
            if ((behind || far_left) == front) continue;
            drawing.line(layout.view.project(corner(settings, a)), layout.view.project(corner(settings, b)),
                         1.5 * layout.unit, palette::ink, front ? 1.0 : 0.35);
        }
    }
}

void draw_still_level(Drawing& drawing, const PictureSettings& settings, const Layout& layout) {
    const double u = layout.unit;
    const auto &low = settings.low, &high = settings.high;
    if (settings.still_level < low[2] || settings.still_level > high[2]) return;
    const Pixel from = layout.view.project({low[0], low[1], settings.still_level});
    const Pixel to = layout.view.project({high[0], low[1], settings.still_level});
    drawing.line(from, to, 2.5 * u, palette::paper, 0.35);
    drawing.dashed_line(from, to, 1.6 * u, 10 * u, 7 * u, palette::ink, 0.85);
}

// Gauges whose names would run into the one before have a mark alone.
void draw_gauges(Drawing& drawing, const PictureSettings& settings, const Layout& layout) {
    const double u = layout.unit;
    std::vector<std::array<double, 2>> gauges = settings.gauges;
    std::ranges::sort(gauges);
    double free_from = 0.0;
    for (const auto& [x, across] : gauges) {
        if (x < settings.low[0] || x > settings.high[0]) continue;
        const double y = settings.dimension == 3 ? across : 0.0;
        const Pixel top = layout.view.project({x, y, settings.high[2]});
        const Pixel tip = layout.view.project({x, y, settings.still_level});
        drawing.dashed_line(top, tip, 1.2 * u, 3 * u, 4 * u, palette::ink, 0.6);
        drawing.triangle({top.x - 6 * u, top.y - 11 * u}, {top.x + 6 * u, top.y - 11 * u}, top, palette::ink);
        const std::string name = "x = " + format_number(x) + " m";
        const double half = 0.5 * text_width(0.9 * layout.letters, name) + 4 * u;
        if (top.x - half < free_from) continue;
        drawing.text({top.x, top.y - 24 * u}, Align::center, 0.9 * layout.letters, name, palette::ink, 4 * u);
        free_from = top.x + half;
    }
}

constexpr std::size_t most_numbers = 12;

struct IcebergPlace {
    std::uint32_t number = 0;
    double particles = 0.0;
    std::array<double, 3> sum{};  // of their positions, m
};

// In the order of their particles' number, the largest first.
std::vector<IcebergPlace> iceberg_places(const PictureParticles& particles) {
    std::vector<IcebergPlace> places;
    for (std::size_t p = 0; p < particles.iceberg.size(); ++p) {
        const std::uint32_t number = particles.iceberg[p];
        if (number == 0) continue;
        if (number > places.size()) places.resize(number);
        IcebergPlace& place = places[number - 1];
        place.number = number;
        place.particles += 1.0;
        for (std::size_t axis = 0; axis < 3; ++axis) place.sum[axis] += particles.points[3 * p + axis];
    }
    std::ranges::stable_sort(places, std::greater{}, &IcebergPlace::particles);
    return places;
}

// At the icebergs' middles; one that would run into a larger iceberg's, or out of the page, is left out.
void draw_iceberg_numbers(Drawing& drawing, const PictureParticles& particles, const Layout& layout) {
    const double size = 0.8 * layout.letters;
    std::vector<Pixel> drawn;
    for (const IcebergPlace& place : iceberg_places(particles)) {
        if (place.number == 0 || drawn.size() == most_numbers) break;
        const Pixel at = layout.view.project(
            {place.sum[0] / place.particles, place.sum[1] / place.particles, place.sum[2] / place.particles});
        const bool outside =
            at.x < layout.low.x || at.x > layout.high.x || at.y < layout.low.y || at.y > layout.high.y;
        const bool taken = std::ranges::any_of(drawn, [&](const Pixel& other) {
            return std::abs(other.x - at.x) < 2.0 * size && std::abs(other.y - at.y) < 1.1 * size;
        });
        if (outside || taken) continue;
        drawing.text(at, Align::center, size, std::to_string(place.number), palette::ink, 3 * layout.unit);
        drawn.push_back(at);
    }
}

}  // namespace

Drawing draw_picture(const PictureParticles& particles, const PictureSettings& settings) {
    assert(settings.width >= 400 && settings.particle_spacing > 0.0 && settings.greatest_speed > 0.0);
    assert(particles.points.size() == 3 * particles.material.size());
    assert(particles.damage.empty() || particles.damage.size() == particles.material.size());
    assert(particles.iceberg.empty() || particles.iceberg.size() == particles.material.size());
    const Layout layout = make_layout(settings);
    Drawing drawing(layout.width, layout.height);
    if (settings.dimension == 2) drawing.rectangle(layout.low, layout.high, palette::air);
    draw_edges(drawing, settings, layout, false);
    draw_substances(drawing, particles, settings, layout);
    draw_ground(drawing, settings, layout);
    draw_edges(drawing, settings, layout, true);
    if (any_of(particles, static_cast<std::uint8_t>(Material::water)))
        draw_still_level(drawing, settings, layout);
    draw_gauges(drawing, settings, layout);
    draw_iceberg_numbers(drawing, particles, layout);
    draw_axes(drawing, settings, layout);
    draw_scale_bar(drawing, settings, layout);
    draw_heading(drawing, particles, settings, layout);
    return drawing;
}

}  // namespace tidewater::io
