// Elevation models: GeoTIFF, ESRI ASCII grid, NetCDF and whatever else GDAL reads, sampled on the lattice of
// a scene.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "io/elevation_map.h"

namespace tidewater::io {

enum class NodataRule {
    refuse,  // a hole is an error that says how many points, where, and the remedy nodata = "fill"
    fill,    // from the rim of the hole, as io/height_raster.h's fill_missing does
};

// What was read and what was done to it.
struct ElevationReport {
    std::string file, driver, crs;  // crs: the name of the file's own system; empty if it has none
    int columns = 0, rows = 0;
    std::array<double, 2> pixel{};       // m, width and height on the map, at the scene's middle
    std::array<double, 4> extent{};      // least x and y, greatest x and y of the raster, in its own system
    bool other_system = false;           // places were turned from map.crs into the file's system
    int samples = 1;                     // per axis of each lattice cell; 1: no averaging
    double lowest = 0.0, highest = 0.0;  // z on the lattice, m
    int nodata_points = 0;               // of the lattice, whose height rests on filled pixels
    double nodata_share = 0.0;           // of the lattice's points
    double largest_hole = 0.0;           // m, the longer side of the largest hole's pixels
};

// One line for a summary: file, driver, size, system, averaging, heights, holes.
std::string describe(const ElevationReport& report);

struct ElevationGrid {
    double spacing = 0.0;  // m
    int nx = 0, ny = 0;
    std::vector<double> heights;  // z, m, at (i spacing, j spacing), index i ny + j
    ElevationReport report;
};

// Heights at the scene's lattice points, i from 0 to nx − 1 along x, j to ny − 1 along y; ny = 1: along the
// line y = 0. `path` is a file or "NETCDF:file:variable". Between pixels' centres heights are bilinear, in
// the outer half of the outermost pixels those of their centres. Where pixels are finer than the lattice each
// point is the mean over spacing × spacing around it, of n × n bilinear samples no farther apart than a
// pixel, so that nothing finer than the lattice shows as something coarser.
//
// Throws InputError, one line with file, place and remedy, for what io/height_raster.h refuses, if a lattice
// point lies beyond the raster, rests on missing data (see NodataRule) or is no height on Earth (undeclared
// nodata). Test: tests/unit/io/elevation_file_test.cpp.
ElevationGrid read_elevation(const std::string& path, const ElevationMap& map, double spacing, int nx, int ny,
                             NodataRule rule = NodataRule::refuse);

}  // namespace tidewater::io
