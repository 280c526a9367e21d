#include "io/drawing.h"

#include <doctest/doctest.h>

#include "io/rasterise.h"
#include "unit/io/fixture.h"

using namespace tidewater;
using namespace tidewater::io;

namespace {

Canvas pixels(const Drawing& drawing) { return rasterise(drawing.svg(test_provenance())); }

int count(const Canvas& canvas, Color color) {
    int found = 0;
    for (int y = 0; y < canvas.height(); ++y) {
        for (int x = 0; x < canvas.width(); ++x) found += canvas.at(x, y) == color;
    }
    return found;
}

}  // namespace

TEST_CASE("shapes fill the pixels that they cover, later ones over earlier ones") {
    Drawing drawing(40, 30);
    CHECK(count(pixels(drawing), palette::paper) == 40 * 30);
    drawing.rectangle({2.0, 3.0}, {12.0, 9.0}, palette::water);
    CHECK(count(pixels(drawing), palette::water) == 60);
    drawing.triangle({20.0, 0.0}, {20.0, 20.0}, {40.0, 0.0}, palette::ground);
    CHECK(count(pixels(drawing), palette::ground) == doctest::Approx(200.0).epsilon(0.12));
    drawing.rectangle({0.0, 0.0}, {50.0, 60.0}, palette::rigid, 0.5);
    CHECK(pixels(drawing).at(1, 1) != palette::rigid);
    drawing.rectangle({-5.0, -5.0}, {50.0, 60.0}, palette::rigid);
    CHECK(count(pixels(drawing), palette::rigid) == 40 * 30);
}

TEST_CASE("lines are as wide as asked for, and dashes leave gaps") {
    Drawing whole(100, 10), dashed(100, 10);
    whole.line({0.0, 5.0}, {100.0, 5.0}, 4.0, palette::ink);
    CHECK(count(pixels(whole), palette::ink) == 400);
    dashed.dashed_line({0.0, 5.0}, {100.0, 5.0}, 4.0, 6.0, 4.0, palette::ink);
    CHECK(count(pixels(dashed), palette::ink) == 240);
}

TEST_CASE("a picture within the figure keeps its pixels, and its transparent ones show what is below") {
    Canvas inner(3, 2, palette::paper, 0.0);
    inner.blend(0, 0, Color{200, 100, 50});
    inner.blend(2, 1, Color{1, 2, 3});
    Drawing drawing(10, 10);
    drawing.rectangle({0.0, 0.0}, {10.0, 10.0}, palette::air);
    drawing.image(inner, {4.0, 5.0});
    const Canvas canvas = pixels(drawing);
    CHECK(canvas.at(4, 5) == Color{200, 100, 50});
    CHECK(canvas.at(6, 6) == Color{1, 2, 3});
    CHECK(canvas.at(5, 5) == palette::air);
}

TEST_CASE("a colour bar goes from the left, or from below, from one end of its scale to the other") {
    Drawing drawing(300, 300);
    drawing.color_bar({20.0, 10.0}, {276.0, 20.0}, scale_color, false);
    drawing.color_bar({5.0, 30.0}, {15.0, 286.0}, scale_color, true);
    const Canvas canvas = pixels(drawing);
    CHECK(canvas.at(20, 15) == scale_color(0.5 / 256));
    CHECK(canvas.at(275, 15) == scale_color(255.5 / 256));
    CHECK(canvas.at(10, 285) == scale_color(0.5 / 256));
    CHECK(canvas.at(10, 30) == scale_color(255.5 / 256));
}

TEST_CASE("text of any language leaves ink where it is put, aligned to its place") {
    for (const char* letters : {"speed", "√η δ µ ±", "Ålesund, für", "10⁻⁴ m³", "<&>"}) {
        Drawing drawing(400, 40);
        drawing.text({200.0, 20.0}, Align::right, 16.0, letters);
        const Canvas canvas = pixels(drawing);
        int left = 400, right = 0, missing = 0;
        for (int y = 0; y < 40; ++y) {
            for (int x = 0; x < 400; ++x) {
                if (to_oklab(canvas.at(x, y))[0] > 0.8) continue;
                left = std::min(left, x);
                right = std::max(right, x);
                missing += y < 5 || y > 35;
            }
        }
        CHECK(right < 201);
        CHECK(right > 193);
        CHECK(right - left == doctest::Approx(text_width(16.0, letters)).epsilon(0.15));
        CHECK(missing == 0);
    }
    Drawing outside(100, 40);
    outside.text({-90.0, 80.0}, Align::left, 30.0, "out");
    CHECK(count(pixels(outside), palette::paper) == 100 * 40);
}

TEST_CASE("a text is as wide as its letters") {
    const double one = text_width(20.0, "m"), three = text_width(20.0, "mmm");
    CHECK(one > 8.0);
    CHECK(three > 2.5 * one);
    CHECK(text_width(40.0, "mmm") == doctest::Approx(2.0 * three).epsilon(0.1));
}
