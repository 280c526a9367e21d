#include "io/elevation_file.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "io/height_raster.h"
#include "io/text.h"

namespace tidewater::io {
namespace {

std::string extent_text(const std::array<double, 4>& extent) {
    const auto range = [](double low, double high) {
        const int decimals = std::max(std::abs(low), std::abs(high)) < 1000.0 ? 4 : 0;
        return format_fixed(low, decimals) + " to " + format_fixed(high, decimals);
    };
    return "x " + range(extent[0], extent[2]) + ", y " + range(extent[1], extent[3]);
}

std::string place_text(const MapLattice& lattice, int i, int j) {
    const auto [east, north] = lattice.on_map(i, j);
    return "(" + format_fixed(east, 1) + ", " + format_fixed(north, 1) +
           ") on the map (scene x = " + format_number(i * lattice.spacing()) +
           " m, y = " + format_number(j * lattice.spacing()) + " m)";
}

// The raster's pixels cover its extent; what lies a rounding outside counts as inside.
void check_coverage(const HeightRaster& raster, const MapLattice& lattice) {
    const RasterFacts& facts = raster.facts();
    constexpr double rounding = 1e-6;
    constexpr double far = std::numeric_limits<double>::infinity();
    std::array<double, 4> scene{far, far, -far, -far};  // columns and rows
    for (int i = 0; i < lattice.nx(); ++i) {
        for (int j = 0; j < lattice.ny(); ++j) {
            const auto [column, row] = lattice.in_raster(i, j, 0.5, 0.5);
            scene = {std::min(scene[0], column), std::min(scene[1], row), std::max(scene[2], column),
                     std::max(scene[3], row)};
        }
    }
    const double edge = -0.5 - rounding;
    if (scene[0] >= edge && scene[1] >= edge && scene[2] <= facts.columns + edge + 2 * rounding &&
        scene[3] <= facts.rows + edge + 2 * rounding)
        return;
    const auto span = [](double low, double high) {
        return format_fixed(low + 0.5, 1) + " to " + format_fixed(high + 0.5, 1);
    };
    std::array<double, 4> on_map{far, far, -far, -far};
    for (const int i : {0, lattice.nx() - 1}) {
        for (const int j : {0, lattice.ny() - 1}) {
            const auto [east, north] = lattice.on_map(i, j);
            on_map = {std::min(on_map[0], east), std::min(on_map[1], north), std::max(on_map[2], east),
                      std::max(on_map[3], north)};
        }
    }
    throw InputError(facts.file + ": the scene reaches beyond it: the scene spans " + extent_text(on_map) +
                     " on the map, columns " + span(scene[0], scene[2]) + " and rows " +
                     span(scene[1], scene[3]) + " of the raster's " + std::to_string(facts.columns) + " x " +
                     std::to_string(facts.rows) + " pixels, which span " + extent_text(facts.extent) +
                     "; move origin, turn azimuth, shorten the domain or take a larger raster");
}

RasterWindow read_window(const HeightRaster& raster, const MapLattice& lattice, int margin) {
    const auto [left, right] = std::ranges::minmax(lattice.columns());
    const auto [top, bottom] = std::ranges::minmax(lattice.rows());
    const auto down = [&](double place, int count) {
        return static_cast<int>(std::clamp(std::floor(place) - margin, 0.0, count - 1.0));
    };
    const auto up = [&](double place, int count) {
        return static_cast<int>(std::clamp(std::ceil(place) + margin, 0.0, count - 1.0));
    };
    const int columns = raster.facts().columns, rows = raster.facts().rows;
    const int column = down(left, columns), row = down(top, rows);
    const double pixels = (up(right, columns) - column + 1.0) * (up(bottom, rows) - row + 1.0);
    if (pixels > 1e9) {
        throw InputError(raster.facts().file + ": the scene covers " + format_number(pixels) +
                         " of its pixels, too many to read; make it coarser, say with gdalwarp -tr " +
                         format_number(0.5 * lattice.spacing()) + " " +
                         format_number(0.5 * lattice.spacing()) + " -r average");
    }
    return raster.read(column, row, up(right, columns) - column + 1, up(bottom, rows) - row + 1);
}

// Calls use(pixel's index, weight) for the pixels between which (column, row) lies; beyond the outermost
// centres it is moved onto them.
template <class Use>
void for_each_weight(const RasterFacts& facts, const RasterWindow& window, const std::array<double, 2>& place,
                     const Use& use) {
    const double column = std::clamp(place[0], 0.0, facts.columns - 1.0);
    const double row = std::clamp(place[1], 0.0, facts.rows - 1.0);
    const int left = static_cast<int>(column), top = static_cast<int>(row);
    for (const int right : {0, 1}) {
        for (const int down : {0, 1}) {
            const double weight =
                (right ? column - left : left + 1.0 - column) * (down ? row - top : top + 1.0 - row);
            // A place on a pixel's centre, but for rounding, rests on that pixel alone.
            if (weight > 1e-9) use(window.index(left + right, top + down), weight);
        }
    }
}

// The same for all samples of a lattice point.
template <class Use>
void for_each_sample(const RasterFacts& facts, const RasterWindow& window, const MapLattice& lattice,
                     int samples, int i, int j, const Use& use) {
    for (int a = 0; a < samples; ++a) {
        for (int b = 0; b < samples; ++b) {
            const auto place = lattice.in_raster(i, j, (a + 0.5) / samples, (b + 0.5) / samples);
            for_each_weight(facts, window, place, use);
        }
    }
}

// Longer side of the largest hole of which the scene needs a pixel, m.
double largest_hole(const RasterWindow& window, const std::vector<std::uint8_t>& needed,
                    const std::array<double, 2>& pixel) {
    std::vector<std::uint8_t> open = window.missing;
    double largest = 0.0;
    std::vector<std::size_t> stack;
    const auto width = static_cast<std::size_t>(window.columns),
               height = static_cast<std::size_t>(window.rows);
    const auto visit = [&](std::size_t at) {
        if (!open[at]) return;
        open[at] = 0;
        stack.push_back(at);
    };
    for (std::size_t start = 0; start < needed.size(); ++start) {
        if (!needed[start]) continue;
        std::size_t left = width, right = 0, top = height, bottom = 0;
        visit(start);
        while (!stack.empty()) {
            const std::size_t at = stack.back(), column = at % width, row = at / width;
            stack.pop_back();
            left = std::min(left, column), right = std::max(right, column);
            top = std::min(top, row), bottom = std::max(bottom, row);
            if (column > 0) visit(at - 1);
            if (column + 1 < width) visit(at + 1);
            if (row > 0) visit(at - width);
            if (row + 1 < height) visit(at + width);
        }
        if (right < left) continue;  // a hole that was seen before
        largest = std::max({largest, static_cast<double>(right - left + 1) * pixel[0],
                            static_cast<double>(bottom - top + 1) * pixel[1]});
    }
    return largest;
}

// Finds the holes in what the scene needs and, by the rule, refuses or fills them.
void mend_holes(const HeightRaster& raster, const MapLattice& lattice, NodataRule rule, RasterWindow& window,
                ElevationReport& report) {
    std::vector<std::uint8_t> needed;  // the missing pixels on which lattice points rest
    std::array<int, 2> first{};
    const auto find_holes = [&] {
        needed.assign(window.missing.size(), 0);
        int points = 0;
        for (int i = 0; i < lattice.nx(); ++i) {
            for (int j = 0; j < lattice.ny(); ++j) {
                bool whole = true;
                for_each_sample(raster.facts(), window, lattice, report.samples, i, j,
                                [&](std::size_t pixel, double) {
                                    if (window.missing[pixel]) needed[pixel] = 1, whole = false;
                                });
                if (!whole && points++ == 0) first = {i, j};
            }
        }
        return points;
    };
    report.nodata_points = find_holes();
    if (report.nodata_points == 0) return;
    const double count = static_cast<double>(lattice.nx()) * lattice.ny();
    report.nodata_share = report.nodata_points / count;
    report.largest_hole = largest_hole(window, needed, report.pixel);
    const std::string holes = raster.facts().file + ": no data at " + std::to_string(report.nodata_points) +
                              " of the scene's " + format_number(count) + " points (" +
                              format_fixed(100.0 * report.nodata_share, 2) + " %), the first at " +
                              place_text(lattice, first[0], first[1]) + "; the largest hole is " +
                              format_fixed(report.largest_hole, 0) + " m long";
    if (rule == NodataRule::refuse) {
        throw InputError(holes + "; give nodata = \"fill\" to fill holes from their rim, or move the scene");
    }
    // The rims may lie outside of what the scene needs.
    window = read_window(raster, lattice, std::max(window.columns, window.rows) / 2 + 1);
    fill_missing(window);
    if (find_holes() == 0) return;
    throw InputError(holes +
                     ", with no rim around it to fill it from; move the scene or take another raster");
}

void check_height(const HeightRaster& raster, const MapLattice& lattice, double elevation, int i, int j) {
    if (elevation > -5000.0 && elevation < 9000.0) return;
    throw InputError(
        raster.facts().file + ": the elevation " + format_number(elevation) + " m at " +
        place_text(lattice, i, j) +
        " is none of a fjord or a glacier; if it marks missing data, declare that value, say with "
        "gdal_edit.py -a_nodata");
}

}  // namespace

std::string describe(const ElevationReport& report) {
    std::string text = report.file + ": " + report.driver + ", " + std::to_string(report.columns) + " x " +
                       std::to_string(report.rows) + " pixels of " + format_fixed(report.pixel[0], 1) +
                       " x " + format_fixed(report.pixel[1], 1) + " m, " +
                       (report.crs.empty() ? "no system of its own" : report.crs) +
                       (report.other_system ? " (places turned into it)" : "") + "; ";
    text += report.samples > 1 ? "mean of " + std::to_string(report.samples) + " x " +
                                     std::to_string(report.samples) + " samples a cell"
                               : std::string("bilinear");
    text += "; z from " + format_fixed(report.lowest, 1) + " to " + format_fixed(report.highest, 1) + " m";
    if (report.nodata_points > 0) {
        text += "; " + std::to_string(report.nodata_points) + " points (" +
                format_fixed(100.0 * report.nodata_share, 2) +
                " %) filled from the rim of holes, the largest " + format_fixed(report.largest_hole, 0) +
                " m long";
    }
    return text;
}

ElevationGrid read_elevation(const std::string& path, const ElevationMap& map, double spacing, int nx, int ny,
                             NodataRule rule) {
    const HeightRaster raster(path);
    const RasterFacts& facts = raster.facts();
    const MapLattice lattice(raster, map, spacing, nx, ny);
    check_coverage(raster, lattice);

    ElevationGrid grid{spacing, nx, ny, {}, {}};
    ElevationReport& report = grid.report;
    report.file = facts.file, report.driver = facts.driver, report.crs = facts.crs;
    report.columns = facts.columns, report.rows = facts.rows, report.extent = facts.extent;
    report.pixel = lattice.pixel_size();
    report.other_system = raster.is_other_system(map.crs);
    const double ratio = spacing / std::min(report.pixel[0], report.pixel[1]);
    report.samples = std::max(1, static_cast<int>(std::ceil(ratio - 1e-6)));

    RasterWindow window = read_window(raster, lattice, 0);
    mend_holes(raster, lattice, rule, window, report);
    for (int i = 0; i < nx; ++i) {
        for (int j = 0; j < ny; ++j) {
            double sum = 0.0, weights = 0.0;
            for_each_sample(facts, window, lattice, report.samples, i, j,
                            [&](std::size_t pixel, double weight) {
                                sum += weight * window.heights[pixel];
                                weights += weight;
                            });
            check_height(raster, lattice, sum / weights, i, j);
            grid.heights.push_back(sum / weights - map.datum);
        }
    }
    report.lowest = *std::ranges::min_element(grid.heights);
    report.highest = *std::ranges::max_element(grid.heights);
    return grid;
}

}  // namespace tidewater::io
