// How a scene lies on a map, and its lattice in a raster.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "io/height_raster.h"

namespace tidewater::io {

// Where the scene lies on the map. With the azimuth α of the scene's x axis,
//
//     E = E0 + x sin α − y cos α,  N = N0 + x cos α + y sin α,  z = elevation − datum
//
// so that y is to the left of x; α = 90° puts x along E and y along N. Distances on the map are taken as
// distances on the ground: the map's own scale (in UTM within 0.04 % of 1) is left out.
struct ElevationMap {
    std::array<double, 2> origin{};  // (E, N) of the scene's x = y = 0, m
    double azimuth = 90.0;           // °, from the map's grid north clockwise
    double datum = 0.0;              // m, the elevation that is z = 0
    // The map's coordinate reference system, in metres: "EPSG:3413", WKT or PROJ text. Empty: the file's own.
    // Where the file has another one, places are turned into it (horizontally; heights stay as they are).
    std::string crs = {};
};

// The points (i, j) of a scene's lattice, i from 0 to nx − 1 along x, j to ny − 1 along y, each in the middle
// of its cell of spacing × spacing. Places in the raster are columns and rows as HeightRaster counts them;
// within a cell they are bilinear between its corners.
class MapLattice {
public:
    // Throws what HeightRaster::to_pixels does.
    MapLattice(const HeightRaster& raster, const ElevationMap& map, double spacing, int nx, int ny);

    int nx() const { return nx_; }
    int ny() const { return ny_; }
    double spacing() const { return spacing_; }

    // (E, N) of a point, or of a place between points, m.
    std::array<double, 2> on_map(double i, double j) const;

    // (column, row) at the shares s along x and t along y of the cell of point (i, j); (½, ½) is the point.
    std::array<double, 2> in_raster(int i, int j, double s, double t) const;

    // Width and height of the raster's pixels, m, at the lattice's middle.
    std::array<double, 2> pixel_size() const;

    // Of all corners of cells.
    const std::vector<double>& columns() const { return columns_; }
    const std::vector<double>& rows() const { return rows_; }

private:
    // Of the lower corner of the cell of point (i, j); there are nx + 1 by ny + 1 corners.
    std::size_t corner(int i, int j) const;

    ElevationMap map_;
    double spacing_;
    int nx_, ny_;
    std::vector<double> columns_, rows_;
};

}  // namespace tidewater::io
