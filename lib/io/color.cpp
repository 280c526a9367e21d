#include "io/color.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdio>
#include <numbers>
#include <vector>

namespace tidewater::io {
namespace {

using Lab = std::array<double, 3>;

double decode(std::uint8_t value) {  // sRGB to linear light
    const double share = value / 255.0;
    return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
}

std::uint8_t encode(double light) {
    const double clamped = std::clamp(light, 0.0, 1.0);
    const double share =
        clamped <= 0.0031308 ? 12.92 * clamped : 1.055 * std::pow(clamped, 1.0 / 2.4) - 0.055;
    return static_cast<std::uint8_t>(std::lround(255.0 * share));
}

Color from_oklab(const Lab& lab) {
    const auto cube = [](double x) { return x * x * x; };
    const double l = cube(lab[0] + 0.3963377774 * lab[1] + 0.2158037573 * lab[2]);
    const double m = cube(lab[0] - 0.1055613458 * lab[1] - 0.0638541728 * lab[2]);
    const double s = cube(lab[0] - 0.0894841775 * lab[1] - 1.2914855480 * lab[2]);
    return {encode(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
            encode(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
            encode(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

double distance(const Lab& a, const Lab& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

Lab between(const Lab& a, const Lab& b, double share) {
    return {std::lerp(a[0], b[0], share), std::lerp(a[1], b[1], share), std::lerp(a[2], b[2], share)};
}

// The point at `length` along the line through the anchors.
Lab along(const std::vector<Lab>& anchors, double length) {
    for (std::size_t i = 1; i < anchors.size(); ++i) {
        const double piece = distance(anchors[i - 1], anchors[i]);
        if (length <= piece || i + 1 == anchors.size())
            return between(anchors[i - 1], anchors[i], length / piece);
        length -= piece;
    }
    return anchors.front();
}

// 256 colours along the line through the anchors, in equal steps.
std::array<Color, 256> make_scale(const std::vector<Lab>& anchors) {
    double length = 0.0;
    for (std::size_t i = 1; i < anchors.size(); ++i) length += distance(anchors[i - 1], anchors[i]);
    std::array<Color, 256> scale;
    for (std::size_t i = 0; i < scale.size(); ++i) {
        scale[i] = from_oklab(along(anchors, length * static_cast<double>(i) / 255.0));
    }
    return scale;
}

std::vector<Lab> speed_anchors() {
    std::vector<Lab> anchors;
    for (const Color color : {Color{16, 34, 92}, Color{18, 70, 140}, Color{22, 108, 156}, Color{44, 142, 152},
                              Color{98, 176, 136}, Color{172, 208, 124}, Color{252, 240, 158}}) {
        anchors.push_back(to_oklab(color));
    }
    return anchors;
}

// From white through a hue (degrees in OKLab's a-b plane) at full chroma to its dark.
std::vector<Lab> arm_anchors(double hue) {
    const double angle = hue * std::numbers::pi / 180.0;
    const auto lab = [&](double lightness, double chroma) {
        return Lab{lightness, chroma * std::cos(angle), chroma * std::sin(angle)};
    };
    return {lab(0.98, 0.0), lab(0.70, 0.125), lab(0.36, 0.085)};
}

Color pick(const std::array<Color, 256>& scale, double share) {
    if (!(share > 0.0)) return scale.front();
    return scale[static_cast<std::size_t>(std::lround(255.0 * std::min(share, 1.0)))];
}

}  // namespace

Color line_color(std::size_t index) {
    constexpr std::array colors{Color{0, 114, 178},   Color{213, 94, 0},  Color{0, 158, 115},
                                Color{204, 121, 167}, Color{230, 159, 0}, Color{86, 180, 233}};
    return colors[index % colors.size()];
}

Color scale_color(double share) {
    static const std::array<Color, 256> scale = make_scale(speed_anchors());
    return pick(scale, share);
}

Color diverging_color(double value) {
    static const std::array<Color, 256> blue = make_scale(arm_anchors(250.0)),
                                        orange = make_scale(arm_anchors(55.0));
    return value < 0.0 ? pick(blue, -value) : pick(orange, value);
}

Color mixed(Color from, Color to, double share) {
    return from_oklab(between(to_oklab(from), to_oklab(to), share > 0.0 ? std::min(share, 1.0) : 0.0));
}

Color damage_color(double share) { return mixed(palette::ice, palette::failed_ice, share); }

Color iceberg_color(std::size_t iceberg) {
    constexpr std::array<Color, iceberg_color_count> colors{Color{204, 51, 17}, Color{240, 228, 66},
                                                            Color{140, 60, 220}, Color{238, 136, 102},
                                                            Color{255, 170, 187}};
    return colors[(iceberg + colors.size() - 1) % colors.size()];
}

Color shaded(Color color, double factor) {
    const auto part = [&](std::uint8_t value) {
        const double light =
            factor <= 1.0 ? value * factor : value + (255.0 - value) * std::min(factor - 1.0, 1.0);
        return static_cast<std::uint8_t>(std::lround(std::max(light, 0.0)));
    };
    return {part(color.red), part(color.green), part(color.blue)};
}

Lab to_oklab(Color color) {
    const double r = decode(color.red), g = decode(color.green), b = decode(color.blue);
    const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
    const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
    const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
    return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
            1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
            0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

std::string hex(Color color) {
    char text[8];
    std::snprintf(text, sizeof text, "#%02x%02x%02x", color.red, color.green, color.blue);
    return text;
}

}  // namespace tidewater::io
