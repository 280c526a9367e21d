#include "analysis/calving.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <random>

using namespace tidewater::analysis;

namespace {

constexpr double spacing = 2.0;
constexpr double never = std::numeric_limits<double>::quiet_NaN();

// Ice from x = 10 m, z = 30 m on.
struct Slab {
    double length = 300.0, height = 80.0, width = 0.0;  // m; width 0: 2D
    std::vector<float> points, volume, failure_time;

    // fails(d, z) is when the ice d behind the front and z above the base fails; never: NaN. In 3D fails(d,
    // z, y).
    template <class Fails>
    Slab& fill(const Fails& fails) {
        for (double z = 0.5 * spacing; z < height; z += spacing) {
            for (double y = 0.5 * spacing; y < std::max(width, spacing); y += spacing) {
                for (double x = 0.5 * spacing; x < length; x += spacing) {
                    for (const double part : {10.0 + x, width > 0.0 ? y : 0.0, 30.0 + z})
                        points.push_back(static_cast<float>(part));
                    volume.push_back(static_cast<float>(spacing * spacing * (width > 0.0 ? spacing : 1.0)));
                    failure_time.push_back(static_cast<float>(fails(length - x, z, y)));
                }
            }
        }
        return *this;
    }

    std::optional<Calving> calving() const {
        return first_detachment({points, volume, failure_time},
                                {.dimension = width > 0.0 ? 3 : 2, .spacing = spacing});
    }
};

// Whether d lies in a crack at `place` that is three particles wide.
bool in_crack(double d, double place) { return std::abs(d - place) < 1.6 * spacing; }

}  // namespace

TEST_CASE("a vertical crack from the top gives the time at which it is through, its place and its start") {
    const auto slab = Slab{}.fill(
        [](double d, double z, double) { return in_crack(d, 61.0) ? 5.0 + (80.0 - z) / 100.0 : never; });
    const auto found = slab.calving();
    REQUIRE(found);
    CHECK(found->time == doctest::Approx(5.79));
    CHECK(found->length == doctest::Approx(61.0));
    CHECK(found->length_top == doctest::Approx(61.0));
    CHECK(found->length_middle == doctest::Approx(61.0));
    CHECK(found->length_bottom == doctest::Approx(61.0));
    CHECK(found->height == doctest::Approx(80.0));
    CHECK(found->volume == doctest::Approx(80.0 * 58.0));
    CHECK(found->start() == CrackStart::top);
    CHECK(found->start_time == doctest::Approx(5.01));
}

TEST_CASE("a vertical crack from the bottom starts there") {
    const auto slab =
        Slab{}.fill([](double d, double z, double) { return in_crack(d, 41.0) ? 5.0 + z / 100.0 : never; });
    const auto found = slab.calving();
    REQUIRE(found);
    CHECK(found->length == doctest::Approx(41.0));
    CHECK(found->start() == CrackStart::bottom);
    CHECK(found->start_time == doctest::Approx(5.01));
}

TEST_CASE("thirds of the height name where a crack starts") {
    CHECK(crack_start(0.9) == CrackStart::top);
    CHECK(crack_start(0.5) == CrackStart::inside);
    CHECK(crack_start(0.1) == CrackStart::bottom);
    CHECK(crack_start(NAN) == CrackStart::inside);
}

TEST_CASE("a crack from within starts inside") {
    const auto slab = Slab{}.fill([](double d, double z, double) {
        return in_crack(d, 41.0) ? 5.0 + std::abs(z - 40.0) / 100.0 : never;
    });
    CHECK(slab.calving()->start() == CrackStart::inside);
}

TEST_CASE("an inclined crack has its mean length halfway up") {
    const auto slab = Slab{}.fill([](double d, double z, double) {
        return std::abs(d - 100.0 + 0.5 * z) < 2.0 * spacing ? 5.0 + (80.0 - z) / 100.0 : never;
    });
    const auto found = slab.calving();
    REQUIRE(found);
    CHECK(std::abs(found->length - 80.0) < spacing);
    CHECK(std::abs(found->length_top - 60.0) < spacing);
    CHECK(std::abs(found->length_middle - 80.0) < spacing);
    CHECK(std::abs(found->length_bottom - 100.0) < spacing);
    CHECK(found->start() == CrackStart::top);
}

TEST_CASE("a slab that never fails, a partial crack and failed edges detach nothing") {
    CHECK(!Slab{}.fill([](double, double, double) { return never; }).calving());
    const auto partial =
        Slab{}.fill([](double d, double z, double) { return in_crack(d, 61.0) && z > 6.0 ? 5.0 : never; });
    CHECK(!partial.calving());
    const auto edges = Slab{}.fill([](double d, double z, double) {
        return (d < 10.0 && z < 20.0) || z < 4.0 || z > 75.0 ? 1.0 : never;
    });
    CHECK(!edges.calving());
    CHECK(!first_detachment({}, {.spacing = 1.0}));
}

TEST_CASE("a crushed toe and crumbs are no icebergs, and do not shorten the one that comes later") {
    const auto fails = [](double d, double z, double) {
        if (d < 12.0 && z < 14.0) return d > 4.0 ? 1.0 + z / 100.0 : never;  // crushed, with crumbs before it
        if (std::abs(d - 62.0) < 8.0 && z < 14.0) return 2.0;                // crushed at the shelf's edge
        return in_crack(d, 61.0) ? 5.0 + (80.0 - z) / 100.0 : never;
    };
    const auto found = Slab{}.fill(fails).calving();
    REQUIRE(found);
    CHECK(found->time == doctest::Approx(5.65));
    CHECK(std::abs(found->length - 61.0) < 0.5 * spacing);
    CHECK(found->start() == CrackStart::top);
    CHECK(found->start_time == doctest::Approx(5.01));
}

TEST_CASE("what is an iceberg is told by its share of the square of the height") {
    auto slab = Slab{}.fill([](double d, double, double) { return in_crack(d, 15.0) ? 1.0 : never; });
    CalvingSettings settings{.spacing = spacing, .smallest_share = 0.14};  // 12 m of 80 m are intact
    const IceAtRest ice{slab.points, slab.volume, slab.failure_time};
    CHECK(smallest_iceberg(ice, settings) == doctest::Approx(0.14 * 80.0 * 80.0));
    CHECK(first_detachment(ice, settings));
    settings.smallest_share = 0.16;
    CHECK(!first_detachment(ice, settings));
}

TEST_CASE("of two cracks the one that is through first counts, whichever is nearer to the front") {
    for (const auto& [first, second] : {std::pair{61.0, 161.0}, std::pair{161.0, 61.0}}) {
        const auto found = Slab{}
                               .fill([&](double d, double z, double) {
                                   if (in_crack(d, first)) return 5.0 + (80.0 - z) / 100.0;
                                   return in_crack(d, second) ? 5.1 + (80.0 - z) / 100.0 : never;
                               })
                               .calving();
        REQUIRE(found);
        CHECK(found->time == doctest::Approx(5.79));
        CHECK(found->length == doctest::Approx(first));
    }
}

TEST_CASE("an iceberg that crumbles later, or breaks in two, was one when it came off") {
    const auto found = Slab{}
                           .fill([](double d, double z, double) {
                               if (in_crack(d, 61.0)) return 5.0 + (80.0 - z) / 100.0;
                               return d < 61.0 ? 6.0 + z / 100.0 + d / 1000.0 : never;
                           })
                           .calving();
    REQUIRE(found);
    CHECK(found->time == doctest::Approx(5.79));
    CHECK(found->length == doctest::Approx(61.0));
    CHECK(found->volume == doctest::Approx(80.0 * 58.0));
}

TEST_CASE("a crack that is through in one step has no part that is first") {
    const auto found =
        Slab{}.fill([](double d, double, double) { return in_crack(d, 61.0) ? 3.0 : never; }).calving();
    REQUIRE(found);
    CHECK(found->time == doctest::Approx(3.0));
    CHECK(found->start_time == doctest::Approx(3.0));
    CHECK(found->start() == CrackStart::inside);
}

TEST_CASE("a rear that is crushed by what pushes it detaches nothing, and hides no iceberg") {
    const auto rear = [](double d, double, double) { return d > 293.0 ? 0.1 : never; };
    CHECK(!Slab{}.fill(rear).calving());
    const auto found = Slab{}
                           .fill([&](double d, double z, double y) {
                               return in_crack(d, 61.0) ? 5.0 + (80.0 - z) / 100.0 : rear(d, z, y);
                           })
                           .calving();
    REQUIRE(found);
    CHECK(found->time == doctest::Approx(5.79));
    CHECK(found->length == doctest::Approx(61.0));
}

TEST_CASE("an iceberg that shares no height with the rest has a volume but no length") {
    Slab slab;
    slab.fill([](double, double z, double) { return in_crack(z, 41.0) ? 3.0 : never; });
    for (std::size_t p = 0; p < slab.volume.size(); ++p) {  // the upper half begins farther from the rear
        if (slab.points[3 * p + 2] > 30.0f + 41.0f) slab.points[3 * p] += 20.0f;
    }
    const auto found = slab.calving();
    REQUIRE(found);
    CHECK(std::isnan(found->length));
    CHECK(found->volume == doctest::Approx(36.0 * 300.0));
    CHECK(found->start() == CrackStart::inside);
}

TEST_CASE("in three dimensions a crack across an inclined plane has the mean of its places") {
    Slab slab;
    slab.width = 60.0;
    slab.fill([](double d, double z, double y) {
        return std::abs(d - 80.0 + 0.5 * y) < 2.0 * spacing ? 5.0 + z / 100.0 + y / 1000.0 : never;
    });
    const auto found = slab.calving();
    REQUIRE(found);
    CHECK(std::abs(found->length - 65.0) < spacing);
    CHECK(found->start() == CrackStart::bottom);
    CHECK(std::abs(found->volume - 63.0 * 80.0 * 60.0) < 2.0 * spacing * 80.0 * 60.0);
}

TEST_CASE("particles moved at random within their shares change the length by less than a spacing") {
    std::mt19937 random(3);
    std::uniform_real_distribution<double> part(-0.5 * spacing, 0.5 * spacing);
    auto slab = Slab{}.fill(
        [](double d, double z, double) { return in_crack(d, 61.0) ? 5.0 + (80.0 - z) / 100.0 : never; });
    for (std::size_t i = 0; i < slab.points.size(); ++i) {
        if (i % 3 != 1) slab.points[i] += static_cast<float>(part(random));
    }
    const auto found = slab.calving();
    REQUIRE(found);
    CHECK(std::abs(found->length - 61.0) < spacing);
    CHECK(found->start() == CrackStart::top);
}

TEST_CASE("the first iceberg is found among a million particles of which all fail") {
    Slab slab;
    slab.length = 4000.0;
    slab.height = 1000.0;
    slab.fill([](double d, double z, double) { return in_crack(d, 961.0) ? z / 100.0 : 20.0 + d + z; });
    const auto begin = std::chrono::steady_clock::now();
    const auto found = slab.calving();
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    REQUIRE(found);
    CHECK(found->length == doctest::Approx(961.0));
    MESSAGE(took.count() << " s");
}

TEST_CASE("a single particle that is as large as an iceberg is none when it fails") {
    Slab slab;
    slab.length = 40.0;
    slab.height = 8.0;  // four particles high: one is 1/16 of the height squared
    slab.fill([](double d, double z, double) { return d > 20.0 && d < 22.0 && z < 2.0 ? 1.0 : never; });
    CHECK(!slab.calving());
    Slab front;
    front.length = 40.0;
    front.height = 8.0;
    front.fill([](double d, double z, double) { return d > 20.0 && d < 22.0 ? 3.0 - 0.1 * z : never; });
    const auto found = front.calving();
    REQUIRE(found);
    CHECK(found->time == doctest::Approx(2.9));
    CHECK(found->length == doctest::Approx(21.0));
}
