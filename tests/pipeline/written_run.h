// What the programs here that write runs share: the files of simulate, as a run of a scene leaves them, with
// particles and rows that are known.
#pragma once

#include <array>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/files.h"
#include "core/types.h"
#include "io/snapshot.h"
#include "io/table.h"
#include "scene/scene.h"

namespace tidewater {

// Without damage, failure time and stress.
inline void add_particle(io::Snapshot& snapshot, const std::array<double, 3>& place,
                         const std::array<double, 3>& velocity, double volume, Material material) {
    for (const double part : place) snapshot.points.push_back(static_cast<float>(part));
    for (const double part : velocity) snapshot.velocity.push_back(static_cast<float>(part));
    snapshot.pressure.push_back(0.0f);
    snapshot.volume.push_back(static_cast<float>(volume));
    snapshot.material.push_back(static_cast<std::uint8_t>(material));
    snapshot.id.push_back(static_cast<std::uint32_t>(snapshot.id.size()));
}

class WrittenRun {
public:
    const Provenance provenance;
    const scene::Scene scene;

    WrittenRun(const std::string& program, const std::filesystem::path& scene_file,
               const std::filesystem::path& run)
        : provenance{program, program_version(), program, "0", 1},
          scene(scene::read_scene(scene_file)),
          folder_(run / "simulate"),
          gauges_(made(folder_) / "gauges.csv", provenance, {"time"}),
          ledger_(
              folder_ / "ledger.csv", provenance,
              {"time", "kinetic", "gravitational", "elastic", "boundary_work", "outflow_energy", "energy"}) {
        write_text(folder_ / "scene.toml", scene::resolved_text(scene));
    }

    io::TableWriter table(const char* name, std::vector<std::string> columns) const {
        return io::TableWriter(folder_ / name, provenance, std::move(columns));
    }

    // Energies in J.
    void add_frame(const io::Snapshot& frame, double kinetic, double gravitational, double elastic) {
        io::write_snapshot(folder_ / io::snapshot_name(frames_++), frame, provenance);
        gauges_.append(std::array{frame.time});
        ledger_.append(std::array{frame.time, kinetic, gravitational, elastic, 0.0, 0.0,
                                  kinetic + gravitational + elastic});
    }

    void finish() {
        gauges_.finish();
        ledger_.finish();
    }

private:
    static const std::filesystem::path& made(const std::filesystem::path& folder) {
        make_output_folder(folder);
        return folder;
    }

    std::filesystem::path folder_;
    io::TableWriter gauges_, ledger_;
    std::size_t frames_ = 0;
};

// The main function of a program whose arguments are SCENE RUN and what `usage` names besides: calls
// write(the run, what comes besides).
template <class Write>
int write_run(const char* program, std::span<char*> arguments, const std::string& usage, const Write& write) {
    try {
        const std::size_t besides = usage.empty() ? 0 : 1;
        if (arguments.size() != 3 + besides) throw std::invalid_argument("needs SCENE RUN " + usage);
        WrittenRun run(program, arguments[1], arguments[2]);
        write(run, besides ? std::string(arguments[3]) : std::string());
        run.finish();
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s: %s\n", program, error.what());
        return 1;
    }
    return 0;
}

}  // namespace tidewater
