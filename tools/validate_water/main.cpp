// tidewater-validate-water: the water's validation scenes against their references. See README.md.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <exception>

#include "core/error.h"
#include "core/files.h"
#include "report.h"

namespace tidewater::validation {
namespace {

struct Options {
    std::vector<std::filesystem::path> runs;
    std::filesystem::path out = ".";
    std::filesystem::path data = "tests/validation/data";
};

// False after --help, which is answered on standard output.
bool parse(int argc, const char* const* argv, Options& options) {
    CLI::App app(
        "Compares runs of configs/validation with closed forms and measurements: validation.csv and charts.",
        "tidewater-validate-water");
    app.add_option("RUN", options.runs, "folders of runs that simulate has been through")->required();
    app.add_option("--out", options.out, "folder for the results")->capture_default_str();
    app.add_option("--data", options.data, "folder of the published series")->capture_default_str();
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
    std::vector<Run> runs;
    for (const auto& folder : options.runs) runs.push_back(open_run(folder));
    const std::vector<Report> reports = report_all(runs, options.data);
    const Provenance provenance{"tidewater-validate-water", program_version(),
                                reproducible_command(argc, argv), "", 0};
    make_output_folder(options.out);
    for (const Report& report : reports)
        write_text(options.out / (report.name + ".svg"), io::draw_chart(report.chart, provenance));
    write_findings(options.out / "validation.csv", reports, provenance);
    std::fputs(describe(reports).c_str(), stdout);
}

}  // namespace
}  // namespace tidewater::validation

int main(int argc, char** argv) {
    try {
        tidewater::validation::run(argc, argv);
        return 0;
    } catch (const tidewater::Error& error) {
        std::fprintf(stderr, "tidewater-validate-water: %s\n", error.what());
        return static_cast<int>(error.code());
    } catch (const std::exception& error) {
        std::fprintf(stderr, "tidewater-validate-water: %s\n", error.what());
        return 1;
    }
}
