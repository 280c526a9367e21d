// tidewater-validate-water: the water's validation scenes against their references. See README.md.
#include <cstdio>

#include "common/tool.h"
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
    return parse_command_line(app, argc, argv);
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
    return tidewater::run_tool("tidewater-validate-water", argc, argv, &tidewater::validation::run);
}
