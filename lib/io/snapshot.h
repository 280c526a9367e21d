// Snapshots of all particles at one time: the files frame_NNNN.hdf.
//
// Layout: VTKHDF UnstructuredGrid 1.0, so that ParaView, VTK, h5py and xarray open them. The group /VTKHDF
// holds Points (N × 3) and one poly-vertex cell over them; /VTKHDF/PointData holds the columns of the table
// below, optional ones only if the run has them. The file's root has the attributes format, format_version,
// time (s), dimension and the provenance (program, version, command, scene_hash, seed). Every array carries
// checksums; equal snapshots with equal provenance are equal bytes.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <tuple>
#include <vector>

#include "core/provenance.h"

namespace tidewater::io {

inline constexpr std::int64_t snapshot_format_version = 1;

struct Snapshot {
    int dimension = 2;                   // 2 or 3
    double time = 0.0;                   // s
    std::vector<float> points;           // m, (x, y, z) per particle; y = 0 in 2D
    std::vector<float> velocity;         // m/s, (x, y, z) per particle; y = 0 in 2D
    std::vector<float> pressure;         // Pa, smoothed over the grid
    std::vector<float> volume;           // m³ (2D: m²), at rest
    std::vector<std::uint8_t> material;  // the numbers of core's Material
    std::vector<std::uint32_t> id;       // the particle's number; the same in every frame

    std::vector<float> principal_stress;  // Pa, tension positive (mpm/readings/principal_stress.h); NaN: no
                                          // ice. Empty in runs without ice

    // Of runs with ice that fractures; else empty.
    std::vector<float> damage;        // share of the strength lost, 1 - p0(α)/p0(α0); 0 for water and rigid
    std::vector<float> alpha;         // hardening α: failed from 0 on, above it what has opened; NaN: no ice
    std::vector<float> failure_time;  // s, when the ice had lost all of it; NaN: not failed, or no ice

    std::size_t particle_count() const { return points.size() / 3; }
};

template <class T>
struct SnapshotColumn {
    const char* name;
    int components;  // values per particle
    std::vector<T> Snapshot::*values;
    bool optional = false;  // left out of the file while it is empty; readers do without it
    bool has_gaps = false;  // NaN stands for no value
};

// What is stored per particle besides its point. A new column is one member above and one line here: writing,
// reading, checking and the ParaView collection follow this table. A new optional column needs no new format
// version, for readers look for the columns that they know.
inline constexpr std::tuple snapshot_columns{
    SnapshotColumn<float>{"velocity", 3, &Snapshot::velocity},
    SnapshotColumn<float>{"pressure", 1, &Snapshot::pressure},
    SnapshotColumn<float>{"volume", 1, &Snapshot::volume},
    SnapshotColumn<std::uint8_t>{"material", 1, &Snapshot::material},
    SnapshotColumn<std::uint32_t>{"id", 1, &Snapshot::id},
    SnapshotColumn<float>{"principal_stress", 1, &Snapshot::principal_stress, true, true},
    SnapshotColumn<float>{"damage", 1, &Snapshot::damage, true},
    SnapshotColumn<float>{"alpha", 1, &Snapshot::alpha, true, true},
    SnapshotColumn<float>{"failure_time", 1, &Snapshot::failure_time, true, true},
};

// Calls visit(column) for every column of the table, in its order.
template <class Visit>
void for_each_column(const Visit& visit) {
    std::apply([&](const auto&... column) { (visit(column), ...); }, snapshot_columns);
}

// Whether the snapshot does without this column.
template <class T>
bool left_out(const Snapshot& snapshot, const SnapshotColumn<T>& column) {
    return column.optional && (snapshot.*column.values).empty();
}

// "frame_0007.hdf"; more digits from frame 10000 on.
std::string snapshot_name(std::size_t frame);

// Every column, unless it is left out, must hold components × particle_count() values; no particles is
// allowed.
// Throws std::invalid_argument if it does not, OutputError if the file cannot be written.
void write_snapshot(const std::filesystem::path& path, const Snapshot& snapshot,
                    const Provenance& provenance);

// Throws InputError if the file is missing, truncated, damaged, foreign, of a newer format version, or lacks
// a column that is not optional.
Snapshot read_snapshot(const std::filesystem::path& path);

// The time alone, without reading the particles. Throws like read_snapshot.
double read_snapshot_time(const std::filesystem::path& path);

// The snapshots in a folder, in the order of their numbers, which run from 0 without a gap. Throws InputError
// if there is none or one is missing.
std::vector<std::filesystem::path> list_snapshots(const std::filesystem::path& folder);

// Replaces folder/frame.hdf.series, by which ParaView shows the frames as one animation with their times.
// frame_times[n] is the time of snapshot_name(n). Throws OutputError.
void write_series(const std::filesystem::path& folder, const std::vector<double>& frame_times);

}  // namespace tidewater::io
