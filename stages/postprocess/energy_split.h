// Where the energy of a run with blocks went: into the water, and lost.
#pragma once

#include <filesystem>
#include <vector>

#include "bodies.h"
#include "core/provenance.h"
#include "io/table.h"

namespace tidewater::postprocess {

// Changes since the start, J (2D: per m of width), at the ledger's times:
//     block + water + lost = brought
struct EnergySplit {
    std::vector<double> time;     // s
    std::vector<double> block;    // kinetic and potential energy of all blocks
    std::vector<double> water;    // kinetic, gravitational and elastic energy of all else
    std::vector<double> lost;     // by the scheme and by impacts: the start's total energy less the present
    std::vector<double> brought;  // work done at the boundaries less what flowed out

    double greatest_rise() const;  // of the total energy above its start, ≥ 0
};

// ledger: read from `path`. The blocks' energies between their own times are linear. Throws InputError if a
// column is missing.
EnergySplit split_energy(const io::Table& ledger, const std::filesystem::path& path,
                         const std::vector<Body>& bodies);

// energy_split.csv: time, block, water, lost, brought.
void write_energy_split(const std::filesystem::path& path, const EnergySplit& split,
                        const Provenance& provenance);

}  // namespace tidewater::postprocess
