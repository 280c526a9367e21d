#include "io/section_picture.h"

#include <doctest/doctest.h>

#include <cmath>

#include "core/files.h"
#include "core/parallel.h"
#include "io/rasterise.h"
#include "unit/io/fixture.h"

using namespace tidewater;
using namespace tidewater::io;

namespace {

// A tank of 400 m × 200 m × 100 m: the ground 20 m high, rising to 50 m beyond x = 300 m; ice to x = 100 m,
// 90 m high; water to z = 70 m. A crack of 1 m goes through the ice at x = 50 m.
Substance glacier(double x, double, double z) {
    if (z < (x < 300.0 ? 20.0 : 50.0)) return Substance::bed;
    if (x < 100.0 && z < 90.0) return std::abs(x - 50.0) < 0.5 ? Substance::nothing : Substance::ice;
    return z < 70.0 ? Substance::water : Substance::nothing;
}

Top seen(double x, double y) {
    if (y > 180.0) return {Substance::bed, 80.0, 80.0};
    if (x < 100.0) return {Substance::ice, 90.0, 20.0};
    return {Substance::water, 70.0, x < 300.0 ? 20.0 : 50.0};
}

SectionSettings tank(int dimension) {
    SectionSettings settings;
    settings.dimension = dimension;
    settings.high = {400.0, 200.0, 100.0};
    settings.across = 100.0;
    settings.still_level = 70.0;
    settings.title = "a tank";
    settings.at = glacier;
    if (dimension == 3) settings.top = seen;
    return settings;
}

Canvas pixels(const SectionPicture& picture) { return rasterise(picture.drawing.svg(test_provenance())); }

Color color_at(const Canvas& canvas, Pixel at) {
    return canvas.at(static_cast<int>(std::floor(at.x)), static_cast<int>(std::floor(at.y)));
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

TEST_CASE("a section shows at each place the colour of what is there") {
    for (const int dimension : {2, 3}) {
        const SectionPicture picture = draw_section(tank(dimension));
        const Canvas canvas = pixels(picture);
        const auto at = [&](double x, double z) { return color_at(canvas, picture.section.at(x, z)); };
        CHECK(at(20.0, 60.0) == palette::ice);
        CHECK(at(20.0, 95.0) == palette::air);
        CHECK(at(20.0, 10.0) == palette::ground);
        CHECK(at(200.0, 40.0) == palette::water);
        CHECK(at(200.0, 75.0) == palette::air);
        CHECK(at(350.0, 40.0) == palette::ground);
        CHECK(at(350.0, 60.0) == palette::water);
    }
}

TEST_CASE("a crack much thinner than a pixel shows") {
    SectionSettings settings = tank(2);
    settings.width = 400;
    const SectionPicture picture = draw_section(settings);
    const Canvas canvas = pixels(picture);
    CHECK(picture.section.high.x - picture.section.low.x < 400.0);  // more than 1 m a pixel
    const Color color = color_at(canvas, picture.section.at(50.0, 50.0));
    CHECK(to_oklab(color)[0] < to_oklab(palette::ice)[0] - 0.1);
}

TEST_CASE("a plan shows ice, land, depths and the front, at one scale along both axes") {
    const SectionPicture picture = draw_section(tank(3));
    const Canvas canvas = pixels(picture);
    const Panel& plan = picture.plan;
    const auto at = [&](double x, double y) { return color_at(canvas, plan.at(x, y)); };
    CHECK(at(50.0, 50.0) == ice_height_color(1.0));
    CHECK(at(200.0, 50.0) == depth_color(1.0));
    CHECK(at(350.0, 50.0) == depth_color(20.0 / 50.0));
    CHECK(at(200.0, 190.0) == palette::ground);
    CHECK(at(99.8, 50.0) == front_color);
    CHECK(at(50.0, 179.0) == ice_height_color(1.0));  // land is no front
    CHECK((plan.high.x - plan.low.x) / 400.0 ==
          doctest::Approx((plan.high.y - plan.low.y) / 200.0).epsilon(0.01));
    CHECK(plan.low.x == picture.section.low.x);
    CHECK(plan.high.x == picture.section.high.x);
    const SectionPicture flat = draw_section(tank(2));
    CHECK(flat.drawing.height() < picture.drawing.height() - 500);
}

TEST_CASE("cracks and crevasses open to the water are no front") {
    SectionSettings settings = tank(3);
    settings.top = [](double x, double y) {
        return std::abs(y - 100.0) < 1.0 && x < 100.0 ? Top{Substance::water, 70.0, 20.0} : seen(x, y);
    };
    const SectionPicture picture = draw_section(settings);
    const Canvas canvas = pixels(picture);
    int orange = 0;
    for (double x = 0.0; x < 90.0; x += 0.1) {
        for (double y = 95.0; y < 105.0; y += 0.1)
            orange += color_at(canvas, picture.plan.at(x, y)) == front_color;
    }
    CHECK(orange == 0);
    CHECK(color_at(canvas, picture.plan.at(99.8, 90.0)) == front_color);
}

TEST_CASE("heights of a long thin scene are exaggerated by a round number, others are not") {
    SectionSettings settings = tank(2);
    CHECK(draw_section(settings).exaggeration == 1.0);
    settings.high = {4500.0, 0.0, 335.0};
    const SectionPicture picture = draw_section(settings);
    const Canvas canvas = pixels(picture);
    CHECK(picture.exaggeration == 2.5);
    const Panel& panel = picture.section;
    const double vertical = (panel.high.y - panel.low.y) / 335.0,
                 horizontal = (panel.high.x - panel.low.x) / 4500.0;
    CHECK(vertical / horizontal == doctest::Approx(2.5).epsilon(0.01));
}

TEST_CASE("a dimension line stands where it is asked for, with its text on paper") {
    SectionSettings settings = tank(2);
    settings.measures = {{130.0, 70.0, 90.0, "cliff 20 m"}};
    const SectionPicture picture = draw_section(settings);
    const Canvas canvas = pixels(picture);
    CHECK(color_at(canvas, picture.section.at(130.0, 80.0)) == line_color(1));
    CHECK(!(color_at(canvas, picture.section.at(130.0, 60.0)) == line_color(1)));
}

TEST_CASE("the same functions give the same picture on any number of threads, which is written as a PNG") {
    const TemporaryFolder folder;
    const auto draw = [](int threads) {
        const ThreadLimit limit(threads);
        SectionSettings settings = tank(3);
        settings.gauges = {{200.0, 100.0}, {210.0, 20.0}};
        return draw_section(settings);
    };
    const SectionPicture first = draw(1);
    CHECK(same_pixels(pixels(first), pixels(draw(3))));
    pixels(first).write_png(folder / "section.png", test_provenance());
    CHECK(read_text(folder / "section.png").substr(1, 3) == "PNG");
}

TEST_CASE("scenes without water, without ice and with nothing at all are drawn") {
    for (const Substance everywhere :
         {Substance::nothing, Substance::bed, Substance::ice, Substance::water}) {
        SectionSettings settings = tank(3);
        settings.width = 400;
        settings.still_level = std::nan("");
        settings.at = [=](double, double, double) { return everywhere; };
        settings.top = [=](double, double) { return Top{everywhere, 50.0, 50.0}; };
        settings.gauges = {{200.0, 100.0}};
        CHECK(draw_section(settings).drawing.width() > 0);
    }
}

TEST_CASE(
    "what a section shows side by side differs in lightness, so that it reads in grey and to everyone") {
    const std::array substances{Substance::nothing, Substance::bed, Substance::water, Substance::ice,
                                Substance::rigid};
    for (const Substance a : substances) {
        for (const Substance b : substances) {
            if (a == b) continue;
            CHECK(std::abs(to_oklab(substance_color(a))[0] - to_oklab(substance_color(b))[0]) > 0.05);
        }
    }
}
