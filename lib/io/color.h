// Colours of pictures and charts.
#pragma once

#include <array>
#include <cstdint>
#include <string>

namespace tidewater::io {

struct Color {
    std::uint8_t red = 0, green = 0, blue = 0;  // sRGB
    bool operator==(const Color&) const = default;
};

namespace palette {
inline constexpr Color paper{255, 255, 255};
inline constexpr Color ink{38, 42, 48};
inline constexpr Color faint{200, 204, 210};
inline constexpr Color air{246, 248, 250};
inline constexpr Color rigid{226, 168, 92};
inline constexpr Color ground{168, 152, 132};
inline constexpr Color ice{214, 232, 240};
inline constexpr Color failed_ice{98, 94, 92};
inline constexpr Color water{58, 112, 164};
inline constexpr Color no_value{176, 176, 176};
}  // namespace palette

// Lines that stay apart for all common kinds of colour blindness (Okabe & Ito 2008). index is taken modulo
// their number.
Color line_color(std::size_t index);

// Colour of a quantity from 0 to 1, clamped: from dark blue over green to pale yellow. Lightness increases
// monotonically and equal steps look equal, as distances in OKLab (Ottosson 2020), so that it also reads in
// grey and with colour blindness.
Color scale_color(double share);

// Colour of a quantity from -1 to 1, clamped: blue below zero, white at zero, orange to brown above. Both
// sides get darker alike and in steps that look equal, so that in grey, and with colour blindness, equal
// sizes look equal.
Color diverging_color(double value);

// Colour of ice that has lost this share of its strength, clamped: from palette::ice to palette::failed_ice.
// Where failed ice is as dark as water at scale_color, it is grey and the water is not.
Color damage_color(double share);

// Of the iceberg with this number, from 1 on: five colours in turn that are neither ice nor, at rest, water,
// and differ by at least 0.1 in OKLab also to people with protanopia and deuteranopia.
Color iceberg_color(std::size_t iceberg);
inline constexpr std::size_t iceberg_color_count = 5;

// From one colour to the other in equal steps, as distances in OKLab; share from 0 to 1, clamped.
Color mixed(Color from, Color to, double share);

// The colour with its light multiplied by `factor` >= 0; above 1 towards white.
Color shaded(Color color, double factor);

// L, a, b in OKLab; L is from 0 (black) to 1 (white).
std::array<double, 3> to_oklab(Color color);

// "#0a1b2c"
std::string hex(Color color);

}  // namespace tidewater::io
