#include "io/picture.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

#include "core/types.h"
#include "io/axis.h"
#include "io/splat.h"
#include "io/text.h"

namespace tidewater::io {
namespace {

// Everything about the page is in units of `unit`, one pixel of a page 1600 wide.
struct Layout {
    double unit;
    double letters;     // size of the text
    Pixel low, high;    // corners of the tank's frame (3D: of its silhouette)
    int width, height;  // of the page
    View view;
};

struct PixelBox {
    int left, top, right, bottom;  // right and bottom are not in it
};

std::array<double, 3> corner(const PictureSettings& settings, int index) {
    const auto at = [&](int bit, std::size_t axis) {
        return index & bit ? settings.high[axis] : settings.low[axis];
    };
    return {at(1, 0), at(2, 1), at(4, 2)};
}

// Looking along the tank's width in 2D; in 3D turned by 14° and from 25° above.
View make_view(const PictureSettings& settings) {
    if (settings.dimension == 2) return {};
    const double turn = 14.0 * std::numbers::pi / 180.0, tilt = 25.0 * std::numbers::pi / 180.0;
    const double ct = std::cos(turn), st = std::sin(turn), cp = std::cos(tilt), sp = std::sin(tilt);
    return {.right = {ct, st, 0.0},
            .up = {-st * sp, ct * sp, cp},
            .toward = {st * cp, -ct * cp, sp},
            .origin = {}};
}

Layout make_layout(const PictureSettings& settings) {
    Layout layout;
    layout.width = settings.width;
    layout.unit = settings.width / 1600.0;
    layout.letters = std::max(19.0 * layout.unit, 9.0);
    layout.view = make_view(settings);
    constexpr double far = std::numeric_limits<double>::infinity();
    double left = far, right = -far, top = far, bottom = -far;  // of the silhouette at scale 1
    for (int i = 0; i < 8; ++i) {
        const Pixel p = layout.view.project(corner(settings, i));
        left = std::min(left, p.x);
        right = std::max(right, p.x);
        top = std::min(top, p.y);
        bottom = std::max(bottom, p.y);
    }
    const double u = layout.unit, margin_left = 84 * u, margin_right = 36 * u, margin_top = 134 * u;
    const double room = settings.width - margin_left - margin_right;
    layout.view.scale = std::min(room / (right - left), 1100.0 * u / (bottom - top));
    const double width = layout.view.scale * (right - left), height = layout.view.scale * (bottom - top);
    layout.low = {std::round(margin_left + 0.5 * (room - width)), std::round(margin_top)};
    layout.high = {layout.low.x + width, layout.low.y + height};
    layout.view.origin = {layout.low.x - layout.view.scale * left, layout.low.y - layout.view.scale * top};
    layout.height = static_cast<int>(std::ceil(layout.high.y + 76 * u));
    return layout;
}

Color particle_color(const PictureParticles& particles, std::size_t p, double greatest_speed) {
    switch (static_cast<Material>(particles.material[p])) {
        case Material::rigid:
            return palette::rigid;
        case Material::ice:
            return particles.damage.empty() ? palette::ice : damage_color(particles.damage[p]);
        case Material::water:
            break;
    }
    const float* v = particles.velocity.data() + 3 * p;
    return scale_color(std::hypot(v[0], v[1], v[2]) / greatest_speed);
}

// Whether a sample shows a solid whose edge, against anything else, is within `reach` samples.
bool on_outline(const Raster& raster, const PictureParticles& particles, int i, int j, int reach) {
    constexpr int nothing = -1;
    const auto material_at = [&](int column, int row) {
        if (column < 0 || row < 0 || column >= raster.columns() || row >= raster.rows()) return nothing;
        const auto p =
            raster.particle[static_cast<std::size_t>(row) * static_cast<std::size_t>(raster.columns()) +
                            static_cast<std::size_t>(column)];
        return p == Raster::empty ? nothing : static_cast<int>(particles.material[p]);
    };
    const int own = material_at(i, j);
    if (own == nothing || own == static_cast<int>(Material::water)) return false;
    return material_at(i - reach, j) != own || material_at(i + reach, j) != own ||
           material_at(i, j - reach) != own || material_at(i, j + reach) != own;
}

// In 2D the discs of particles at the walls are cut off at the frame.
PixelBox visible_part(const Canvas& canvas, const PictureSettings& settings, const Layout& layout) {
    if (settings.dimension == 3) return {0, 0, canvas.width(), canvas.height()};
    const auto whole = [](double value) { return static_cast<int>(std::lround(value)); };
    return {whole(layout.low.x), whole(layout.low.y), whole(layout.high.x), whole(layout.high.y)};
}

void draw_particles(Canvas& canvas, const PictureParticles& particles, const PictureSettings& settings,
                    const Layout& layout) {
    // In 2D gaps between particles must close; in 3D others show behind them.
    const double radius = (settings.dimension == 2 ? 1.0 : 0.7) * settings.particle_spacing;
    const Raster raster = splat(particles.points, radius, layout.view, canvas.width(), canvas.height());
    std::vector<float> light;
    if (settings.dimension == 3) light = shading(raster, layout.view, 1.5 * settings.particle_spacing);
    const int reach = std::max(static_cast<int>(std::lround(1.5 * layout.unit * Raster::samples)), 2);
    constexpr double share = 1.0 / (Raster::samples * Raster::samples);
    std::vector<Color> seen;
    const auto frame = visible_part(canvas, settings, layout);
    for (int y = frame.top; y < frame.bottom; ++y) {
        for (int x = frame.left; x < frame.right; ++x) {
            double red = 0.0, green = 0.0, blue = 0.0, count = 0.0;
            for (int sample = 0; sample < Raster::samples * Raster::samples; ++sample) {
                const int i = x * Raster::samples + sample % Raster::samples;
                const int j = y * Raster::samples + sample / Raster::samples;
                const auto s = static_cast<std::size_t>(j) * static_cast<std::size_t>(raster.columns()) +
                               static_cast<std::size_t>(i);
                if (raster.particle[s] == Raster::empty) continue;
                Color color = particle_color(particles, raster.particle[s], settings.greatest_speed);
                if (!light.empty()) color = shaded(color, 0.55 + 0.6 * light[s]);
                if (on_outline(raster, particles, i, j, reach)) color = palette::ink;
                red += color.red;
                green += color.green;
                blue += color.blue;
                count += 1.0;
            }
            if (count == 0.0) continue;
            const auto mean = [&](double sum) { return static_cast<std::uint8_t>(std::lround(sum / count)); };
            canvas.blend(x, y, {mean(red), mean(green), mean(blue)}, share * count);
        }
    }
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

// The ground as a filled shape from the tank's bottom up, a column of pixels at a time.
void draw_ground(Canvas& canvas, const PictureSettings& settings, const Layout& layout) {
    if (settings.dimension != 2 || settings.ground_x.empty()) return;
    const double bottom = settings.low[2];
    const Pixel left = layout.view.project({settings.low[0], 0.0, bottom});
    const Pixel right = layout.view.project({settings.high[0], 0.0, bottom});
    const auto top = [&](double pixel) {
        const double share = std::clamp((pixel - left.x) / (right.x - left.x), 0.0, 1.0);
        const double place = settings.low[0] + share * (settings.high[0] - settings.low[0]);
        return layout.view
            .project({place, 0.0, std::clamp(ground_at(settings, place), bottom, settings.high[2])})
            .y;
    };
    for (int column = static_cast<int>(std::floor(left.x)); column < right.x; ++column) {
        const double from = std::max(left.x, static_cast<double>(column)),
                     to = std::min(right.x, column + 1.0);
        canvas.rectangle({from, top(0.5 * (from + to))}, {to, left.y}, palette::ground);
    }
    constexpr double piece = 4.0;  // pixels: the line on top
    for (double from = left.x; from < right.x; from += piece) {
        const double to = std::min(from + piece, right.x);
        canvas.line({from, top(from)}, {to, top(to)}, 1.5 * layout.unit, palette::ink);
    }
}

void draw_scale(Canvas& canvas, const PictureSettings& settings, const Layout& layout) {
    const double u = layout.unit, length = 380 * u, right = canvas.width() - 36 * u, left = right - length;
    const double top = 22 * u, bottom = 38 * u;
    for (double x = left; x < right; x += 1.0) {
        canvas.rectangle({x, top}, {std::min(x + 1.0, right), bottom}, scale_color((x - left) / length));
    }
    canvas.text({left - 14 * u, 0.5 * (top + bottom)}, Align::right, layout.letters, "speed (m/s)");
    const Ticks ticks = make_ticks(0.0, settings.greatest_speed, 5);
    for (std::size_t i = 0; i < ticks.values.size(); ++i) {
        const double x = left + length * ticks.values[i] / settings.greatest_speed;
        canvas.line({x, bottom}, {x, bottom + 5 * u}, 1.5 * u, palette::ink);
        canvas.text({x, bottom + 17 * u}, Align::center, 0.9 * layout.letters, ticks.labels[i]);
    }
}

void draw_heading(Canvas& canvas, const PictureSettings& settings, const Layout& layout) {
    const double u = layout.unit, y = 30 * u;
    canvas.text({layout.low.x, y}, Align::left, 1.25 * layout.letters,
                "t = " + format_fixed(settings.time, 2) + " s");
    canvas.text({layout.low.x + 150 * u, y}, Align::left, layout.letters, settings.title);
}

// What the colours besides the scale's and the dashed line mean, in a row below the heading.
void draw_legend(Canvas& canvas, const PictureParticles& particles, const Layout& layout) {
    const double u = layout.unit, y = 66 * u;
    double x = layout.low.x;
    const auto name = [&](const std::string& text) {
        canvas.text({x + 40 * u, y}, Align::left, 0.9 * layout.letters, text);
        x += 40 * u + 0.55 * layout.letters * static_cast<double>(text.size()) + 24 * u;
    };
    const auto present = [&](Material material) {
        return std::ranges::find(particles.material, static_cast<std::uint8_t>(material)) !=
               particles.material.end();
    };
    // color(share) from left to right
    const auto box = [&](double width, const auto& color, const std::string& text) {
        canvas.rectangle({x, y - 9 * u}, {x + width, y + 9 * u}, palette::ink);
        const double left = x + 1.5 * u, length = width - 3 * u;
        for (double at = 0.0; at < length; at += 1.0) {
            // To the right end, so that no ink shows between parts of pixels.
            canvas.rectangle({left + at, y - 7.5 * u}, {left + length, y + 7.5 * u}, color(at / length));
        }
        x += width - 30 * u;
        name(text);
    };
    const bool ice = present(Material::ice), by_damage = ice && !particles.damage.empty();
    if (present(Material::rigid))
        box(
            30 * u, [](double) { return palette::rigid; }, "rigid block");
    if (ice && !by_damage)
        box(
            30 * u, [](double) { return palette::ice; }, "ice");
    if (by_damage) box(120 * u, damage_color, "ice, from intact to failed");
    canvas.dashed_line({x, y}, {x + 30 * u, y}, 1.6 * u, 8 * u, 3 * u, palette::ink);
    name("still water level");
}

void draw_axes(Canvas& canvas, const PictureSettings& settings, const Layout& layout) {
    const double u = layout.unit, thin = 1.5 * u;
    const auto& view = layout.view;
    const auto &low = settings.low, &high = settings.high;
    const Pixel left = view.project(low), right = view.project({high[0], low[1], low[2]});
    const Pixel upper = view.project({low[0], low[1], high[2]});
    const Ticks along =
        make_ticks(low[0], high[0], std::max(2, static_cast<int>((right.x - left.x) / (85 * u))));
    for (std::size_t i = 0; i < along.values.size(); ++i) {
        const Pixel at = view.project({along.values[i], low[1], low[2]});
        canvas.line(at, {at.x, at.y + 6 * u}, thin, palette::ink);
        canvas.text({at.x, at.y + 20 * u}, Align::center, layout.letters, along.labels[i]);
    }
    canvas.text({0.5 * (left.x + right.x), 0.5 * (left.y + right.y) + 48 * u}, Align::center, layout.letters,
                "x (m)");
    const Ticks upward =
        make_ticks(low[2], high[2], std::max(2, static_cast<int>((left.y - upper.y) / (50 * u))));
    for (std::size_t i = 0; i < upward.values.size(); ++i) {
        const Pixel at = view.project({low[0], low[1], upward.values[i]});
        canvas.line({at.x - 6 * u, at.y}, at, thin, palette::ink);
        canvas.text({at.x - 11 * u, at.y}, Align::right, layout.letters, upward.labels[i]);
    }
    canvas.text({upper.x - 6 * u, upper.y - 22 * u}, Align::right, layout.letters, "z (m)");
}

// The edges of the tank's box: those behind the particles or those before them.
void draw_edges(Canvas& canvas, const PictureSettings& settings, const Layout& layout, bool front) {
    for (int a = 0; a < 8; ++a) {
        for (const int axis : {1, 2, 4}) {
            const int b = a | axis;
            if (b == a || (settings.dimension == 2 && ((a | b) & 2))) continue;
            const bool behind = settings.dimension == 3 && (a & 2) && (b & 2) && !((a & 4) && (b & 4));
            const bool far_left = settings.dimension == 3 && axis == 2 && !(a & 1) && !(a & 4);
            if ((behind || far_left) == front) continue;
            canvas.line(layout.view.project(corner(settings, a)), layout.view.project(corner(settings, b)),
                        1.5 * layout.unit, palette::ink, front ? 1.0 : 0.35);
        }
    }
}

void draw_still_level(Canvas& canvas, const PictureSettings& settings, const Layout& layout) {
    const double u = layout.unit;
    const auto &low = settings.low, &high = settings.high;
    if (settings.still_level < low[2] || settings.still_level > high[2]) return;
    const Pixel from = layout.view.project({low[0], low[1], settings.still_level});
    const Pixel to = layout.view.project({high[0], low[1], settings.still_level});
    canvas.line(from, to, 2.5 * u, palette::paper, 0.35);
    canvas.dashed_line(from, to, 1.6 * u, 10 * u, 7 * u, palette::ink, 0.85);
}

// Gauges whose names would run into the one before have a mark alone.
void draw_gauges(Canvas& canvas, const PictureSettings& settings, const Layout& layout) {
    const double u = layout.unit;
    std::vector<std::array<double, 2>> gauges = settings.gauges;
    std::ranges::sort(gauges);
    double free_from = 0.0;
    for (const auto& [x, across] : gauges) {
        if (x < settings.low[0] || x > settings.high[0]) continue;
        const double y = settings.dimension == 3 ? across : 0.0;
        const Pixel top = layout.view.project({x, y, settings.high[2]});
        const Pixel tip = layout.view.project({x, y, settings.still_level});
        canvas.dashed_line(top, tip, 1.2 * u, 3 * u, 4 * u, palette::ink, 0.6);
        canvas.triangle({top.x - 6 * u, top.y - 11 * u}, {top.x + 6 * u, top.y - 11 * u}, top, palette::ink);
        const std::string name = "x = " + format_number(x) + " m";
        const double half = 0.27 * layout.letters * static_cast<double>(name.size());
        if (top.x - half < free_from) continue;
        canvas.text({top.x, top.y - 24 * u}, Align::center, 0.9 * layout.letters, name);
        free_from = top.x + half;
    }
}

}  // namespace

Canvas draw_picture(const PictureParticles& particles, const PictureSettings& settings) {
    assert(settings.width >= 400 && settings.particle_spacing > 0.0 && settings.greatest_speed > 0.0);
    assert(particles.points.size() == 3 * particles.material.size());
    assert(particles.damage.empty() || particles.damage.size() == particles.material.size());
    const Layout layout = make_layout(settings);
    Canvas canvas(layout.width, layout.height);
    if (settings.dimension == 2) canvas.rectangle(layout.low, layout.high, palette::air);
    draw_edges(canvas, settings, layout, false);
    draw_particles(canvas, particles, settings, layout);
    draw_ground(canvas, settings, layout);
    draw_edges(canvas, settings, layout, true);
    draw_still_level(canvas, settings, layout);
    draw_gauges(canvas, settings, layout);
    draw_axes(canvas, settings, layout);
    draw_heading(canvas, settings, layout);
    draw_legend(canvas, particles, layout);
    draw_scale(canvas, settings, layout);
    return canvas;
}

}  // namespace tidewater::io
