#include "common/options.h"

#include <CLI/CLI.hpp>
#include <iostream>

#include "core/error.h"
#include "core/provenance.h"

namespace tidewater {
namespace {

void declare(CLI::App& app, StageOptions& options, std::string& part) {
    app.set_version_flag("--version", app.get_name() + " " + program_version());
    app.add_flag_callback(
        "--help-scene",
        [] {
            std::cout << scene::key_reference();
            throw CLI::Success{};
        },
        "print the reference of all keys of a scene and exit");
    app.add_option("scene", options.scene, "the scene file")->required()->type_name("SCENE");
    app.add_option("--run", options.run, "folder of the results; default runs/<name of the scene file>")
        ->type_name("FOLDER");
    app.add_option("--set", options.set, "a key of the scene, instead of the file's value; repeatable")
        ->type_name("KEY=VALUE")
        ->allow_extra_args(false);
    app.add_option("--threads", options.threads, "threads to use; 0: all cores; no effect on results")
        ->check(CLI::Range(0, 1024))
        ->type_name("N");
    app.add_flag("--check", options.check, "only check the scene");
    app.add_flag("--print-scene", options.print_scene, "only print the scene with every key resolved");
    app.add_option("--print-part", part, "only print what a stage reads of the scene")
        ->check(CLI::IsMember({"geometry", "simulate", "postprocess"}))
        ->type_name("STAGE");
}

void declare_particles(CLI::App& app, ParticleOptions& particles, std::vector<std::string>& map,
                       std::vector<std::string>& materials) {
    app.add_option(
           "--particles", particles.files,
           "frames of another program instead of simulate's: .vtp, .vtu, legacy .vtk, VTKHDF, or a .pvd or "
           ".series that names them")
        ->type_name("FILE...");
    app.add_option(
           "--map", map,
           "which of their arrays are which columns: velocity=vel or velocity=u:v:w, damage=state[2], "
           "volume=0.25; repeatable")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->type_name("COLUMN=ARRAY,...");
    app.add_option("--materials", materials, "which of their numbers are which materials: water=3,ice=1")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->type_name("MATERIAL=NUMBER,...");
    app.add_option("--up", particles.up, "which of their axes is up; default z")
        ->check(CLI::IsMember({"y", "z"}))
        ->type_name("y|z");
    app.add_option("--origin", particles.origin, "where in their axes the scene's origin is, m")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->type_name("X,Y,Z");
    app.add_option("--times", particles.times, "the time of each file, s, where the files tell none")
        ->delimiter(',')
        ->type_name("T,...");
}

std::string join(const std::vector<std::string>& entries) {
    std::string text;
    for (const std::string& entry : entries) text += (text.empty() ? "" : ",") + entry;
    return text;
}

void declare_restart(CLI::App& app, StageOptions& options) {
    app.add_option("--from", options.from,
                   "\"start\": from the start, whatever an unfinished run left; else a checkpoint of this "
                   "scene to go on from; default: <run>/simulate/checkpoint.h5 where a run was stopped")
        ->type_name("start|CHECKPOINT");
    app.add_option("--until", options.until,
                   "stop after the first row or frame at or after this simulated time, s, with a checkpoint")
        ->check(CLI::NonNegativeNumber)
        ->type_name("TIME");
}

void declare_movie(CLI::App& app, StageOptions& options) {
    app.add_flag("--movie", options.movie,
                 "make frames.mp4 of the pictures too, with ffmpeg where it is there");
}

}  // namespace

std::optional<StageOptions> parse_options(int argc, const char* const* argv, scene::Stage stage,
                                          std::string_view description) {
    CLI::App app(std::string(description), std::filesystem::path(argv[0]).filename().string());
    StageOptions options;
    std::string part;
    std::vector<std::string> map, materials;
    declare(app, options, part);
    if (stage == scene::Stage::simulate) declare_restart(app, options);
    if (stage == scene::Stage::postprocess) {
        declare_movie(app, options);
        declare_particles(app, options.particles, map, materials);
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& answered) {
        app.exit(answered);
        return std::nullopt;
    } catch (const CLI::ParseError& error) {
        throw SceneError(std::string(error.what()) + "; --help lists the options");
    }
    if (options.run.empty()) options.run = std::filesystem::path("runs") / options.scene.stem();
    options.particles.map = join(map);
    options.particles.materials = join(materials);
    options.print_part = scene::stage_named(part);
    return options;
}

}  // namespace tidewater
