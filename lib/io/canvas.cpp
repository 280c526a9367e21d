#include "io/canvas.h"

#include <vtkFreeTypeTools.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkStdString.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/files.h"

namespace tidewater::io {
namespace {

std::uint8_t mix(std::uint8_t below, std::uint8_t above, double opacity) {
    return static_cast<std::uint8_t>(std::lround(below + (above - below) * opacity));
}

// Letters as white with their coverage as opacity; rows from the bottom up.
vtkNew<vtkImageData> render_text(const std::string& text, double size) {
    vtkNew<vtkTextProperty> property;
    property->SetFontFamilyToArial();
    property->SetFontSize(static_cast<int>(std::lround(size)));
    property->SetColor(1.0, 1.0, 1.0);
    vtkNew<vtkImageData> image;
    constexpr int dpi = 72;  // makes the font size one in pixels
    vtkFreeTypeTools* tools = vtkFreeTypeTools::GetInstance();
    tools->ScaleToPowerTwoOff();  // or the image would be wider than its text
    tools->RenderString(property, text, dpi, image);
    return image;
}

}  // namespace

double text_width(double size, const std::string& text) {
    const auto image = render_text(text, size);
    return image->GetDimensions()[0];
}

Canvas::Canvas(int width, int height, Color background) : width_(width), height_(height) {
    assert(width > 0 && height > 0);
    pixels_.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), background);
}

std::size_t Canvas::index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
}

void Canvas::blend(int x, int y, Color color, double opacity) {
    if (x < 0 || y < 0 || x >= width_ || y >= height_) return;
    Color& pixel = pixels_[index(x, y)];
    pixel = {mix(pixel.red, color.red, opacity), mix(pixel.green, color.green, opacity),
             mix(pixel.blue, color.blue, opacity)};
}

template <class Inside>
void Canvas::fill(Pixel low, Pixel high, const Inside& inside, Color color, double opacity) {
    const auto first_x = static_cast<int>(std::floor(std::max(low.x, 0.0)));
    const auto first_y = static_cast<int>(std::floor(std::max(low.y, 0.0)));
    const auto end_x = static_cast<int>(std::ceil(std::min<double>(high.x, width_)));
    const auto end_y = static_cast<int>(std::ceil(std::min<double>(high.y, height_)));
    for (int y = first_y; y < end_y; ++y) {
        for (int x = first_x; x < end_x; ++x) {
            int count = 0;
            for (int sample = 0; sample < 16; ++sample) {
                count += inside(Pixel{x + (sample % 4 + 0.5) / 4.0, y + (sample / 4 + 0.5) / 4.0});
            }
            if (count > 0) blend(x, y, color, opacity * count / 16.0);
        }
    }
}

void Canvas::rectangle(Pixel low, Pixel high, Color color, double opacity) {
    const auto inside = [&](Pixel p) { return p.x >= low.x && p.x < high.x && p.y >= low.y && p.y < high.y; };
    fill(low, high, inside, color, opacity);
}

void Canvas::line(Pixel from, Pixel to, double width, Color color, double opacity) {
    const double dx = to.x - from.x, dy = to.y - from.y, length = std::hypot(dx, dy), half = 0.5 * width;
    if (length == 0.0) return;
    const auto inside = [&](Pixel p) {
        const double along = ((p.x - from.x) * dx + (p.y - from.y) * dy) / length;
        const double across = ((p.y - from.y) * dx - (p.x - from.x) * dy) / length;
        return along >= 0.0 && along < length && across >= -half && across < half;
    };
    fill({std::min(from.x, to.x) - half, std::min(from.y, to.y) - half},
         {std::max(from.x, to.x) + half, std::max(from.y, to.y) + half}, inside, color, opacity);
}

void Canvas::dashed_line(Pixel from, Pixel to, double width, double dash, double gap, Color color,
                         double opacity) {
    const double length = std::hypot(to.x - from.x, to.y - from.y);
    const auto point = [&](double along) {
        const double share = std::min(along / length, 1.0);
        return Pixel{std::lerp(from.x, to.x, share), std::lerp(from.y, to.y, share)};
    };
    for (double along = 0.0; along < length; along += dash + gap) {
        line(point(along), point(along + dash), width, color, opacity);
    }
}

void Canvas::triangle(Pixel a, Pixel b, Pixel c, Color color) {
    const auto side = [](Pixel p, Pixel q, Pixel r) {
        return (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
    };
    const auto inside = [&](Pixel p) {
        const double ab = side(a, b, p), bc = side(b, c, p), ca = side(c, a, p);
        return (ab >= 0 && bc >= 0 && ca >= 0) || (ab <= 0 && bc <= 0 && ca <= 0);
    };
    fill({std::min({a.x, b.x, c.x}), std::min({a.y, b.y, c.y})},
         {std::max({a.x, b.x, c.x}), std::max({a.y, b.y, c.y})}, inside, color, 1.0);
}

void Canvas::text(Pixel at, Align align, double size, const std::string& text, Color color) {
    const auto image = render_text(text, size);
    int extent[6];
    image->GetExtent(extent);
    const int columns = extent[1] - extent[0] + 1, rows = extent[3] - extent[2] + 1;
    const double shift = align == Align::left ? 0.0 : align == Align::center ? 0.5 * columns : columns;
    const auto left = static_cast<int>(std::lround(at.x - shift)),
               top = static_cast<int>(std::lround(at.y - 0.5 * rows));
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            const auto* rgba =
                static_cast<const unsigned char*>(image->GetScalarPointer(extent[0] + i, extent[3] - j, 0));
            blend(left + i, top + j, color, rgba[3] / 255.0);
        }
    }
}

std::string Canvas::png(const Provenance& provenance) const {
    vtkNew<vtkImageData> image;
    image->SetDimensions(width_, height_, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, 3);
    for (int y = 0; y < height_; ++y) {  // VTK's rows go from the bottom up
        for (int x = 0; x < width_; ++x) {
            auto* pixel = static_cast<unsigned char*>(image->GetScalarPointer(x, height_ - 1 - y, 0));
            const Color color = at(x, y);
            pixel[0] = color.red;
            pixel[1] = color.green;
            pixel[2] = color.blue;
        }
    }
    vtkNew<vtkPNGWriter> writer;
    writer->WriteToMemoryOn();
    for (const auto& [name, text] : provenance_fields(provenance))
        writer->AddText(name.c_str(), text.c_str());
    writer->SetInputData(image);
    writer->Write();
    vtkUnsignedCharArray* bytes = writer->GetResult();
    return {reinterpret_cast<const char*>(bytes->GetPointer(0)),
            static_cast<std::size_t>(bytes->GetNumberOfValues())};
}

void Canvas::write_png(const std::filesystem::path& path, const Provenance& provenance) const {
    write_text(path, png(provenance));
}

}  // namespace tidewater::io
