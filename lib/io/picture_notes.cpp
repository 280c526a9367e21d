#include "io/picture_notes.h"

#include <algorithm>
#include <cmath>

#include "core/types.h"
#include "io/axis.h"
#include "io/text.h"

namespace tidewater::io {
namespace {

constexpr double scale_length = 380, title_from = 150;  // units

bool present(const PictureParticles& particles, Material material) {
    return any_of(particles, static_cast<std::uint8_t>(material));
}

// Returns where it begins, with its label.
double draw_scale(Drawing& drawing, const PictureSettings& settings, const Layout& layout) {
    const double u = layout.unit, length = scale_length * u, right = layout.right, left = right - length;
    const double top = 22 * u, bottom = 38 * u;
    const std::string label = "speed of the water (m/s)";
    drawing.color_bar({left, top}, {right, bottom}, scale_color, false);
    drawing.text({left - 14 * u, 0.5 * (top + bottom)}, Align::right, layout.letters, label);
    const Ticks ticks = make_ticks(0.0, settings.greatest_speed, 5);
    for (std::size_t i = 0; i < ticks.values.size(); ++i) {
        const double x = left + length * ticks.values[i] / settings.greatest_speed;
        drawing.line({x, bottom}, {x, bottom + 5 * u}, 1.5 * u, palette::ink);
        drawing.text({x, bottom + 17 * u}, Align::center, 0.9 * layout.letters, ticks.labels[i]);
    }
    return left - 14 * u - text_width(layout.letters, label);
}

// A row of boxes and lines with their names.
struct LegendRow {
    Drawing& drawing;
    double unit, size;  // of the letters
    double x, y;        // where the next entry begins

    void name(double from, const std::string& text) {
        drawing.text({from + 10 * unit, y}, Align::left, size, text);
        x = from + text_width(size, text) + 38 * unit;
    }
    void box(double width, const std::function<Color(double)>& color, const std::string& text) {
        const double u = unit, right = x + width * u;
        drawing.rectangle({x, y - 9 * u}, {right, y + 9 * u}, palette::ink);
        drawing.color_bar({x + 1.5 * u, y - 7.5 * u}, {right - 1.5 * u, y + 7.5 * u}, color, false);
        name(right, text);
    }
    void box(Color color, const std::string& text) {
        box(
            30, [=](double) { return color; }, text);
    }
    void dashed(const std::string& text) {
        const double u = unit;
        drawing.dashed_line({x, y}, {x + 30 * u, y}, 1.6 * u, 8 * u, 3 * u, palette::ink);
        name(x + 30 * u, text);
    }
};

Color iceberg_at(double share) {
    return iceberg_color(1 + static_cast<std::size_t>(share * static_cast<double>(iceberg_color_count)));
}

void draw_legend(Drawing& drawing, const PictureParticles& particles, const PictureSettings& settings,
                 const Layout& layout) {
    LegendRow row{drawing, layout.unit, 0.9 * layout.letters, layout.left, 66 * layout.unit};
    if (present(particles, Material::ice)) {
        if (!particles.iceberg.empty()) row.box(120, iceberg_at, "icebergs, by their numbers");
        if (particles.damage.empty())
            row.box(palette::ice, "ice");
        else
            row.box(120, damage_color, "ice, from intact to failed");
    }
    if (present(particles, Material::rigid)) row.box(palette::rigid, "rigid block");
    if (!settings.ground_x.empty() && settings.dimension == 2) row.box(palette::ground, "ground");
    if (present(particles, Material::water)) row.dashed("still water level");
}

}  // namespace

bool any_of(const PictureParticles& particles, std::uint8_t material) {
    return std::ranges::find(particles.material, material) != particles.material.end();
}

void draw_heading(Drawing& drawing, const PictureParticles& particles, const PictureSettings& settings,
                  const Layout& layout) {
    const double u = layout.unit, y = 30 * u, letters = layout.letters;
    const std::string time = "t = " + format_fixed(settings.time, 2) + " s";
    drawing.text({layout.left, y}, Align::left, 1.25 * letters, time);
    double end = layout.right;
    if (present(particles, Material::water)) end = draw_scale(drawing, settings, layout);
    const double from = layout.left + std::max(title_from * u, text_width(1.25 * letters, time) + 24 * u);
    const double fit = (end - 24 * u - from) / std::max(text_width(letters, settings.title), 1.0);
    drawing.text({from, y}, Align::left, letters * std::min(fit, 1.0), settings.title);
    draw_legend(drawing, particles, settings, layout);
}

void draw_scale_bar(Drawing& drawing, const PictureSettings& settings, const Layout& layout) {
    const double u = layout.unit, length = settings.high[0] - settings.low[0];
    const double metres = make_ticks(0.0, length, 14).values[1];
    const auto below = [&](double x) {
        const Pixel at = layout.view.project({x, settings.low[1], settings.low[2]});
        return Pixel{at.x, at.y + 48 * u};
    };
    const Pixel from = below(settings.high[0] - metres), to = below(settings.high[0]);
    drawing.line(from, to, 2.5 * u, palette::ink);
    for (const Pixel& end : {from, to})
        drawing.line({end.x, end.y - 6 * u}, {end.x, end.y + 6 * u}, 2.5 * u, palette::ink);
    drawing.text({from.x - 10 * u, from.y}, Align::right, layout.letters, format_number(metres) + " m");
}

}  // namespace tidewater::io
