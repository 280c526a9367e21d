#include "io/svg.h"

#include "io/text.h"

namespace tidewater::io {
namespace {

std::string attribute(const char* name, double value) {
    return std::string(" ") + name + "=\"" + svg_number(value) + "\"";
}

std::string box(double left, double top, double right, double bottom) {
    return attribute("x", left) + attribute("y", top) + attribute("width", right - left) +
           attribute("height", bottom - top);
}

std::string metadata(const Provenance& provenance) {
    std::string svg = "<metadata>\n";
    for (const auto& [name, text] : provenance_fields(provenance))
        svg += name + ": " + escape_xml(text) + "\n";
    return svg + "</metadata>\n";
}

}  // namespace

std::string svg_number(double value) { return format_fixed(value, 2); }

std::string svg_stroke(Color color, double width, const char* dashes) {
    std::string style =
        "fill=\"none\" stroke=\"" + hex(color) + "\" stroke-width=\"" + svg_number(width) + "\"";
    if (dashes) style += std::string(" stroke-dasharray=\"") + dashes + "\"";
    return style;
}

std::string svg_line(double x1, double y1, double x2, double y2, const std::string& style) {
    return "<line" + attribute("x1", x1) + attribute("y1", y1) + attribute("x2", x2) + attribute("y2", y2) +
           " " + style + "/>\n";
}

std::string svg_rectangle(double left, double top, double right, double bottom, const std::string& style) {
    return "<rect" + box(left, top, right, bottom) + " " + style + "/>\n";
}

std::string svg_text(double x, double y, const std::string& anchor, const std::string& text,
                     const std::string& style) {
    return "<text" + attribute("x", x) + attribute("y", y) + " text-anchor=\"" + anchor + "\" " + style +
           ">" + escape_xml(text) + "</text>\n";
}

std::string svg_image(double left, double top, double right, double bottom, const std::string& png) {
    return "<image" + box(left, top, right, bottom) +
           " preserveAspectRatio=\"none\" image-rendering=\"optimizeSpeed\""
           " style=\"image-rendering: pixelated\" href=\"data:image/png;base64," +
           encode_base64(png) + "\"/>\n";
}

std::string svg_clipped(double left, double top, double right, double bottom, const std::string& body) {
    return "<svg" + box(left, top, right, bottom) + " viewBox=\"" + svg_number(left) + " " + svg_number(top) +
           " " + svg_number(right - left) + " " + svg_number(bottom - top) + "\" overflow=\"hidden\">\n" +
           body + "</svg>\n";
}

std::string svg_file(double width, double height, const std::string& body, const Provenance& provenance) {
    return "<svg xmlns=\"http://www.w3.org/2000/svg\"" + attribute("width", width) +
           attribute("height", height) + " viewBox=\"0 0 " + svg_number(width) + " " + svg_number(height) +
           "\" font-family=\"DejaVu Sans, Arial, sans-serif\" font-size=\"12\" fill=\"" + hex(palette::ink) +
           "\">\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n" + metadata(provenance) + body +
           "</svg>\n";
}

}  // namespace tidewater::io
