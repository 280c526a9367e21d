#include "geometry/height_field.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <limits>

namespace tidewater::geometry {
namespace {

using Point2 = Vector<2, double>;

// Patches per axis have the numbers −1 (before the first point) to count − 1 (beyond the last).
int patch_at(double place, int count) {
    return static_cast<int>(std::clamp(std::floor(place), -1.0, count - 1.0));
}

// A part of one patch: its corners' places in units of the spacing from the first point, and its heights.
struct Patch {
    double u0, v0, u1, v1;
    double z00, z01, z10, z11;  // z01: at u0 and v1
};

double at_lattice(const HeightField& field, int i, int j) {
    const auto row = static_cast<std::size_t>(std::clamp(i, 0, field.nx - 1));
    const auto column = static_cast<std::size_t>(std::clamp(j, 0, field.ny - 1));
    return field.heights[row * static_cast<std::size_t>(field.ny) + column];
}

// The part of patch (i, j) from (u0, v0) to (u1, v1), which must lie in it.
Patch part_of_patch(const HeightField& field, int i, int j, double u0, double v0, double u1, double v1) {
    const double z00 = at_lattice(field, i, j), z01 = at_lattice(field, i, j + 1);
    const double z10 = at_lattice(field, i + 1, j), z11 = at_lattice(field, i + 1, j + 1);
    const auto share = [](double place, int patch, int count) {  // constant beyond the points
        return patch < 0 || patch >= count - 1 ? 0.0 : place - patch;
    };
    const auto height = [&](double u, double v) {
        const double s = share(u, i, field.nx), t = share(v, j, field.ny);
        return (1.0 - s) * ((1.0 - t) * z00 + t * z01) + s * ((1.0 - t) * z10 + t * z11);
    };
    return {u0, v0, u1, v1, height(u0, v0), height(u0, v1), height(u1, v0), height(u1, v1)};
}

// No point of the patch is nearer to the point (u, v), `over` above z = 0, lengths in spacings: the distance
// to the plane through the middles of its edges, cut off at the patch's rectangle, less what the patch is off
// that plane, a quarter of its twist, at its corners. Squared, that to the plane is convex in the place, so
// it is least at the plane's own foot or on an edge.
double least_distance(const Patch& patch, double u, double v, double over) {
    const double width = patch.u1 - patch.u0, depth = patch.v1 - patch.v0;
    const double twist = patch.z00 + patch.z11 - patch.z01 - patch.z10;
    const double gu = width > 0.0 ? 0.5 * (patch.z10 + patch.z11 - patch.z00 - patch.z01) / width : 0.0;
    const double gv = depth > 0.0 ? 0.5 * (patch.z01 + patch.z11 - patch.z00 - patch.z10) / depth : 0.0;
    const double u0 = patch.u0 - u, u1 = patch.u1 - u, v0 = patch.v0 - v, v1 = patch.v1 - v;
    const double middle = 0.25 * (patch.z00 + patch.z01 + patch.z10 + patch.z11) - over;
    const double h = middle - 0.5 * (gu * (u0 + u1) + gv * (v0 + v1));  // of the plane at the point's place
    const auto squared = [&](double du, double dv) {
        const double rise = h + gu * du + gv * dv;
        return du * du + dv * dv + rise * rise;
    };
    const double foot = -h / (1.0 + gu * gu + gv * gv);
    double least = std::numeric_limits<double>::infinity();
    if (gu * foot >= u0 && gu * foot <= u1 && gv * foot >= v0 && gv * foot <= v1) {
        least = squared(gu * foot, gv * foot);
    } else {
        for (const double du : {u0, u1})
            least = std::min(least, squared(du, std::clamp(-gv * (h + gu * du) / (1.0 + gv * gv), v0, v1)));
        for (const double dv : {v0, v1})
            least = std::min(least, squared(std::clamp(-gu * (h + gv * dv) / (1.0 + gu * gu), u0, u1), dv));
    }
    return std::max(std::sqrt(least) - 0.25 * std::abs(twist), 0.0);
}

// ∫ over s from s0 to s1 of a²/(2D), a and D linear with a0, a1 and D0, D1 > 0 there: the area above zero of
// the straight line from one edge, a above it, to the other, D lower and below it. With a = αD + β the
// integrand is (α²D + 2αβ + β²/D)/2; where D hardly changes that would cancel, and Gauss's rule is as good.
double integral_of_ratio(double width, double a0, double a1, double d0, double d1) {
    if (std::min(d0, d1) > 0.5 * std::max(d0, d1)) {
        constexpr std::array node{0.18343464249564980, 0.52553240991632899, 0.79666647741362674,
                                  0.96028985649753623};  // of 8 points, Abramowitz & Stegun table 25.4
        constexpr std::array weight{0.36268378337836198, 0.31370664587788729, 0.22238103445337447,
                                    0.10122853629037626};
        double sum = 0.0;
        for (std::size_t n = 0; n < node.size(); ++n) {
            for (const double s : {0.5 * (1.0 - node[n]), 0.5 * (1.0 + node[n])}) {
                const double a = std::lerp(a0, a1, s);
                sum += 0.25 * weight[n] * a * a / std::lerp(d0, d1, s);
            }
        }
        return width * sum;
    }
    const double alpha = (a1 - a0) / (d1 - d0), beta = a0 - alpha * d0;
    const double last = std::min(d0, d1) > 0.0 ? beta * beta / (d1 - d0) * std::log(d1 / d0) : 0.0;
    return 0.5 * width * (0.5 * alpha * alpha * (d0 + d1) + 2.0 * alpha * beta + last);
}

// ∫ of max(z, 0) over a patch of 1 × 1: between the places where an edge along u crosses zero.
double positive_volume(const Patch& patch) {
    const auto [lowest, highest] = std::minmax({patch.z00, patch.z01, patch.z10, patch.z11});
    if (highest <= 0.0) return 0.0;
    if (lowest >= 0.0) return 0.25 * (patch.z00 + patch.z01 + patch.z10 + patch.z11);
    const auto crossing = [](double a, double b) { return (a < 0.0) == (b < 0.0) ? 0.0 : a / (a - b); };
    std::array stops{0.0, crossing(patch.z00, patch.z10), crossing(patch.z01, patch.z11), 1.0};
    std::ranges::sort(stops);
    double volume = 0.0;
    for (std::size_t piece = 0; piece < 3; ++piece) {
        const double s0 = stops[piece], s1 = stops[piece + 1], middle = 0.5 * (s0 + s1);
        if (s1 <= s0) continue;
        const auto left = [&](double s) { return std::lerp(patch.z00, patch.z10, s); };
        const auto right = [&](double s) { return std::lerp(patch.z01, patch.z11, s); };
        const double a = left(middle), b = right(middle);
        if ((a < 0.0) == (b < 0.0)) {
            volume += (s1 - s0) * std::max(0.5 * (a + b), 0.0);
            continue;
        }
        const double sign = a > b ? 1.0 : -1.0;
        const auto high = [&](double s) { return std::max(a > b ? left(s) : right(s), 0.0); };
        const auto drop = [&](double s) { return std::max(sign * (left(s) - right(s)), 0.0); };
        volume += integral_of_ratio(s1 - s0, high(s0), high(s1), drop(s0), drop(s1));
    }
    return volume;
}

}  // namespace

double HeightField::height(double x, double y) const {
    assert(heights.size() == static_cast<std::size_t>(nx) * static_cast<std::size_t>(ny) && nx > 0 && ny > 0);
    const double u = (x - x0) / spacing, v = (y - y0) / spacing;
    return part_of_patch(*this, patch_at(u, nx), patch_at(v, ny), u, v, u, v).z00;
}

Vector<2, double> HeightField::slope(double x, double y) const {
    const double u = (x - x0) / spacing, v = (y - y0) / spacing;
    const int i = patch_at(u, nx), j = patch_at(v, ny);
    const Patch along_u = part_of_patch(*this, i, j, i, v, i + 1.0, v);
    const Patch along_v = part_of_patch(*this, i, j, u, j, u, j + 1.0);
    return {i < 0 || i >= nx - 1 ? 0.0 : (along_u.z10 - along_u.z00) / spacing,
            j < 0 || j >= ny - 1 ? 0.0 : (along_v.z01 - along_v.z00) / spacing};
}

double HeightField::greatest() const { return *std::ranges::max_element(heights); }
double HeightField::least() const { return *std::ranges::min_element(heights); }

double signed_distance(const HeightField& field, const Point& point, double within) {
    const double u = (point[0] - field.x0) / field.spacing, v = (point[1] - field.y0) / field.spacing;
    const double above = point[2] - field.height(point[0], point[1]);
    double distance = std::min(std::abs(above), within) / field.spacing;  // in spacings from here on

    // Of each patch only the part counts where a nearer point of the surface could lie.
    const double reach = distance;
    const auto clipped = [&](double place, double middle) {
        return std::clamp(place, middle - reach, middle + reach);
    };
    constexpr double far = std::numeric_limits<double>::infinity();
    const auto begin = [&](int patch) { return patch < 0 ? -far : patch; };
    const auto end = [&](int patch, int count) { return patch >= count - 1 ? far : patch + 1.0; };
    const double w = point[2] / field.spacing;
    const auto look_at = [&](int i, int j) {
        const double u0 = clipped(begin(i), u), u1 = clipped(end(i, field.nx), u);
        const double v0 = clipped(begin(j), v), v1 = clipped(end(j, field.ny), v);
        const double du = std::clamp(u, u0, u1) - u, dv = std::clamp(v, v0, v1) - v;
        const auto [low, high] = std::minmax({at_lattice(field, i, j), at_lattice(field, i, j + 1),
                                              at_lattice(field, i + 1, j), at_lattice(field, i + 1, j + 1)});
        const double dw = std::max({low / field.spacing - w, w - high / field.spacing, 0.0});
        if (du * du + dv * dv + dw * dw >= distance * distance) return;  // not even the patch's box is nearer
        Patch part = part_of_patch(field, i, j, u0, v0, u1, v1);
        for (double* z : {&part.z00, &part.z01, &part.z10, &part.z11}) *z /= field.spacing;
        distance = std::min(distance, least_distance(part, u, v, w));
    };
    // Rows of patches from the nearest on, of each those that are within the distance found so far.
    const int i0 = patch_at(u, field.nx);
    look_at(i0, patch_at(v, field.ny));
    for (int away = 0;; ++away) {
        bool within_reach = false;
        for (const int i : {i0 - away, i0 + away}) {
            if (i < -1 || i >= field.nx || (away == 0 && within_reach)) continue;
            const double du = i < i0 ? u - end(i, field.nx) : i > i0 ? begin(i) - u : 0.0;
            if (du >= distance) continue;
            within_reach = true;
            const double half = std::sqrt(distance * distance - du * du);
            const int last = patch_at(v + half, field.ny);
            for (int j = patch_at(v - half, field.ny); j <= last; ++j) look_at(i, j);
        }
        if (!within_reach) break;
    }
    return field.spacing * (above < 0.0 ? -distance : distance);
}

double volume_above(const HeightField& field, const Rectangle& rectangle, double level) {
    const double u_low = (rectangle.x_low - field.x0) / field.spacing;
    const double u_high = (rectangle.x_high - field.x0) / field.spacing;
    const double v_low = (rectangle.y_low - field.y0) / field.spacing;
    const double v_high = (rectangle.y_high - field.y0) / field.spacing;
    const auto from = [](double low, int patch) {
        return patch < 0 ? low : std::max(low, static_cast<double>(patch));
    };
    const auto to = [](double high, int patch, int count) {
        return patch >= count - 1 ? high : std::min(high, patch + 1.0);
    };
    double volume = 0.0;
    for (int i = patch_at(u_low, field.nx); i <= patch_at(u_high, field.nx); ++i) {
        const double u0 = from(u_low, i), u1 = to(u_high, i, field.nx);
        for (int j = patch_at(v_low, field.ny); u1 > u0 && j <= patch_at(v_high, field.ny); ++j) {
            const double v0 = from(v_low, j), v1 = to(v_high, j, field.ny);
            if (v1 <= v0) continue;
            Patch part = part_of_patch(field, i, j, u0, v0, u1, v1);
            for (double* z : {&part.z00, &part.z01, &part.z10, &part.z11}) *z -= level;
            volume += (u1 - u0) * (v1 - v0) * field.spacing * field.spacing * positive_volume(part);
        }
    }
    return volume;
}

}  // namespace tidewater::geometry
