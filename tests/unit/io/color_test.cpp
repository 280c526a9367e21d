#include "io/color.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

using namespace tidewater::io;

namespace {

double difference(Color a, Color b) {
    const auto p = to_oklab(a), q = to_oklab(b);
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

}  // namespace

TEST_CASE("OKLab has white at lightness one and no colour in greys") {
    for (const std::uint8_t grey : {std::uint8_t{0}, std::uint8_t{90}, std::uint8_t{255}}) {
        const auto lab = to_oklab({grey, grey, grey});
        CHECK(std::abs(lab[1]) < 1e-4);
        CHECK(std::abs(lab[2]) < 1e-4);
    }
    CHECK(to_oklab({255, 255, 255})[0] == doctest::Approx(1.0).epsilon(1e-4));
}

TEST_CASE("the scale gets lighter all along, in steps that look equal") {
    constexpr int steps = 16;
    double least = 1.0, greatest = 0.0;
    for (int i = 0; i < steps; ++i) {
        const Color a = scale_color(static_cast<double>(i) / steps), b = scale_color((i + 1.0) / steps);
        CHECK(to_oklab(b)[0] > to_oklab(a)[0]);
        least = std::min(least, difference(a, b));
        greatest = std::max(greatest, difference(a, b));
    }
    CHECK(greatest < 1.25 * least);
}

TEST_CASE("the scale is clamped, and what is no number is its lower end") {
    CHECK(scale_color(-1.0) == scale_color(0.0));
    CHECK(scale_color(7.0) == scale_color(1.0));
    CHECK(scale_color(std::nan("")) == scale_color(0.0));
}

TEST_CASE("solids stand out from the scale, the air and each other") {
    for (const Color solid : {palette::rigid, palette::ice, palette::failed_ice}) {
        CHECK(difference(solid, palette::air) > 0.05);
        for (double share = 0.0; share <= 1.0; share += 0.01)
            CHECK(difference(solid, scale_color(share)) > 0.05);
    }
    CHECK(difference(palette::rigid, palette::ice) > 0.1);
    CHECK(difference(palette::failed_ice, palette::ice) > 0.1);
}

TEST_CASE(
    "the diverging scale is white at zero and gets darker on both sides alike, in steps that look equal") {
    constexpr int steps = 8;
    for (const double sign : {-1.0, 1.0}) {
        double least = 1.0, greatest = 0.0;
        for (int i = 0; i < steps; ++i) {
            const Color a = diverging_color(sign * i / steps), b = diverging_color(sign * (i + 1.0) / steps);
            CHECK(to_oklab(b)[0] < to_oklab(a)[0]);
            least = std::min(least, difference(a, b));
            greatest = std::max(greatest, difference(a, b));
        }
        CHECK(greatest < 1.25 * least);
    }
    for (double size = 0.0; size <= 1.0; size += 0.125) {
        const Color below = diverging_color(-size), above = diverging_color(size);
        CHECK(std::abs(to_oklab(below)[0] - to_oklab(above)[0]) < 0.02);
        if (size >= 0.25) CHECK(difference(below, above) > 0.1);
    }
    CHECK(diverging_color(-7.0) == diverging_color(-1.0));
    CHECK(to_oklab(diverging_color(0.0))[0] > 0.97);
}

TEST_CASE("ice gets darker with damage, which is clamped") {
    for (double share = 0.0; share < 1.0; share += 0.125)
        CHECK(to_oklab(damage_color(share + 0.125))[0] < to_oklab(damage_color(share))[0]);
    CHECK(damage_color(-1.0) == palette::ice);
    CHECK(damage_color(std::nan("")) == palette::ice);
    CHECK(damage_color(2.0) == palette::failed_ice);
}

TEST_CASE("shading darkens to black and lightens to white") {
    const Color color{100, 150, 200};
    CHECK(shaded(color, 1.0) == color);
    CHECK(shaded(color, 0.0) == Color{0, 0, 0});
    CHECK(shaded(color, 2.0) == Color{255, 255, 255});
    CHECK(hex(Color{10, 27, 255}) == "#0a1bff");
}

TEST_CASE("a mixture of two colours begins and ends with them, and is even between") {
    const Color from{206, 226, 240}, to{18, 52, 108};
    CHECK(mixed(from, to, 0.0) == from);
    CHECK(mixed(from, to, 1.0) == to);
    CHECK(mixed(from, to, -3.0) == from);
    CHECK(mixed(from, to, 7.0) == to);
    const double middle = 0.5 * (to_oklab(from)[0] + to_oklab(to)[0]);
    CHECK(to_oklab(mixed(from, to, 0.5))[0] == doctest::Approx(middle).epsilon(0.01));
}
