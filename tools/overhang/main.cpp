// tidewater-overhang: the first icebergs of several runs against beam theory. See README.md.
#include "cases.h"
#include "common/tool.h"
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
    return parse_command_line(app, argc, argv);
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
    return tidewater::run_tool("tidewater-overhang", argc, argv, &tidewater::overhang::run);
}
