// tidewater-lab: the laboratory's three icebergs, their waves and speeds in one picture. See README.md.
#include <cstdio>

#include "cases.h"
#include "common/tool.h"
#include "core/files.h"

namespace tidewater::lab {
namespace {

struct Options {
    std::vector<std::string> runs;
    std::filesystem::path out = ".";
};

// False after --help, which is answered on standard output.
bool parse(int argc, const char* const* argv, Options& options) {
    CLI::App app("Puts the first waves of blocks beside each other and the laboratory: lab.csv and lab.svg.",
                 "tidewater-lab");
    app.add_option(
           "RUN", options.runs,
           "FOLDER or LABEL=FOLDER of runs that postprocess has been through; a label that begins with "
           "GF, BF or CS is compared with that experiment")
        ->required();
    app.add_option("--out", options.out, "folder for the results")->capture_default_str();
    return parse_command_line(app, argc, argv);
}

void run(int argc, const char* const* argv) {
    Options options;
    if (!parse(argc, argv, options)) return;
    std::vector<Case> cases;
    for (const std::string& word : options.runs) cases.push_back(read_case(word));
    const Provenance provenance{"tidewater-lab", program_version(), reproducible_command(argc, argv), "", 0};
    make_output_folder(options.out);
    write_text(options.out / "lab.svg", draw_cases(cases, provenance));
    write_cases(options.out / "lab.csv", cases, provenance);
    std::fputs(describe(cases).c_str(), stdout);
}

}  // namespace
}  // namespace tidewater::lab

int main(int argc, char** argv) {
    return tidewater::run_tool("tidewater-lab", argc, argv, &tidewater::lab::run);
}
