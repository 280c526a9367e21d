#include "io/color.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

using namespace tidewater::io;

namespace {

double difference(Color a, Color b) {
    const auto p = to_oklab(a), q = to_oklab(b);
    return std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]);
}

// Each row's products with the linear red, green and blue of a colour are those that an observer who lacks
// one kind of cone tells apart (Machado, Oliveira and Fernandes 2009, severity 1).
using Vision = std::array<std::array<double, 3>, 3>;
constexpr Vision full{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
constexpr Vision protanopia{
    {{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}};
constexpr Vision deuteranopia{
    {{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}};
constexpr std::array visions{full, protanopia, deuteranopia};

Color seen_with(const Vision& vision, Color color) {
    const auto decode = [](double value) {
        const double share = value / 255.0;
        return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
    };
    const std::array<double, 3> light{decode(color.red), decode(color.green), decode(color.blue)};
    const auto part = [&](std::size_t row) {
        double sum = 0.0;
        for (std::size_t i = 0; i < 3; ++i) sum += vision[row][i] * light[i];
        const double linear = std::clamp(sum, 0.0, 1.0);
        const double share =
            linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
        return static_cast<std::uint8_t>(std::lround(255.0 * share));
    };
    return {part(0), part(1), part(2)};
}

// The least difference of two colours for any of the three kinds of observers.
double difference_to_all(Color a, Color b) {
    double least = 1.0;
    for (const Vision& vision : visions)
        least = std::min(least, difference(seen_with(vision, a), seen_with(vision, b)));
    return least;
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

TEST_CASE("the scale is clamped, and what is not a number is its lower end") {
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

TEST_CASE(
    "eight classes of speed, of the surface's height and of damage stay apart for colour-blind readers") {
    constexpr int classes = 8;
    for (const Vision& vision : visions) {
        for (int i = 0; i + 1 < classes; ++i) {
            const double low = static_cast<double>(i) / (classes - 1), high = (i + 1.0) / (classes - 1);
            const Color slow = seen_with(vision, scale_color(low)),
                        fast = seen_with(vision, scale_color(high));
            CHECK(to_oklab(fast)[0] > to_oklab(slow)[0] + 0.04);
            CHECK(difference_to_all(scale_color(low), scale_color(high)) > 0.05);
            CHECK(difference_to_all(damage_color(low), damage_color(high)) > 0.05);
            CHECK(difference_to_all(diverging_color(2.0 * low - 1.0), diverging_color(2.0 * high - 1.0)) >
                  0.05);
        }
    }
    for (double size = 0.25; size <= 1.0; size += 0.125)
        CHECK(difference_to_all(diverging_color(-size), diverging_color(size)) > 0.1);
}

TEST_CASE("icebergs differ from each other, from ice and from water at rest for colour-blind readers") {
    for (std::size_t a = 1; a <= iceberg_color_count; ++a) {
        for (std::size_t b = 1; b < a; ++b)
            CHECK(difference_to_all(iceberg_color(a), iceberg_color(b)) > 0.1);
        for (const Color other : {palette::ice, palette::failed_ice, palette::air, scale_color(0.0)})
            CHECK(difference_to_all(iceberg_color(a), other) > 0.08);
        CHECK(iceberg_color(a) == iceberg_color(a + iceberg_color_count));
    }
}

TEST_CASE("lines of charts differ for colour-blind readers") {
    for (std::size_t a = 0; a < 6; ++a) {
        for (std::size_t b = 0; b < a; ++b) CHECK(difference_to_all(line_color(a), line_color(b)) > 0.07);
    }
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
