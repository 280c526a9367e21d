#include "io/particle_image.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "core/types.h"

namespace tidewater::io {
namespace {

std::uint32_t iceberg_of(const PictureParticles& particles, std::size_t p) {
    return particles.iceberg.empty() ? 0 : particles.iceberg[p];
}

Color ice_color(const PictureParticles& particles, std::size_t p) {
    if (const std::uint32_t iceberg = iceberg_of(particles, p)) return iceberg_color(iceberg);
    return particles.damage.empty() ? palette::ice : damage_color(particles.damage[p]);
}

Color particle_color(const PictureParticles& particles, std::size_t p, double greatest_speed) {
    const auto material = static_cast<Material>(particles.material[p]);
    if (material == Material::rigid) return palette::rigid;
    if (material == Material::ice) return ice_color(particles, p);
    const float* v = particles.velocity.data() + 3 * p;
    return scale_color(std::hypot(v[0], v[1], v[2]) / greatest_speed);
}

// What outlines part: one number for each material and iceberg. Ice that belongs to no iceberg has none
// around it.
std::int64_t piece_of(const PictureParticles& particles, std::uint32_t p) {
    return std::int64_t{particles.material[p]} << 32 | iceberg_of(particles, p);
}

// Whether a sample shows a solid whose edge, against anything else, is within `reach` samples.
bool on_outline(const Raster& raster, const PictureParticles& particles, int i, int j, int reach) {
    constexpr std::int64_t nothing = -1;
    const auto piece_at = [&](int column, int row) {
        if (column < 0 || row < 0 || column >= raster.columns() || row >= raster.rows()) return nothing;
        const std::uint32_t p = raster.at(column, row);
        return p == Raster::empty ? nothing : piece_of(particles, p);
    };
    const std::int64_t own = piece_at(i, j);
    if (own == nothing || own >> 32 == static_cast<int>(Material::water)) return false;
    return piece_at(i - reach, j) != own || piece_at(i + reach, j) != own || piece_at(i, j - reach) != own ||
           piece_at(i, j + reach) != own;
}

}  // namespace

Canvas draw_particles(const PictureParticles& particles, const View& view, int width, int height,
                      double spacing, double greatest_speed, double outline, bool shaded) {
    const Raster raster = splat(particles.points, (shaded ? 0.7 : 1.0) * spacing, view, width, height);
    std::vector<float> light;
    if (shaded) light = shading(raster, view, 1.5 * spacing);
    const int reach = std::max(static_cast<int>(std::lround(outline * Raster::samples)), 2);
    const auto color_at = [&](int i, int j) {
        if (on_outline(raster, particles, i, j, reach)) return palette::ink;
        const Color color = particle_color(particles, raster.at(i, j), greatest_speed);
        return light.empty() ? color : io::shaded(color, 0.55 + 0.6 * light[raster.index(i, j)]);
    };
    constexpr int samples = Raster::samples * Raster::samples;
    Canvas canvas(width, height, palette::paper, 0.0);
    parallel_for(static_cast<std::size_t>(height), [&](std::size_t row) {
        const auto y = static_cast<int>(row);
        for (int x = 0; x < width; ++x) {
            double red = 0.0, green = 0.0, blue = 0.0, count = 0.0;
            for (int sample = 0; sample < samples; ++sample) {
                const int i = x * Raster::samples + sample % Raster::samples;
                const int j = y * Raster::samples + sample / Raster::samples;
                if (raster.at(i, j) == Raster::empty) continue;
                const Color color = color_at(i, j);
                red += color.red;
                green += color.green;
                blue += color.blue;
                count += 1.0;
            }
            if (count == 0.0) continue;
            const auto mean = [&](double sum) { return static_cast<std::uint8_t>(std::lround(sum / count)); };
            canvas.blend(x, y, {mean(red), mean(green), mean(blue)}, count / samples);
        }
    });
    return canvas;
}

}  // namespace tidewater::io
