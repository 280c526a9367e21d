// The skeleton that every stage's main is: command line, scene, folder, provenance, errors and exit codes.
//
//     int main(int argc, char** argv) {
//         return tidewater::run_stage(argc, argv, scene::Stage::geometry, "writes the level sets",
//         &write_level_sets);
//     }
//
//     tidewater-<stage> SCENE [--set KEY=VALUE]... [--run FOLDER] [--threads N]    runs the stage
//     tidewater-<stage> SCENE --check | --print-scene | --print-part STAGE         only looks at the scene
//     tidewater-<stage> --help | --help-scene | --version
//     tidewater-postprocess SCENE [--particles FILE... [--map COLUMN=ARRAY,...]]
//     tidewater-simulate SCENE [--from start|CHECKPOINT] [--until TIME]
//     tidewater-postprocess SCENE [--movie]
//
// A line on standard error for each problem, "tidewater-<stage>: <what, where, and what to do>", and the exit
// code of core/error.h; 128 + the signal for a simulate that was stopped by one. Command-line misuse counts
// as a scene error (2); what is no Error of ours ends with 1. Test: tests/pipeline/command_line_test.sh
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "common/options.h"
#include "core/provenance.h"
#include "scene/scene.h"

namespace tidewater {

struct StageContext {
    scene::Scene scene;
    std::filesystem::path run;     // the folder of all stages' results
    std::filesystem::path folder;  // run/<stage>; exists and can be written to
    Provenance provenance;
    std::filesystem::path scene_file;  // as the command line names it

    ParticleOptions particles;  // postprocess's options

    std::string from;    // simulate's options; see StageOptions
    double until = 0.0;  // s
    bool movie = false;  // postprocess' option
};

// The level sets that the geometry stage left for the others.
inline std::filesystem::path geometry_file(const StageContext& context) {
    return context.run / "geometry" / "geometry.vdb";
}

// Writes context.folder/scene.toml: the resolved scene after comments with program, version and command.
// Every stage's work calls it once it has read its inputs and removed the results of an earlier run, before
// it writes its own, so that no results lie beside another run's scene.
void write_resolved_scene(const StageContext& context);

// What two parts of scenes, as stage_part gives them, first differ in: "block.angle = 5 there, block.angle =
// 0 here"; empty if in nothing.
std::string first_difference(const std::string& there, const std::string& here);

// Runs `work` between creating context.folder and saying how long it took. Returns the exit code for main.
int run_stage(int argc, const char* const* argv, scene::Stage stage, std::string_view description,
              void (*work)(StageContext& context));

}  // namespace tidewater
