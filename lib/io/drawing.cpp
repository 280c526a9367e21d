#include "io/drawing.h"

#include <cairo.h>

#include <array>
#include <memory>

#include "io/svg.h"

namespace tidewater::io {
namespace {

constexpr double half_capital = 0.365;  // of the font's size: from a capital's middle down to the base line

std::string opaque(double opacity) {
    return opacity < 1.0 ? " opacity=\"" + svg_number(opacity) + "\"" : std::string();
}

std::string points_of(std::span<const Pixel> points) {
    std::string text = "points=\"";
    for (const Pixel& point : points) text += svg_number(point.x) + "," + svg_number(point.y) + " ";
    return text + "\" ";
}

std::string fill(Color color) { return "fill=\"" + hex(color) + "\""; }

}  // namespace

double text_width(double size, const std::string& text) {
    const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
        cairo_image_surface_create(CAIRO_FORMAT_A8, 1, 1), cairo_surface_destroy);
    const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> cairo(cairo_create(surface.get()),
                                                                   cairo_destroy);
    cairo_select_font_face(cairo.get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL, CAIRO_FONT_WEIGHT_NORMAL);
    cairo_set_font_size(cairo.get(), size);
    cairo_text_extents_t extents;
    cairo_text_extents(cairo.get(), text.c_str(), &extents);
    return extents.x_advance;
}

void Drawing::rectangle(Pixel low, Pixel high, Color color, double opacity) {
    body_ += svg_rectangle(low.x, low.y, high.x, high.y, fill(color) + opaque(opacity));
}

void Drawing::line(Pixel from, Pixel to, double width, Color color, double opacity) {
    body_ += svg_line(from.x, from.y, to.x, to.y, svg_stroke(color, width) + opaque(opacity));
}

void Drawing::dashed_line(Pixel from, Pixel to, double width, double dash, double gap, Color color,
                          double opacity) {
    const std::string dashes = svg_number(dash) + " " + svg_number(gap);
    body_ += svg_line(from.x, from.y, to.x, to.y, svg_stroke(color, width, dashes.c_str()) + opaque(opacity));
}

void Drawing::polyline(std::span<const Pixel> points, double width, Color color) {
    body_ += "<polyline " + points_of(points) + svg_stroke(color, width) + "/>\n";
}

void Drawing::polygon(std::span<const Pixel> corners, Color color) {
    body_ += "<polygon " + points_of(corners) + fill(color) + "/>\n";
}

void Drawing::triangle(Pixel a, Pixel b, Pixel c, Color color) { polygon(std::array{a, b, c}, color); }

void Drawing::text(Pixel at, Align align, double size, const std::string& text, Color color, double rim) {
    const char* anchor = align == Align::left ? "start" : align == Align::center ? "middle" : "end";
    std::string style = "font-size=\"" + svg_number(size) + "\" " + fill(color);
    if (rim > 0.0) {
        style += " paint-order=\"stroke\" stroke=\"" + hex(palette::paper) + "\" stroke-linejoin=\"round\"" +
                 " stroke-width=\"" + svg_number(rim) + "\"";
    }
    body_ += svg_text(at.x, at.y + half_capital * size, anchor, text, style);
}

void Drawing::image(const Canvas& canvas, Pixel corner) {
    body_ +=
        svg_image(corner.x, corner.y, corner.x + canvas.width(), corner.y + canvas.height(), canvas.png());
}

void Drawing::color_bar(Pixel low, Pixel high, const std::function<Color(double share)>& color, bool upward) {
    constexpr int steps = 256;
    Canvas bar(upward ? 1 : steps, upward ? steps : 1);
    for (int i = 0; i < steps; ++i) {
        const Color here = color((i + 0.5) / steps);
        upward ? bar.blend(0, steps - 1 - i, here) : bar.blend(i, 0, here);
    }
    body_ += svg_image(low.x, low.y, high.x, high.y, bar.png());
}

std::string Drawing::svg(const Provenance& provenance) const {
    return svg_file(width_, height_, body_, provenance);
}

}  // namespace tidewater::io
