#include "analysis/fragments.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <random>

#include "analysis/neighbours.h"

using namespace tidewater::analysis;

namespace {

// columns × layers × rows of points, a spacing of 1 m apart, in the order of x, then y, then z.
std::vector<float> lattice(int columns, int layers, int rows) {
    std::vector<float> points;
    for (int k = 0; k < rows; ++k)
        for (int j = 0; j < layers; ++j)
            for (int i = 0; i < columns; ++i)
                for (const int part : {i, j, k}) points.push_back(static_cast<float>(part));
    return points;
}

using Flags = std::vector<std::uint8_t>;

}  // namespace

TEST_CASE("pairs are those that a comparison of all with all finds, in 2D and in 3D") {
    std::mt19937 random(1);
    std::uniform_real_distribution<float> place(-3.0f, 5.0f);
    for (const float depth : {0.0f, 1.0f}) {
        std::vector<float> points;
        std::vector<std::uint32_t> chosen;
        for (std::uint32_t p = 0; p < 600; ++p) {
            for (const float scale : {1.0f, depth, 0.5f}) points.push_back(scale * place(random));
            if (p % 5) chosen.push_back(p);
        }
        constexpr double reach = 0.7;
        std::vector<int> seen(600 * 600, 0);
        for_each_pair(points, chosen, reach, [&](std::uint32_t a, std::uint32_t b) {
            ++seen[std::min(a, b) * 600 + std::max(a, b)];
        });
        int wrong = 0;
        for (std::size_t a = 0; a < 600; ++a) {
            for (std::size_t b = a + 1; b < 600; ++b) {
                double square = 0.0;
                for (std::size_t axis = 0; axis < 3; ++axis)
                    square += std::pow(double{points[3 * a + axis]} - points[3 * b + axis], 2);
                wrong += seen[a * 600 + b] != (a % 5 && b % 5 && square <= reach * reach);
            }
        }
        CHECK(wrong == 0);
    }
}

TEST_CASE("no particle, one particle and none intact make no, one and no fragment") {
    CHECK(label_fragments({}, {}, 1.5).size.empty());
    const std::vector<float> point{1.0f, 0.0f, 2.0f};
    CHECK(label_fragments(point, Flags{1}, 1.5).size == std::vector<std::uint32_t>{1});
    CHECK(label_fragments(point, Flags{0}, 1.5).size.empty());
    CHECK(label_fragments(point, Flags{0}, 1.5).label.front() == Fragments::none);
}

TEST_CASE("a failed column divides, and the larger part comes first") {
    const auto points = lattice(10, 1, 4);
    Flags intact(40, 1);
    for (std::size_t p = 3; p < 40; p += 10) intact[p] = 0;
    const auto found = label_fragments(points, intact, usual_reach);
    CHECK(found.size == std::vector<std::uint32_t>{24, 12});
    CHECK(found.label[0] == 1);
    CHECK(found.label[9] == 0);
    CHECK(found.label[13] == Fragments::none);
    intact[13] = 1;  // one particle bridges it
    CHECK(label_fragments(points, intact, usual_reach).size == std::vector<std::uint32_t>{37});
}

TEST_CASE("of fragments of one size the one with the lowest particle comes first") {
    const auto points = lattice(5, 1, 1);
    const auto found = label_fragments(points, Flags{1, 0, 1, 0, 1}, usual_reach);
    CHECK(found.label == std::vector<std::uint32_t>{0, Fragments::none, 1, Fragments::none, 2});
}

TEST_CASE("a failed layer divides a solid body across each axis") {
    const auto points = lattice(6, 6, 6);
    for (std::size_t axis = 0; axis < 3; ++axis) {
        Flags intact;
        for (std::size_t p = 0; p < 216; ++p) intact.push_back(points[3 * p + axis] != 2.0f);
        CHECK(label_fragments(points, intact, usual_reach).size == std::vector<std::uint32_t>{108, 72});
    }
}

TEST_CASE("nearly all particles anywhere within their own shares of the cells hang together") {
    std::mt19937 random(2);
    std::uniform_real_distribution<float> place(-0.5f, 0.5f);
    for (const int layers : {1, 12}) {
        auto points = lattice(60, layers, 60);
        for (std::size_t i = 0; i < points.size(); ++i) {
            if (layers > 1 || i % 3 != 1) points[i] += place(random);
        }
        const auto found = label_fragments(points, Flags(points.size() / 3, 1), usual_reach);
        CHECK(static_cast<double>(found.size[0]) > 0.998 * static_cast<double>(points.size() / 3));
    }
}

TEST_CASE("a million particles side by side are one fragment") {
    const auto points = lattice(100, 100, 100);
    CHECK(label_fragments(points, Flags(1000000, 1), usual_reach).size[0] == 1000000);
}

TEST_CASE("fragments that hold a piece of the rear are one, whatever failed between them") {
    const auto points = lattice(9, 1, 1);
    auto found = label_fragments(points, Flags{1, 0, 1, 1, 0, 1, 1, 1, 0}, usual_reach);
    REQUIRE(found.size == std::vector<std::uint32_t>{3, 2, 1});
    auto untouched = found;
    CHECK(join_fragments(Flags(9, 0), untouched) == Fragments::none);
    CHECK(join_fragments(Flags{0, 1, 0, 0, 0, 0, 0, 0, 0}, untouched) == Fragments::none);  // it failed
    CHECK(untouched.label == found.label);
    CHECK(join_fragments(Flags{1, 1, 1, 0, 0, 0, 0, 0, 0}, found) == 1);
    constexpr auto none = Fragments::none;
    CHECK(found.label == std::vector<std::uint32_t>{1, none, 1, 1, none, 0, 0, 0, none});
    CHECK(found.size == std::vector<std::uint32_t>{3, 3, 0});
}

TEST_CASE("crumbs are taken out by their volume, but not what is to be kept") {
    const auto points = lattice(9, 1, 1);
    const auto all = label_fragments(points, Flags{1, 0, 1, 1, 0, 1, 1, 1, 0}, usual_reach);
    const std::vector<float> volume(9, 2.0f);
    auto some = all;
    drop_crumbs(volume, 4.0, Fragments::none, some);
    CHECK(some.size == std::vector<std::uint32_t>{3, 2, 0});
    CHECK(some.label[0] == Fragments::none);
    CHECK(some.label[2] == 1);
    some = all;
    drop_crumbs(volume, 4.5, 2, some);
    CHECK(some.size == std::vector<std::uint32_t>{3, 0, 1});
    const FragmentMembers members = collect_members(some);
    CHECK(std::ranges::equal(members.of(0), std::vector<std::uint32_t>{5, 6, 7}));
    CHECK(members.of(1).empty());
    CHECK(std::ranges::equal(members.of(2), std::vector<std::uint32_t>{0}));
    CHECK(collect_members(some, 0).particles == std::vector<std::uint32_t>{0});
    CHECK(collect_members(Fragments{}).particles.empty());
}
