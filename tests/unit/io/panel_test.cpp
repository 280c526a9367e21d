#include "io/panel.h"

#include <doctest/doctest.h>

#include "io/rasterise.h"
#include "unit/io/fixture.h"

using namespace tidewater;
using namespace tidewater::io;

namespace {

const Panel panel{{100.0, 50.0}, {500.0, 250.0}, -10.0, 30.0, 0.0, 5.0, "x (m)", "z (m)"};

int ink_in(const Canvas& canvas, int left, int top, int right, int bottom) {
    int count = 0;
    for (int y = top; y < bottom; ++y) {
        for (int x = left; x < right; ++x) count += to_oklab(canvas.at(x, y))[0] < 0.6;
    }
    return count;
}

}  // namespace

TEST_CASE("places lie on a panel between its corners, and come back from there") {
    CHECK(panel.at(-10.0, 5.0).x == 100.0);
    CHECK(panel.at(-10.0, 5.0).y == 50.0);
    CHECK(panel.at(30.0, 0.0).x == 500.0);
    CHECK(panel.at(30.0, 0.0).y == 250.0);
    CHECK(panel.at(0.0, 1.0).x == doctest::Approx(200.0));
    CHECK(panel.at(0.0, 1.0).y == doctest::Approx(210.0));
    CHECK(panel.across(200.0) == doctest::Approx(0.0));
    CHECK(panel.upward(210.0) == doctest::Approx(1.0));
}

TEST_CASE("axes have a frame, numbers and labels outside of it, and leave the panel free") {
    Drawing drawing(600, 330);
    draw_axes(drawing, panel, 1.0);
    const Canvas canvas = rasterise(drawing.svg(test_provenance()));
    CHECK(ink_in(canvas, 103, 53, 497, 247) == 0);
    CHECK(ink_in(canvas, 99, 49, 102, 252) > 190);  // the left side
    CHECK(ink_in(canvas, 30, 60, 92, 260) > 50);    // numbers
    CHECK(ink_in(canvas, 90, 262, 520, 282) > 50);
    CHECK(ink_in(canvas, 270, 284, 330, 310) > 20);  // the label
    CHECK(ink_in(canvas, 40, 10, 98, 40) > 20);
}
