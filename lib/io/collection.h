// ParaView collections derived from snapshots: one .vtp per frame and a .pvd that gives their times.
//
// particles_NNNN.vtp is vtkPolyData with one poly-vertex cell over all points, the columns that the
// snapshot has, velocity_magnitude (m/s) and the derived columns. Data is inline binary, compressed with LZ4:
// Debian's ParaView 5.11 cannot open appended data. 10 million particles of 15 numbers: 0.8 GB.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/provenance.h"
#include "io/snapshot.h"

namespace tidewater::io {

inline constexpr int particles_format_version = 1;

// What is not in the snapshot, one value per particle; an empty column is left out.
struct DerivedColumns {
    std::vector<float> alpha;           // α, where the snapshot has none but damage; NaN: no ice
    std::vector<float> p0;              // Pa; NaN: no ice
    std::vector<std::int32_t> iceberg;  // its number; 0: in none
};

// "particles_0007.vtp"; more digits from frame 10000 on.
std::string particles_name(std::size_t frame);

// Replaces path as a whole; format, format_version and the provenance go into field data. Needs 12 B per
// particle besides. Throws OutputError.
void write_particles(const std::filesystem::path& path, const Snapshot& snapshot,
                     const DerivedColumns& derived, const Provenance& provenance);

// The particles of one share in `every`, chosen by their numbers, so that every frame keeps the same ones;
// all if every = 1, none if it is 0. Where few are left each still stands for its own volume alone.
Snapshot thin_out(const Snapshot& snapshot, int every);

struct CollectionEntry {
    std::string name;   // of a file in the folder of the .pvd
    double time = 0.0;  // s
};

// Replaces path as a whole; the provenance goes into an XML comment. Throws OutputError.
void write_collection(const std::filesystem::path& path, const std::vector<CollectionEntry>& entries,
                      const Provenance& provenance);

}  // namespace tidewater::io
