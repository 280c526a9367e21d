#include "common/stage.h"

#include <chrono>
#include <cstdio>
#include <iostream>
#include <new>
#include <sstream>

#include "common/options.h"
#include "core/error.h"
#include "core/files.h"
#include "core/parallel.h"
#include "core/progress.h"

namespace tidewater {
namespace {

using Clock = std::chrono::steady_clock;

struct StageProgram {
    scene::Stage stage;
    std::string name;  // "tidewater-geometry"
    void (*work)(StageContext& context);
};

// Each line of text on standard error, after the program's name.
void say(const StageProgram& program, const std::string& text) {
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        std::fprintf(stderr, "%s: %s\n", program.name.c_str(), line.c_str());
    }
}

scene::Scene read(const StageOptions& options) {
    std::vector<scene::Override> overrides;
    for (const std::string& text : options.set) overrides.push_back(scene::parse_override(text));
    return scene::read_scene(options.scene, overrides);
}

// Answers --print-scene, --print-part and --check. False if the stage is to run.
bool only_look(const StageOptions& options, const scene::Scene& scene) {
    if (options.print_scene) {
        std::cout << scene::resolved_text(scene);
    } else if (options.print_part) {
        std::cout << scene::stage_part(scene, *options.print_part);
    } else if (options.check) {
        std::cout << options.scene.string() << ": the scene is in order\n";
    }
    return options.print_scene || options.print_part || options.check;
}

// What was printed is a result too, for whoever redirects it into a file.
void finish_printing() {
    std::cout.flush();
    if (!std::cout || std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
        throw OutputError("standard output: writing failed; is the disk full?");
    }
}

void run(const StageProgram& program, const StageOptions& options, const scene::Scene& scene,
         const std::string& command) {
    const auto start = Clock::now();
    StageContext context{.scene = scene,
                         .run = options.run,
                         .folder = options.run / scene::stage_name(program.stage),
                         .provenance = {.program = program.name,
                                        .version = program_version(),
                                        .command = command,
                                        .scene_hash = scene::scene_hash(scene, program.stage),
                                        .seed = scene.seed},
                         .scene_file = options.scene,
                         .particles = options.particles,
                         .from = options.from,
                         .until = options.until,
                         .movie = options.movie};
    say(program, "writing " + context.folder.string());
    make_output_folder(context.folder);
    const FolderLock lock(context.folder);
    const ThreadLimit limit(options.threads);
    program.work(context);
    const std::chrono::duration<double> elapsed = Clock::now() - start;
    say(program, "took " + format_duration(elapsed.count()));
}

void read_and_run(const StageProgram& program, int argc, const char* const* argv,
                  std::string_view description) {
    const auto options = parse_options(argc, argv, program.stage, description);
    if (!options) return finish_printing();
    const scene::Scene scene = read(*options);
    if (!options->print_part) {
        for (const std::string& warning : scene::scene_warnings(scene)) say(program, "warning: " + warning);
    }
    if (only_look(*options, scene)) return finish_printing();
    run(program, *options, scene, reproducible_command(argc, argv));
}

int exit_code(ExitCode code) { return static_cast<int>(code); }

}  // namespace

void write_resolved_scene(const StageContext& context) {
    std::string text;
    for (const auto& [name, value] : provenance_fields(context.provenance)) {
        if (name == "program" || name == "version" || name == "command")
            text += "# " + name + ": " + value + "\n";
    }
    write_text(context.folder / "scene.toml", text + "\n" + scene::resolved_text(context.scene));
}

std::string first_difference(const std::string& there, const std::string& here) {
    if (there == here) return {};
    std::istringstream their_lines(there), our_lines(here);
    std::string their, our;
    while (their == our) {
        their = our = "nothing";
        std::getline(their_lines, their);
        std::getline(our_lines, our);
    }
    return their + " there, " + our + " here";
}

int run_stage(int argc, const char* const* argv, scene::Stage stage, std::string_view description,
              void (*work)(StageContext& context)) {
    constexpr int unexpected = 1;
    const StageProgram program{stage, "tidewater-" + std::string(scene::stage_name(stage)), work};
    try {
        read_and_run(program, argc, argv, description);
        return exit_code(ExitCode::ok);
    } catch (const Error& error) {
        say(program, error.what());
        return exit_code(error.code());
    } catch (const std::bad_alloc&) {
        say(program, "out of memory; a larger domain.cell_size needs less");
    } catch (const std::exception& error) {
        say(program, std::string("unexpected error, please report it: ") + error.what());
    }
    return unexpected;
}

}  // namespace tidewater
