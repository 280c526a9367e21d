#include "io/section_picture.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/parallel.h"
#include "io/axis.h"
#include "io/text.h"

namespace tidewater::io {
namespace {

constexpr int samples = 3;  // of the section, per pixel and axis

bool is_solid(Substance substance) {
    return substance == Substance::bed || substance == Substance::ice || substance == Substance::rigid;
}

// Everything about the page is in units of `unit`, one pixel of a page 1600 wide.
struct Page {
    double unit, letters;
    int width, height;
    Panel section, plan;
    double exaggeration;
    bool has_plan;
};

Page lay_out(const SectionSettings& s) {
    Page page{};
    const double u = page.unit = s.width / 1600.0;
    page.letters = std::max(19.0 * u, 9.0);
    page.has_plan = s.dimension == 3 && s.top;
    const double length = s.high[0] - s.low[0], width = s.high[1] - s.low[1], height = s.high[2] - s.low[2];
    const double margin_left = 84 * u, margin_right = (page.has_plan ? 220 : 36) * u;
    double scale = std::min((s.width - margin_left - margin_right) / length, 700 * u / height);
    if (page.has_plan) scale = std::min(scale, 900 * u / width);
    const double natural = scale * height;
    page.exaggeration = natural < 260 * u ? round_up(260 * u / natural) : 1.0;

    const double across = std::round(scale * length);
    const double section_top = std::round(150 * u);
    const double section_bottom = std::round(section_top + page.exaggeration * natural);
    page.section = {{margin_left, section_top},
                    {margin_left + across, section_bottom},
                    s.low[0],
                    s.high[0],
                    s.low[2],
                    s.high[2],
                    "x (m)",
                    "z (m)"};
    page.height = static_cast<int>(std::ceil(section_bottom + 70 * u));
    if (page.has_plan) {
        const double plan_top = std::round(section_bottom + 128 * u);
        page.plan = {{margin_left, plan_top},
                     {margin_left + across, std::round(plan_top + scale * width)},
                     s.low[0],
                     s.high[0],
                     s.low[1],
                     s.high[1],
                     "x (m)",
                     "y (m)"};
        const double bars_end = plan_top + plan_bars_height(page.plan, u);
        page.height = static_cast<int>(std::ceil(std::max(page.plan.high.y + 70 * u, bars_end)));
    }
    page.width = static_cast<int>(std::ceil(std::max(margin_left + across + margin_right, 1000 * u)));
    return page;
}

// What is at the samples of a panel's pixels.
struct Samples {
    int columns, rows;
    std::vector<Substance> substance;

    Substance at(int column, int row) const {
        column = std::clamp(column, 0, columns - 1), row = std::clamp(row, 0, rows - 1);
        return substance[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                         static_cast<std::size_t>(column)];
    }

    // Whether a sample is a solid within a pixel of something else.
    bool on_outline(int column, int row) const {
        const Substance own = at(column, row);
        if (!is_solid(own)) return false;
        for (const int away : {-2, 2}) {
            if (at(column + away, row) != own || at(column, row + away) != own) return true;
        }
        return false;
    }
};

Samples take_samples(const SectionSettings& settings, const Panel& panel) {
    Samples taken{samples * static_cast<int>(std::lround(panel.high.x - panel.low.x)),
                  samples * static_cast<int>(std::lround(panel.high.y - panel.low.y)),
                  {}};
    const auto columns = static_cast<std::size_t>(taken.columns);
    taken.substance.resize(columns * static_cast<std::size_t>(taken.rows));
    const double y = settings.dimension == 3 ? settings.across : 0.0;
    parallel_for(static_cast<std::size_t>(taken.rows), [&](std::size_t row) {
        const double z = panel.upward(panel.low.y + (static_cast<double>(row) + 0.5) / samples);
        for (std::size_t column = 0; column < columns; ++column) {
            const double x = panel.across(panel.low.x + (static_cast<double>(column) + 0.5) / samples);
            taken.substance[row * columns + column] = settings.at(x, y, z);
        }
    });
    return taken;
}

void draw_substances(Drawing& drawing, const Samples& taken, const Panel& panel) {
    Canvas canvas(taken.columns / samples, taken.rows / samples);
    for (int y = 0; y < taken.rows / samples; ++y) {
        for (int x = 0; x < taken.columns / samples; ++x) {
            double red = 0.0, green = 0.0, blue = 0.0;
            for (int n = 0; n < samples * samples; ++n) {
                const int column = x * samples + n % samples, row = y * samples + n / samples;
                const Color color =
                    taken.on_outline(column, row) ? palette::ink : substance_color(taken.at(column, row));
                red += color.red, green += color.green, blue += color.blue;
            }
            const auto mean = [](double sum) {
                return static_cast<std::uint8_t>(std::lround(sum / (samples * samples)));
            };
            canvas.blend(x, y, {mean(red), mean(green), mean(blue)});
        }
    }
    drawing.image(canvas, panel.low);
}

void draw_still_level(Drawing& drawing, const SectionSettings& settings, const Page& page) {
    const double level = settings.still_level, u = page.unit;
    if (!(level >= settings.low[2] && level <= settings.high[2])) return;
    const Pixel from = page.section.at(settings.low[0], level), to = page.section.at(settings.high[0], level);
    drawing.line(from, to, 2.5 * u, palette::paper, 0.35);
    drawing.dashed_line(from, to, 1.6 * u, 10 * u, 7 * u, palette::ink, 0.85);
}

// A line with a bar at both ends and its text on a light ground, to the left of the line where the page ends.
void draw_measures(Drawing& drawing, const SectionSettings& settings, const Page& page) {
    const double u = page.unit, size = 0.9 * page.letters;
    for (const Measure& measure : settings.measures) {
        const Pixel top = page.section.at(measure.x, measure.high),
                    bottom = page.section.at(measure.x, measure.low);
        drawing.line(top, bottom, 4.5 * u, palette::paper, 0.7);
        drawing.line(top, bottom, 2 * u, line_color(1));
        for (const Pixel& end : {top, bottom})
            drawing.line({end.x - 7 * u, end.y}, {end.x + 7 * u, end.y}, 2 * u, line_color(1));
        const double width = text_width(size, measure.text) + 14 * u, middle = 0.5 * (top.y + bottom.y);
        const bool fits = top.x + 10 * u + width < page.section.high.x;
        const double left = fits ? top.x + 10 * u : top.x - 10 * u - width;
        drawing.rectangle({left, middle - 0.7 * size}, {left + width, middle + 0.7 * size}, palette::paper,
                          0.8);
        drawing.text({left + 0.5 * width, middle}, Align::center, size, measure.text);
    }
}

// Above the section in 2D, in the plan in 3D; a name that would run into another is left out.
void draw_gauges(Drawing& drawing, const SectionSettings& settings, const Page& page) {
    const double u = page.unit, size = 0.9 * page.letters;
    if (settings.dimension == 3 && !page.has_plan) return;
    std::vector<std::array<double, 2>> gauges = settings.gauges;
    std::ranges::sort(gauges);
    std::vector<Pixel> named;  // middles of names, all about as wide
    for (const auto& [x, y] : gauges) {
        if (x < settings.low[0] || x > settings.high[0]) continue;
        const std::string name = "x = " + format_number(x) + " m";
        const double half = 0.5 * text_width(size, name) + 6 * u;
        Pixel tip = page.section.at(x, settings.high[2]);
        if (settings.dimension == 2) {
            if (std::isfinite(settings.still_level))
                drawing.dashed_line(tip, page.section.at(x, settings.still_level), 1.2 * u, 3 * u, 4 * u,
                                    palette::ink, 0.6);
        } else {
            tip = page.plan.at(x, y);
            drawing.triangle({tip.x - 9 * u, tip.y - 14 * u}, {tip.x + 9 * u, tip.y - 14 * u},
                             {tip.x, tip.y + 3 * u}, palette::paper);
        }
        drawing.triangle({tip.x - 6 * u, tip.y - 11 * u}, {tip.x + 6 * u, tip.y - 11 * u}, tip, palette::ink);
        const Pixel middle{tip.x, tip.y - 26 * u};
        const bool runs_into_another = std::ranges::any_of(named, [&](const Pixel& other) {
            return std::abs(other.x - middle.x) < 2.0 * half && std::abs(other.y - middle.y) < 1.2 * size;
        });
        if (runs_into_another) continue;
        named.push_back(middle);
        if (settings.dimension == 3)
            drawing.rectangle({middle.x - half, middle.y - 10 * u}, {middle.x + half, middle.y + 9 * u},
                              palette::paper, 0.75);
        drawing.text(middle, Align::center, size, name);
    }
}

void draw_heading(Drawing& drawing, const SectionSettings& settings, const Page& page) {
    const double u = page.unit;
    drawing.text({page.section.low.x, 30 * u}, Align::left, 1.25 * page.letters, settings.title);
    std::string section =
        settings.dimension == 3 ? "section at y = " + format_number(settings.across) + " m" : "section";
    section += page.exaggeration == 1.0
                   ? ", heights to scale"
                   : ", heights " + format_number(page.exaggeration) + " times exaggerated";
    drawing.text({page.section.high.x, page.section.low.y - 58 * u}, Align::right, 0.9 * page.letters,
                 section);
}

// The plan with what is drawn over it, and what its lines mean in a row above it.
void draw_plan_panel(Drawing& drawing, const SectionSettings& settings, const Page& page) {
    const double u = page.unit, size = 0.9 * page.letters, y = page.plan.low.y - 22 * u;
    draw_plan(drawing, page.plan, settings.top, settings.still_level, u);
    drawing.line(page.plan.at(settings.low[0], settings.across),
                 page.plan.at(settings.high[0], settings.across), 3 * u, palette::paper, 0.4);
    drawing.dashed_line(page.plan.at(settings.low[0], settings.across),
                        page.plan.at(settings.high[0], settings.across), 1.6 * u, 14 * u, 8 * u, palette::ink,
                        0.8);
    draw_axes(drawing, page.plan, u);
    double x = page.plan.low.x + 14 * u;
    drawing.line({x, y}, {x + 30 * u, y}, 3 * u, front_color);
    drawing.text({x + 40 * u, y}, Align::left, size, "front");
    x += 40 * u + text_width(size, "front") + 30 * u;
    drawing.dashed_line({x, y}, {x + 36 * u, y}, 1.6 * u, 14 * u, 8 * u, palette::ink);
    drawing.text({x + 46 * u, y}, Align::left, size, "section");
    drawing.text({page.plan.high.x, y}, Align::right, size, "plan, to the same scale along x");
}

// What of the scene is drawn, in a row below the title.
void draw_legend(Drawing& drawing, const SectionSettings& settings, const Page& page, const Samples& seen) {
    const double u = page.unit, y = 66 * u, size = 0.9 * page.letters;
    double x = page.section.low.x;
    const auto name = [&](const std::string& text) {
        drawing.text({x + 40 * u, y}, Align::left, size, text);
        x += 40 * u + text_width(size, text) + 24 * u;
    };
    for (const auto& [substance, text] :
         {std::pair{Substance::ice, "ice"}, std::pair{Substance::water, "water"},
          std::pair{Substance::bed, "ground"}, std::pair{Substance::rigid, "rigid block"}}) {
        if (std::ranges::find(seen.substance, substance) == seen.substance.end()) continue;
        drawing.rectangle({x, y - 9 * u}, {x + 30 * u, y + 9 * u}, palette::ink);
        drawing.rectangle({x + 1.5 * u, y - 7.5 * u}, {x + 28.5 * u, y + 7.5 * u},
                          substance_color(substance));
        name(text);
    }
    if (std::isfinite(settings.still_level)) {
        drawing.dashed_line({x, y}, {x + 30 * u, y}, 1.6 * u, 8 * u, 3 * u, palette::ink);
        name("still water level");
    }
}

}  // namespace

SectionPicture draw_section(const SectionSettings& settings) {
    assert(settings.width >= 400 && settings.at);
    const Page page = lay_out(settings);
    SectionPicture picture{Drawing(page.width, page.height), page.section, page.plan, page.exaggeration};
    Drawing& drawing = picture.drawing;
    const Samples taken = take_samples(settings, page.section);
    draw_substances(drawing, taken, page.section);
    draw_still_level(drawing, settings, page);
    draw_axes(drawing, page.section, page.unit);
    draw_heading(drawing, settings, page);
    draw_legend(drawing, settings, page, taken);
    if (page.has_plan) draw_plan_panel(drawing, settings, page);
    draw_gauges(drawing, settings, page);
    draw_measures(drawing, settings, page);
    return picture;
}

}  // namespace tidewater::io
