// bodies.csv: where each rigid block is, how it moves and what pushes it; one row per block and time.
#pragma once

#include <filesystem>
#include <vector>

#include "core/provenance.h"
#include "io/table.h"
#include "readings.h"

namespace tidewater {

//     time, body (1, 2, …)      s
//     x, (y,) z                 of the centre, m
//     angle                     2D: degrees, from x towards z, −180 … 180
//     rotation_x, _y, _z        3D: axis times angle, degrees
//     velocity_x …              m/s
//     spin (3D: spin_x …)       rad/s; in 2D from x towards z
//     fastest                   speed of its fastest corner, m/s
//     water_force_x …           by water and ice, mean since the row before, N; nan in the first
//     water_torque (3D: _x …)   likewise about the centre, N m
//     contact_force_x …         by walls, bed and other blocks, likewise, N
//     kinetic, potential        J; M g z
//     mass                      kg
// In 2D per metre of width.
class BodiesTable {
public:
    BodiesTable(const std::filesystem::path& path, const Provenance& provenance, int dimension);

    // Rows of one time (s), with gravity in m/s².
    void append(int dimension, double gravity, double time, const std::vector<BodyReading>& bodies);

    io::TableWriter& table() { return table_; }

    // Time and impulses of the row before, to go on behind a checkpoint.
    std::vector<double> last;

private:
    io::TableWriter table_;
};

}  // namespace tidewater
