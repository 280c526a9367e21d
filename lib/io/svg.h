// Elements of SVG pictures as text, each with a line's end; lengths in pixels of the page, y downwards.
#pragma once

#include <string>

#include "core/provenance.h"
#include "io/color.h"

namespace tidewater::io {

// With two decimals.
std::string svg_number(double value);

// The attributes of an outline without a filling; dashes as "7 4".
std::string svg_stroke(Color color, double width, const char* dashes = nullptr);

// style: further attributes.
std::string svg_line(double x1, double y1, double x2, double y2, const std::string& style);
std::string svg_rectangle(double left, double top, double right, double bottom, const std::string& style);

// One line of any UTF-8 on the base line y; anchor: "start", "middle" or "end", the part of it that is at x.
std::string svg_text(double x, double y, const std::string& anchor, const std::string& text,
                     const std::string& style = {});

// A PNG file's bytes, stretched over the box without smoothing.
std::string svg_image(double left, double top, double right, double bottom, const std::string& png);

// What of `body` is within the box.
std::string svg_clipped(double left, double top, double right, double bottom, const std::string& body);

// The whole file: a white page of this size with `body` on it and the provenance as its metadata. Letters are
// 12 pixels high and dark unless an element says otherwise.
std::string svg_file(double width, double height, const std::string& body, const Provenance& provenance);

}  // namespace tidewater::io
