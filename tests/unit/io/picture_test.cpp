#include "io/picture.h"

#include <doctest/doctest.h>

#include <cmath>

#include "io/rasterise.h"
#include "io/splat.h"
#include "unit/io/fixture.h"

using namespace tidewater;
using namespace tidewater::io;

namespace {

const PictureSettings tank{.dimension = 2,
                           .low = {},
                           .high = {4.0, 0.0, 2.0},
                           .particle_spacing = 0.02,
                           .still_level = 1.0,
                           .greatest_speed = 2.0,
                           .title = "test",
                           .gauges = {{3.0, 0.5}},
                           .ground_x = {},
                           .ground_z = {},
                           .width = 800};

// Water up to z = 1 m, resting in the left half and at the greatest speed in the right; a rigid block from x
// = 1 m to 1.5 m and z = 1 m to 1.5 m.
Snapshot half_moving_water() {
    Snapshot snapshot;
    const auto add = [&](double x, double z, float speed, Material material) {
        for (const double part : {x, 0.0, z}) snapshot.points.push_back(static_cast<float>(part));
        for (const float part : {speed, 0.0f, 0.0f}) snapshot.velocity.push_back(part);
        snapshot.material.push_back(static_cast<std::uint8_t>(material));
    };
    for (double x = 0.01; x < 4.0; x += 0.02) {
        for (double z = 0.01; z < 1.0; z += 0.02) add(x, z, x < 2.0 ? 0.0f : 2.0f, Material::water);
    }
    for (double x = 1.01; x < 1.5; x += 0.02) {
        for (double z = 1.01; z < 1.5; z += 0.02) add(x, z, 0.0f, Material::rigid);
    }
    return snapshot;
}

Canvas draw(const PictureParticles& particles, const PictureSettings& settings) {
    return rasterise(draw_picture(particles, settings).svg(test_provenance()));
}

Canvas draw(const Snapshot& snapshot, const PictureSettings& settings) {
    return draw({snapshot.points, snapshot.velocity, snapshot.material}, settings);
}

// The share of the picture's pixels that have this colour.
double share_of(const Canvas& canvas, Color color) {
    int count = 0;
    for (int y = 0; y < canvas.height(); ++y) {
        for (int x = 0; x < canvas.width(); ++x) count += canvas.at(x, y) == color;
    }
    return static_cast<double>(count) / (canvas.width() * canvas.height());
}

bool same_pixels(const Canvas& a, const Canvas& b) {
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            if (!(a.at(x, y) == b.at(x, y))) return false;
        }
    }
    return a.width() == b.width() && a.height() == b.height();
}

}  // namespace

TEST_CASE("water, block and air fill the shares of the picture that they have of the tank") {
    const Canvas canvas = draw(half_moving_water(), tank);
    CHECK(canvas.width() == 800);
    const double frame = 370.0 * 740.0 / (canvas.width() * canvas.height());  // about, of the tank
    CHECK(share_of(canvas, scale_color(0.0)) == doctest::Approx(0.25 * frame).epsilon(0.08));
    CHECK(share_of(canvas, scale_color(1.0)) == doctest::Approx(0.25 * frame).epsilon(0.08));
    CHECK(share_of(canvas, palette::rigid) == doctest::Approx(0.25 / 8.0 * frame).epsilon(0.15));
    CHECK(share_of(canvas, palette::air) > 0.4 * frame);
}

TEST_CASE("the same particles give the same picture, an empty tank gives one too") {
    CHECK(same_pixels(draw(half_moving_water(), tank), draw(half_moving_water(), tank)));
    const Canvas empty = draw(Snapshot{}, tank);
    CHECK(share_of(empty, palette::air) > share_of(draw(half_moving_water(), tank), palette::air));
}

TEST_CASE("ice is drawn as intact without damage, and by its damage with it") {
    Snapshot snapshot = half_moving_water();
    for (std::size_t p = 0; p < snapshot.material.size(); ++p) {
        auto& material = snapshot.material[p];
        if (material == static_cast<std::uint8_t>(Material::rigid))
            material = static_cast<std::uint8_t>(Material::ice);
        snapshot.damage.push_back(snapshot.points[3 * p] > 1.25f ? 1.0f : 0.0f);
    }
    const double whole = share_of(draw(snapshot, tank), palette::ice);
    const Canvas canvas =
        draw({snapshot.points, snapshot.velocity, snapshot.material, snapshot.damage}, tank);
    CHECK(share_of(canvas, palette::ice) == doctest::Approx(0.5 * whole).epsilon(0.1));
    CHECK(share_of(canvas, palette::failed_ice) == doctest::Approx(0.5 * whole).epsilon(0.1));
}

TEST_CASE("in three dimensions particles are seen through no others, and shaded") {
    PictureSettings settings = tank;
    settings.dimension = 3;
    settings.high = {4.0, 1.0, 2.0};
    const Snapshot layer = half_moving_water();
    Snapshot snapshot;
    for (const float y : {0.02f, 0.5f, 0.98f}) {
        const float speed = y < 0.1f ? 0.0f : 2.0f;  // the front layer rests
        for (std::size_t p = 0; p < layer.material.size(); ++p) {
            for (const float part : {layer.points[3 * p], y, layer.points[3 * p + 2]})
                snapshot.points.push_back(part);
            for (const float part : {speed, 0.0f, 0.0f}) snapshot.velocity.push_back(part);
            snapshot.material.push_back(layer.material[p]);
        }
    }
    const Canvas canvas = draw(snapshot, settings);
    const Color front = canvas.at(canvas.width() / 2, canvas.height() * 3 / 4);
    CHECK(to_oklab(front)[0] < 0.4);  // dark, as water at rest
}

TEST_CASE("each sample goes to the nearest particle, and to the lower number of equal ones") {
    const std::vector<float> points{1.0f, 0.0f, 1.0f, 2.0f, 0.0f, 1.0f, 2.0f, 0.0f, 1.0f};
    const View view{.scale = 10.0, .origin = {0.0, 20.0}};
    const Raster raster = splat(points, 0.8, view, 30, 20);
    const auto at = [&](double x, double z) {
        const auto column = static_cast<std::size_t>(x * 10.0 * Raster::samples);
        const auto row = static_cast<std::size_t>((2.0 - z) * 10.0 * Raster::samples);
        return raster.particle[row * static_cast<std::size_t>(raster.columns()) + column];
    };
    CHECK(at(1.4, 1.0) == 0);
    CHECK(at(1.6, 1.0) == 1);
    CHECK(at(2.7, 1.0) == 1);
    CHECK(at(2.9, 1.0) == Raster::empty);
    CHECK(at(1.5, 1.9) == Raster::empty);
    for (const float light : shading(splat({}, 1.0, view, 4, 4), view, 1.0)) CHECK(light == 1.0f);
}

TEST_CASE("a window shows its part of the tank alone, to its own scale") {
    PictureSettings window = tank;
    window.low = {2.0, 0.0, 0.5};
    window.high = {4.0, 0.0, 1.5};
    const Canvas canvas = draw(half_moving_water(), window);
    const double frame = 370.0 * 740.0 / (canvas.width() * canvas.height());
    CHECK(share_of(canvas, scale_color(1.0)) == doctest::Approx(0.5 * frame).epsilon(0.08));
    CHECK(share_of(canvas, scale_color(0.0)) < 0.02);  // of the colour scale
    CHECK(share_of(canvas, palette::rigid) < 0.01);    // of the legend

    PictureSettings air = tank;
    air.low = {2.0, 0.0, 1.2};
    CHECK(share_of(draw(half_moving_water(), air), scale_color(1.0)) < 0.02);
}

TEST_CASE("the ground is drawn within the window alone") {
    PictureSettings settings = tank;
    settings.ground_x = {0.0, 4.0};
    settings.ground_z = {1.2, 1.2};
    settings.low = {1.0, 0.0, 1.0};
    settings.high = {3.0, 0.0, 2.0};
    const Canvas canvas = draw(Snapshot{}, settings);
    const double frame = 370.0 * 740.0 / (canvas.width() * canvas.height());
    CHECK(share_of(canvas, palette::ground) == doctest::Approx(0.2 * frame).epsilon(0.1));
    settings.low[2] = 1.5;
    CHECK(share_of(draw(Snapshot{}, settings), palette::ground) < 0.001);  // of the legend
}
