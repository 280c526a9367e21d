#include "analysis/first_crack.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <random>

using namespace tidewater::analysis;

namespace {

constexpr double spacing = 2.0;
constexpr double never = std::numeric_limits<double>::quiet_NaN();

// Ice from x = 10 m, z = 30 m on, which rises with x by `slope`.
struct Slab {
    double length = 300.0, height = 80.0, width = 0.0;  // m; width 0: 2D
    double slope = 0.0;
    std::vector<float> points, volume, failure_time;

    // fails(d, z, y) is when the ice d behind the front and z above the base fails; never: NaN.
    template <class Fails>
    Slab& fill(const Fails& fails) {
        for (double z = 0.5 * spacing; z < height; z += spacing) {
            for (double y = 0.5 * spacing; y < std::max(width, spacing); y += spacing) {
                for (double x = 0.5 * spacing; x < length; x += spacing) {
                    for (const double part : {10.0 + x, width > 0.0 ? y : 0.0, 30.0 + z + slope * x})
                        points.push_back(static_cast<float>(part));
                    volume.push_back(1.0f);
                    failure_time.push_back(static_cast<float>(fails(length - x, z, y)));
                }
            }
        }
        return *this;
    }

    std::optional<FirstCrack> crack() const {
        return first_crack({points, volume, failure_time}, {.spacing = spacing});
    }
};

bool in_crack(double d, double place) { return std::abs(d - place) < 1.6 * spacing; }

// A crack from the top down to `end` above the base that begins at 5 s and goes down at 100 m/s.
double from_top(double d, double z, double place = 61.0, double end = 0.0) {
    return in_crack(d, place) && z > end ? 5.0 + (80.0 - z) / 100.0 : never;
}

double from_bottom(double d, double z) { return in_crack(d, 61.0) ? 5.0 + z / 100.0 : never; }

// A tenth of the height along the base, from the front to 100 m behind it, with columns up to 12 m.
double layer(double d, double z) {
    return d < 100.0 && z < (std::fmod(d, 10.0) < 2.0 ? 12.0 : 8.0) ? 1.0 + d / 100.0 : never;
}

double either(double a, double b) { return std::isnan(a) || b < a ? b : a; }

void expect(const std::optional<FirstCrack>& crack, double time, double start_time, double start_height,
            double position) {
    REQUIRE(crack);
    CHECK(crack->time == doctest::Approx(time));
    CHECK(crack->start_time == doctest::Approx(start_time));
    CHECK(crack->start_height == doctest::Approx(start_height));
    CHECK(std::abs(crack->position - position) < 0.1);
}

}  // namespace

TEST_CASE("a crack from the top is there once it is a quarter of the height deep") {
    const auto found = Slab{}.fill([](double d, double z, double) { return from_top(d, z); }).crack();
    expect(found, 5.19, 5.01, 79.0 / 80.0, 61.0);  // ten rows of 2 m
    CHECK(found->start() == CrackStart::top);
}

TEST_CASE("a crack from the bottom counts from the top of the layer that is left out") {
    const auto found = Slab{}.fill([](double d, double z, double) { return from_bottom(d, z); }).crack();
    expect(found, 5.31, 5.13, 13.0 / 80.0, 61.0);
    CHECK(found->start() == CrackStart::bottom);
}

TEST_CASE("a crack from within begins inside") {
    const auto found = Slab{}
                           .fill([](double d, double z, double) {
                               return in_crack(d, 61.0) ? 5.0 + std::abs(z - 45.0) / 100.0 : never;
                           })
                           .crack();
    expect(found, 5.10, 5.0, 45.0 / 80.0, 61.0);
    CHECK(found->start() == CrackStart::inside);
}

TEST_CASE("a crack that detaches nothing is one, and a shorter one is none") {
    const auto down_to = [](double end) {
        return Slab{}.fill([=](double d, double z, double) { return from_top(d, z, 61.0, end); }).crack();
    };
    expect(down_to(60.0), 5.19, 5.01, 79.0 / 80.0, 61.0);
    CHECK(!down_to(62.0));
    CHECK(!Slab{}.fill([](double, double, double) { return never; }).crack());
    CHECK(!first_crack({}, {.spacing = 1.0}));
}

TEST_CASE("a crushed layer along the base is no crack, and does not hide one from the top that joins it") {
    CHECK(!Slab{}.fill([](double d, double z, double) { return layer(d, z); }).crack());
    const auto found =
        Slab{}.fill([](double d, double z, double) { return either(layer(d, z), from_top(d, z)); }).crack();
    expect(found, 5.19, 5.01, 79.0 / 80.0, 61.0);
}

TEST_CASE("a crack that runs up from the crushed layer begins at the bottom") {
    const auto found =
        Slab{}
            .fill([](double d, double z, double) { return either(layer(d, z), from_bottom(d, z)); })
            .crack();
    REQUIRE(found);
    CHECK(found->start() == CrackStart::bottom);
    CHECK(found->start_time == doctest::Approx(5.13));
}

TEST_CASE("a crack that runs into a few failed particles did not begin with them") {
    const auto found = Slab{}
                           .fill([](double d, double z, double) {
                               if (std::abs(d - 66.0) < 4.0 && std::abs(z - 50.0) < 2.0) return 1.0;
                               return in_crack(d, 61.0) ? (z > 49.0 ? 5.0 - z / 1000.0 : 5.5) : never;
                           })
                           .crack();
    expect(found, 4.939, 4.921, 79.0 / 80.0, 61.0);
}

TEST_CASE("of two cracks the first that is deep enough counts, even if it goes no farther") {
    const auto found = Slab{}
                           .fill([](double d, double z, double) {
                               const double second = from_bottom(d, z) + 1.0;
                               return either(second, from_top(d, z, 161.0, 50.0));
                           })
                           .crack();
    expect(found, 5.19, 5.01, 79.0 / 80.0, 161.0);
    const auto later = Slab{}
                           .fill([](double d, double z, double) {
                               const double first = from_bottom(d, z) - 1.0;
                               return either(first, from_top(d, z, 161.0, 50.0));
                           })
                           .crack();
    CHECK(later->start() == CrackStart::bottom);
}

TEST_CASE("what fails at the rear, and what hangs together with it, is no crack") {
    const auto rear = [](double d, double z, double) { return d > 280.0 ? 0.1 + z / 100.0 : never; };
    CHECK(!Slab{}.fill(rear).crack());
    const auto found =
        Slab{}
            .fill([&](double d, double z, double y) { return either(rear(d, z, y), from_top(d, z)); })
            .crack();
    expect(found, 5.19, 5.01, 79.0 / 80.0, 61.0);
}

TEST_CASE("a crack that is through in one step has its start in the middle") {
    const auto found =
        Slab{}.fill([](double d, double, double) { return in_crack(d, 61.0) ? 3.0 : never; }).crack();
    REQUIRE(found);
    CHECK(found->start() == CrackStart::inside);
    CHECK(found->time == doctest::Approx(found->start_time));
}

TEST_CASE("heights are those above the base, which may rise") {
    Slab slab;
    slab.slope = 0.3;
    slab.fill([](double d, double z, double) { return either(layer(d, z), from_top(d, z)); });
    const auto found = first_crack({slab.points, slab.volume, slab.failure_time},
                                   {.spacing = spacing, .extent = 0.12, .layer = 0.08});
    REQUIRE(found);
    CHECK(found->start_time == doctest::Approx(5.01));
    CHECK(found->start() == CrackStart::top);
}

TEST_CASE("in three dimensions a crack that begins at one side has the position of that side") {
    Slab slab;
    slab.width = 40.0;
    slab.length = 200.0;
    slab.fill([](double d, double z, double y) {
        const double crack =
            std::abs(d - 80.0 + 0.5 * y) < 2.0 * spacing ? 5.0 + (80.0 - z + y) / 100.0 : never;
        return either(layer(d, z), crack);
    });
    const auto found = slab.crack();
    REQUIRE(found);
    CHECK(found->time == doctest::Approx(5.20));
    CHECK(found->start_time == doctest::Approx(5.02));
    CHECK(found->start() == CrackStart::top);
    CHECK(std::abs(found->position - 79.5) < 2.0 * spacing);
}

TEST_CASE("particles moved at random within their shares change the crack by less than two spacings") {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> part(-0.5 * spacing, 0.5 * spacing);
    auto slab = Slab{}.fill([](double d, double z, double) { return either(layer(d, z), from_top(d, z)); });
    for (std::size_t i = 0; i < slab.points.size(); ++i) {
        if (i % 3 != 1) slab.points[i] += static_cast<float>(part(random));
    }
    const auto found = slab.crack();
    REQUIRE(found);
    CHECK(std::abs(found->time - 5.19) < 0.041);
    CHECK(std::abs(found->position - 61.0) < 2.0 * spacing);
    CHECK(found->start() == CrackStart::top);
}

TEST_CASE("the first crack is found among a million particles of which all fail") {
    Slab slab;
    slab.length = 4000.0;
    slab.height = 1000.0;
    slab.fill([](double d, double z, double) { return in_crack(d, 961.0) ? z / 100.0 : 20.0 + d + z; });
    const auto begin = std::chrono::steady_clock::now();
    const auto found = slab.crack();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    REQUIRE(found);
    CHECK(found->start() == CrackStart::bottom);
    CHECK(std::abs(found->position - 961.0) < spacing);
    MESSAGE(took.count() << " s");
}
