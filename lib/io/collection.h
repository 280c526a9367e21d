// The ParaView collection derived from snapshots: one .vtp per frame and a .pvd that gives their times.
//
// particles_NNNN.vtp is vtkPolyData with one poly-vertex cell over all points, the columns that the
// snapshot has and velocity_magnitude (m/s). Data is inline binary, compressed with zlib: Debian's
// ParaView 5.11 cannot open appended data.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "core/provenance.h"
#include "io/snapshot.h"

namespace tidewater::io {

inline constexpr int particles_format_version = 1;

// "particles_0007.vtp"; more digits from frame 10000 on.
std::string particles_name(std::size_t frame);

// Replaces path as a whole; format, format_version and the provenance go into field data. Throws OutputError.
void write_particles(const std::filesystem::path& path, const Snapshot& snapshot,
                     const Provenance& provenance);

struct CollectionEntry {
    std::string name;   // of a file in the folder of the .pvd
    double time = 0.0;  // s
};

// Replaces path as a whole; the provenance goes into an XML comment. Throws OutputError.
void write_collection(const std::filesystem::path& path, const std::vector<CollectionEntry>& entries,
                      const Provenance& provenance);

}  // namespace tidewater::io
