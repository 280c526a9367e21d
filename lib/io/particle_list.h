// Which particle files there are, and the times that they are of. Files may be named one by one or by a
// collection that tells times: ParaView's .pvd, or a .series (.vtp.series, .vtk.series, .hdf.series, ...).
// Test: tests/unit/io/particle_list_test.cpp
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace tidewater::io {

struct ParticleList {
    std::vector<std::filesystem::path> files;
    std::vector<double> times;  // s, rising
    std::string note;           // how the times were told if not by the files; else empty
};

// Times are, in this order of preference, `times` if there are any, a collection's, and the files' own; where
// one is not told all are 0, 1, 2, ... in the order of the numbers in the files' names. Throws InputError if
// a file is missing or damaged, a collection is no such file or names none, there are not as many `times` as
// files, or two files are of one time.
ParticleList list_particles(const std::vector<std::filesystem::path>& named,
                            const std::vector<double>& times);

}  // namespace tidewater::io
