// tidewater-point: one point of ice along a path of strain, for calibration. See README.md.
#include <iostream>

#include "common/tool.h"
#include "core/error.h"
#include "core/files.h"
#include "options.h"
#include "outputs.h"

namespace tidewater::point {
namespace {

template <int D, class Real>
std::vector<mpm::PointRow> drive(const Options& options) {
    mpm::IcePoint<D, Real> point = mpm::intact_point<D, Real>(options.ice);
    if (options.failed) point.alpha = 0;
    return mpm::drive_point<D, Real>(options.ice, options.loading, point);
}

std::vector<mpm::PointRow> drive(const Options& options) {
    if (options.dimension == 2)
        return options.single_precision ? drive<2, float>(options) : drive<2, double>(options);
    return options.single_precision ? drive<3, float>(options) : drive<3, double>(options);
}

std::filesystem::path with_ending(std::filesystem::path prefix, const char* ending) {
    return prefix += ending;
}

void run(int argc, const char* const* argv) {
    const std::optional<Options> options = parse_options(argc, argv);
    if (options) {
        const Provenance provenance{.program = "tidewater-point",
                                    .version = program_version(),
                                    .command = reproducible_command(argc, argv),
                                    .scene_hash = {}};
        const std::vector<mpm::PointRow> rows = drive(*options);
        write_csv(with_ending(options->out, ".csv"), rows, provenance);
        write_text(with_ending(options->out, ".svg"), draw_path(*options, rows, provenance));
        std::cout << summary(*options, rows);
    }
    std::cout.flush();
    if (!std::cout) throw OutputError("standard output: writing failed; is the disk full?");
}

}  // namespace
}  // namespace tidewater::point

int main(int argc, char** argv) {
    return tidewater::run_tool("tidewater-point", argc, argv, &tidewater::point::run);
}
