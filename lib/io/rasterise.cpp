#include "io/rasterise.h"

#include <cairo.h>
#include <librsvg/rsvg.h>

#include <cmath>
#include <cstdint>
#include <memory>

#include "core/error.h"
#include "core/files.h"

namespace tidewater::io {
namespace {

struct Release {
    void operator()(void* object) const { g_object_unref(object); }
    void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
    void operator()(cairo_t* cairo) const { cairo_destroy(cairo); }
};
template <class Object>
using Owned = std::unique_ptr<Object, Release>;

// Throws what librsvg says in `error`, which it frees.
[[noreturn]] void fail(GError* error) {
    const std::string text = error ? error->message : "unknown";
    g_clear_error(&error);
    throw OutputError("drawing an SVG picture failed: " + text);
}

Owned<RsvgHandle> parse(const std::string& svg) {
    GError* error = nullptr;
    const Owned<GInputStream> stream(
        g_memory_input_stream_new_from_data(svg.data(), static_cast<gssize>(svg.size()), nullptr));
    // Unlimited: a picture of particles is an attribute of some megabytes.
    Owned<RsvgHandle> handle(
        rsvg_handle_new_from_stream_sync(stream.get(), nullptr, RSVG_HANDLE_FLAG_UNLIMITED, nullptr, &error));
    if (!handle) fail(error);
    return handle;
}

Canvas to_canvas(cairo_surface_t* surface, int width, int height) {
    cairo_surface_flush(surface);
    const unsigned char* data = cairo_image_surface_get_data(surface);
    const int stride = cairo_image_surface_get_stride(surface);
    Canvas canvas(width, height);
    for (int y = 0; y < height; ++y) {
        const auto* row = reinterpret_cast<const std::uint32_t*>(data + std::ptrdiff_t{y} * stride);
        for (int x = 0; x < width; ++x) {
            const auto part = [&](int shift) { return static_cast<std::uint8_t>(row[x] >> shift & 255u); };
            canvas.blend(x, y, {part(16), part(8), part(0)});
        }
    }
    return canvas;
}

}  // namespace

Canvas rasterise(const std::string& svg, double scale) {
    const Owned<RsvgHandle> handle = parse(svg);
    double width = 0.0, height = 0.0;
    if (!rsvg_handle_get_intrinsic_size_in_pixels(handle.get(), &width, &height))
        throw OutputError("drawing an SVG picture failed: it has no size in pixels");
    const RsvgRectangle page{0.0, 0.0, std::ceil(scale * width), std::ceil(scale * height)};
    const auto columns = static_cast<int>(page.width), rows = static_cast<int>(page.height);
    const Owned<cairo_surface_t> surface(cairo_image_surface_create(CAIRO_FORMAT_RGB24, columns, rows));
    const Owned<cairo_t> cairo(cairo_create(surface.get()));
    if (cairo_status(cairo.get()) != CAIRO_STATUS_SUCCESS)
        throw OutputError(std::string("drawing an SVG picture failed: ") +
                          cairo_status_to_string(cairo_status(cairo.get())));
    cairo_set_source_rgb(cairo.get(), 1.0, 1.0, 1.0);
    cairo_paint(cairo.get());
    GError* error = nullptr;
    if (!rsvg_handle_render_document(handle.get(), cairo.get(), &page, &error)) fail(error);
    return to_canvas(surface.get(), columns, rows);
}

void write_svg_and_png(const std::filesystem::path& path, const std::string& svg, double scale,
                       const Provenance& provenance) {
    write_text(path, svg);
    rasterise(svg, scale).write_png(std::filesystem::path(path).replace_extension(".png"), provenance);
}

}  // namespace tidewater::io
