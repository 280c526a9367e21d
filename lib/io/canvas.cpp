#include "io/canvas.h"

#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/files.h"

namespace tidewater::io {
namespace {

std::uint8_t mix(std::uint8_t below, std::uint8_t above, double share) {
    return static_cast<std::uint8_t>(std::lround(below + (above - below) * share));
}

std::uint8_t to_byte(double share) { return static_cast<std::uint8_t>(std::lround(255.0 * share)); }

}  // namespace

Canvas::Canvas(int width, int height, Color background, double opacity) : width_(width), height_(height) {
    assert(width > 0 && height > 0 && opacity >= 0.0 && opacity <= 1.0);
    const auto count = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    pixels_.assign(count, background);
    opacity_.assign(count, to_byte(opacity));
}

std::size_t Canvas::index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(x);
}

// Porter and Duff's "over": the opacities a above and b below give a + b (1 - a).
void Canvas::blend(int x, int y, Color color, double opacity) {
    if (x < 0 || y < 0 || x >= width_ || y >= height_ || opacity <= 0.0) return;
    Color& pixel = pixels_[index(x, y)];
    std::uint8_t& below = opacity_[index(x, y)];
    if (opacity ==
        1.0) {  // what the formula gives, without its arithmetic: most pixels of a picture are such
        pixel = color;
        below = 255;
        return;
    }
    const double both = opacity + below / 255.0 * (1.0 - opacity), share = opacity / both;
    pixel = {mix(pixel.red, color.red, share), mix(pixel.green, color.green, share),
             mix(pixel.blue, color.blue, share)};
    below = to_byte(both);
}

std::string Canvas::png(const std::vector<std::pair<std::string, std::string>>& entries) const {
    const bool opaque = std::ranges::all_of(opacity_, [](std::uint8_t value) { return value == 255; });
    vtkNew<vtkImageData> image;
    image->SetDimensions(width_, height_, 1);
    image->AllocateScalars(VTK_UNSIGNED_CHAR, opaque ? 3 : 4);
    for (int y = 0; y < height_; ++y) {  // VTK's rows go from the bottom up
        auto* byte = static_cast<unsigned char*>(image->GetScalarPointer(0, height_ - 1 - y, 0));
        for (int x = 0; x < width_; ++x) {
            const Color color = at(x, y);
            *byte++ = color.red;
            *byte++ = color.green;
            *byte++ = color.blue;
            if (!opaque) *byte++ = opacity_[index(x, y)];
        }
    }
    vtkNew<vtkPNGWriter> writer;
    writer->WriteToMemoryOn();
    for (const auto& [name, text] : entries) writer->AddText(name.c_str(), text.c_str());
    writer->SetInputData(image);
    writer->Write();
    vtkUnsignedCharArray* bytes = writer->GetResult();
    return {reinterpret_cast<const char*>(bytes->GetPointer(0)),
            static_cast<std::size_t>(bytes->GetNumberOfValues())};
}

void Canvas::write_png(const std::filesystem::path& path, const Provenance& provenance) const {
    write_text(path, png(provenance_fields(provenance)));
}

}  // namespace tidewater::io
