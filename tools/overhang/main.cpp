// tidewater-overhang: the first icebergs of several runs against beam theory. See README.md.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "cases.h"
#include "core/error.h"
#include "core/files.h"

namespace tidewater::overhang {
namespace {

struct Options {
    std::vector<std::filesystem::path> runs;
    std::filesystem::path out = ".";
};

// False after --help, which is answered on standard output.
bool parse(int argc, const char* const* argv, Options& options) {
    CLI::App app("Compares the first icebergs of runs with beam theory: overhang.csv and overhang.svg.",
                 "tidewater-overhang");
    app.add_option("RUN", options.runs, "folders of runs that postprocess has been through")->required();
    app.add_option("--out", options.out, "folder for the results")->capture_default_str();
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& answered) {
        app.exit(answered);
        return false;
    } catch (const CLI::ParseError& error) {
        throw SceneError(std::string(error.what()) + "; --help lists the options");
    }
    return true;
}

void run(int argc, const char* const* argv) {
    Options options;
    if (!parse(argc, argv, options)) return;
    std::vector<Case> cases;
    for (const auto& folder : options.runs) cases.push_back(read_case(folder));
    sort_cases(cases);
    const Provenance provenance{"tidewater-overhang", program_version(), reproducible_command(argc, argv), "",
                                0};
    make_output_folder(options.out);
    write_text(options.out / "overhang.svg", draw_cases(cases, provenance));
    write_cases(options.out / "overhang.csv", cases, provenance);
}

}  // namespace
}  // namespace tidewater::overhang

int main(int argc, char** argv) {
    try {
        tidewater::overhang::run(argc, argv);
        return 0;
    } catch (const tidewater::Error& error) {
        std::fprintf(stderr, "tidewater-overhang: %s\n", error.what());
        return static_cast<int>(error.code());
    } catch (const std::exception& error) {
        std::fprintf(stderr, "tidewater-overhang: %s\n", error.what());
        return 1;
    }
}
