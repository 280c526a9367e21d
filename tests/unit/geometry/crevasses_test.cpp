#include "geometry/crevasses.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/random.h"
#include "geometry/box.h"

using namespace tidewater;
using namespace tidewater::geometry;

namespace {

const CrevasseSettings slice{.spacing = 80.0, .from = 100.0, .to = 1300.0};

CrevasseSettings glacier() {
    CrevasseSettings settings{.spacing = 90.0, .angle = 15.0, .wander = 15.0, .wavelength = 250.0};
    settings.length = 300.0;
    settings.from = 0.0;
    settings.to = 900.0;
    settings.width = 1200.0;
    settings.seed = 4;
    return settings;
}

double random_between(double low, double high, std::uint64_t axis, std::uint64_t n) {
    return low + (high - low) * random_uniform(11, axis, n);
}

double at(const Crevasses& crevasses, const Point& p) { return signed_distance(crevasses, p[0], p[1], p[2]); }

Point random_place(const CrevasseSettings& s, std::uint64_t n) {
    return {random_between(s.from, s.to, 0, n), random_between(0.0, s.width, 1, n),
            random_between(-10.0, 80.0, 2, n)};
}

// Places on walls: where the distance changes its sign between random places.
std::vector<Point> walls(const Crevasses& crevasses, std::uint64_t tries) {
    std::vector<Point> found;
    for (std::uint64_t n = 0; n < tries; ++n) {
        Point outside = random_place(crevasses.settings, 2 * n), inside = outside;
        inside[0] += random_between(-12.0, 12.0, 3, n);
        inside[2] += random_between(-12.0, 12.0, 8, n);
        if ((at(crevasses, outside) < 0.0) == (at(crevasses, inside) < 0.0)) continue;
        for (int half = 0; half < 50; ++half) {
            const Point middle = 0.5 * (outside + inside);
            ((at(crevasses, middle) < 0.0) == (at(crevasses, inside) < 0.0) ? inside : outside) = middle;
        }
        found.push_back(outside);
    }
    return found;
}

void check_statistics(const CrevasseSettings& settings) {
    const Crevasses crevasses = make_crevasses(settings);
    const CrevasseStatistics found = statistics(crevasses);
    CHECK(found.count == crevasses.list.size());
    const auto check_range = [](const CrevasseStatistics::Range& range, const std::array<double, 2>& asked) {
        CHECK(range.mean == doctest::Approx(0.5 * (asked[0] + asked[1])).epsilon(0.001));
        CHECK(range.least >= asked[0]);
        CHECK(range.greatest <= asked[1]);
        CHECK(range.greatest - range.least > 0.8 * (asked[1] - asked[0]));
    };
    check_range(found.depth, settings.depth);
    check_range(found.opening, settings.opening);
    CHECK(found.spacing.mean == doctest::Approx(settings.spacing).epsilon(0.05));
    CHECK(found.spacing.least > 0.35 * settings.spacing);
    CHECK(found.spacing.greatest < 1.65 * settings.spacing);
    CHECK(found.spacing.greatest > 1.1 * found.spacing.least);
}

}  // namespace

TEST_CASE("crevasses have the mean depth, opening and spacing asked for, within their ranges") {
    check_statistics(slice);
    check_statistics(glacier());
    CrevasseSettings through = glacier();
    through.length = 0.0;
    check_statistics(through);
    CrevasseSettings few_turned = glacier();
    few_turned.to = 500.0;
    few_turned.angle = -4.0;
    few_turned.length = 0.0;
    check_statistics(few_turned);
    for (std::uint64_t seed = 1; seed < 50; ++seed) {
        CrevasseSettings few = slice;
        few.seed = seed;
        few.to = 600.0;      // six
        few.length = 300.0;  // means nothing in 2D
        const auto found = statistics(make_crevasses(few));
        CHECK(found.count == 6);
        CHECK(found.depth.mean == doctest::Approx(35.0));
        CHECK(found.opening.mean == doctest::Approx(7.5));
        CHECK(found.spacing.mean == doctest::Approx(80.0));
    }
}

TEST_CASE("depths along a crevasse stay below its greatest, reach it, and end at nothing") {
    const Crevasses crevasses = make_crevasses(glacier());
    CHECK(crevasses.list.size() > 30);
    for (const Crevasse& crevasse : crevasses.list) {
        double depth = 0.0, opening = 0.0;
        for (std::size_t n = crevasse.knot; n < crevasse.knot + crevasse.knots; ++n) {
            depth = std::max(depth, crevasses.knots[n].depth);
            opening = std::max(opening, crevasses.knots[n].opening);
        }
        CHECK(depth == doctest::Approx(crevasse.depth));
        CHECK(opening == doctest::Approx(crevasse.opening));
        CHECK(crevasses.knots[crevasse.knot].depth == doctest::Approx(0.0));
        CHECK(crevasses.knots[crevasse.knot + crevasse.knots - 1].depth == doctest::Approx(0.0));
    }
    double length = 0.0;
    for (const Crevasse& crevasse : crevasses.list) length += crevasse.to - crevasse.from;
    CHECK(length / static_cast<double>(crevasses.list.size()) == doctest::Approx(300.0).epsilon(0.1));
}

TEST_CASE("a crevasse's section is the notch of the header") {
    CrevasseSettings one{.depth = {40.0, 40.0}, .opening = {8.0, 8.0}, .spacing = 100.0};
    one.to = 100.0;
    const Crevasses crevasses = make_crevasses(one);
    REQUIRE(crevasses.list.size() == 1);
    const auto distance = [&](double u, double below) {
        return signed_distance(crevasses, 50.0 + u, 0.0, below);
    };
    CHECK(distance(4.0, 0.0) == doctest::Approx(0.0));
    CHECK(distance(-4.0, -3.0) == doctest::Approx(0.0));
    CHECK(distance(0.0, -3.0) == doctest::Approx(-4.0));
    CHECK(distance(9.0, -3.0) == doctest::Approx(5.0));
    CHECK(distance(0.0, 40.0) == doctest::Approx(0.0));
    CHECK(distance(0.0, 47.0) == doctest::Approx(7.0));
    CHECK(distance(0.0, 39.0) == doctest::Approx(-1.0));
    CHECK(distance(4.0, 40.0) > 2.5);
    CHECK(signed_distance(crevasses, 50.0, 700.0, 0.0) == doctest::Approx(distance(0.0, 0.0)));
}

TEST_CASE("in 2D the area with a negative distance is the closed form") {
    const Crevasses crevasses = make_crevasses(slice);
    const double step = 0.1;
    double area = 0.0;
    for (double x = 100.0 + 0.5 * step; x < 1300.0; x += step) {
        for (double below = 0.5 * step; below < 55.0; below += step)
            area += signed_distance(crevasses, x, 0.0, below) < 0.0 ? step * step : 0.0;
    }
    CHECK(statistics(crevasses).volume == doctest::Approx(area).epsilon(0.002));
}

TEST_CASE("in 3D the volume with a negative distance is the closed form") {
    for (const double length : {0.0, 300.0}) {
        CrevasseSettings settings = glacier();
        settings.length = length;
        settings.angle = length == 0.0 ? 0.0 : 15.0;
        const Crevasses crevasses = make_crevasses(settings);
        const std::uint64_t tries = 1'000'000;
        double hits = 0.0;
        for (std::uint64_t n = 0; n < tries; ++n) {
            const double x = random_between(settings.from - 200.0, settings.to + 200.0, 0, n);
            const double y = random_between(0.0, settings.width, 1, n),
                         below = random_between(0.0, 50.0, 2, n);
            hits += signed_distance(crevasses, x, y, below) < 0.0;
        }
        const double room = (settings.to - settings.from + 400.0) * settings.width * 50.0;
        CHECK(statistics(crevasses).volume == doctest::Approx(room * hits / tries).epsilon(0.015));
    }
}

TEST_CASE(
    "the distance is that to the nearest wall in 2D, and in 3D never more, close to walls hardly less") {
    for (const CrevasseSettings& settings : {slice, glacier()}) {
        const Crevasses crevasses = make_crevasses(settings);
        const bool flat = settings.width == 0.0;
        const auto found = walls(crevasses, flat ? 400'000 : 2'000'000);
        REQUIRE(found.size() > 2000);
        double near_sum = 0.0, near_count = 0.0, worst = 0.0;
        for (std::uint64_t n = 0; n < 2000; ++n) {
            const Point p = n % 2 ? random_place(settings, 7 * n + 1)
                                  : Point(found[n] + Point(random_between(-2, 2, 4, n), 0, 0));
            double nearest = std::numeric_limits<double>::infinity();
            for (const Point& wall : found) nearest = std::min(nearest, (wall - p).norm());
            const double value = std::abs(at(crevasses, p));
            worst = std::max(worst, value - nearest);
            if (flat && p[2] > -5.0) CHECK(value > nearest - 0.5);  // walls are sampled
            if (nearest > 1.0 && nearest < 5.0) near_sum += value / nearest, near_count += 1.0;
        }
        CHECK(worst < 1e-9);
        CHECK(near_sum / near_count > 0.85);
    }
}

TEST_CASE("the distance changes by no more than the way") {
    for (const CrevasseSettings& settings : {slice, glacier()}) {
        const Crevasses crevasses = make_crevasses(settings);
        double worst = 0.0;
        for (std::uint64_t n = 0; n < 300'000; ++n) {
            const Point p = random_place(settings, n);
            const Point step{random_between(-1, 1, 5, n),
                             settings.width > 0.0 ? random_between(-1, 1, 6, n) : 0.0,
                             random_between(-1, 1, 7, n)};
            worst = std::max(worst, std::abs(at(crevasses, p + step) - at(crevasses, p)) / step.norm());
        }
        CHECK(worst < 1.0 + 1e-9);
    }
}

TEST_CASE("crevasses keep apart: between two neighbours there is ice at the surface") {
    CrevasseSettings tight = glacier();
    tight.spacing = 22.0;
    tight.length = 0.0;
    const Crevasses crevasses = make_crevasses(tight);
    for (std::size_t t = 1; t < crevasses.traces.size(); ++t) {
        for (double along = -500.0; along < 500.0; along += 5.0) {
            double least = 0.0, greatest = 0.0;
            const double low = crevasses.traces[t - 1], high = crevasses.traces[t];
            for (double across = low - 15.0; across < high + 15.0; across += 0.25) {
                const double x = across * crevasses.axis[0] + along * crevasses.axis[1];
                const double y = 600.0 - across * crevasses.axis[1] + along * crevasses.axis[0];
                const double value = signed_distance(crevasses, x, y, 0.0);
                least = std::min(least, value);
                greatest = std::max(greatest, value);
            }
            CHECK(greatest > 0.5);
            CHECK(least > -5.01);
        }
    }
}

TEST_CASE("the same seed gives the same crevasses, another one others") {
    const auto values = [](std::uint64_t seed) {
        CrevasseSettings settings = glacier();
        settings.seed = seed;
        const Crevasses crevasses = make_crevasses(settings);
        std::vector<double> found;
        for (std::uint64_t n = 0; n < 1000; ++n) found.push_back(at(crevasses, random_place(settings, n)));
        return found;
    };
    CHECK(values(1) == values(1));
    CHECK(values(1) != values(2));
}

TEST_CASE("settings that leave no ice between crevasses are refused with what would do") {
    CrevasseSettings bad = slice;
    bad.spacing = 8.0;
    CHECK_THROWS_WITH_AS(
        make_crevasses(bad),
        "crevasses: with openings up to 10.00 m they would overlap at a spacing of 8.00 m; it must be "
        "at least 12.50 m",
        SceneError);
    bad = glacier();
    bad.wander = 200.0;
    CHECK_THROWS_WITH_AS(make_crevasses(bad), doctest::Contains("makes traces cross"), SceneError);
    bad = slice;
    bad.depth = {50.0, 20.0};
    CHECK_THROWS_WITH_AS(make_crevasses(bad), doctest::Contains("depth must be a range"), SceneError);
    bad = slice;
    bad.to = 101.0;
    CHECK_THROWS_WITH_AS(make_crevasses(bad), doctest::Contains("no room"), SceneError);
    bad = glacier();
    bad.width = 80.0;
    bad.angle = 80.0;
    bad.to = 30.0;
    bad.spacing = 200.0;
    CHECK_THROWS_WITH_AS(make_crevasses(bad), doctest::Contains("none fits between 0.00 m and 30.00 m"),
                         SceneError);
    bad = slice;
    bad.depth = {2.0, 20.0};
    CHECK_THROWS_WITH_AS(make_crevasses(bad), doctest::Contains("half the opening"), SceneError);
}
