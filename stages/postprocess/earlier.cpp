#include "earlier.h"

#include <regex>
#include <string>
#include <system_error>
#include <vector>

#include "common/stage.h"
#include "core/error.h"

namespace tidewater::postprocess {
namespace {

void require_removal(const std::filesystem::path& path, const std::error_code& error) {
    if (error) {
        throw OutputError(path.string() + ": cannot be removed: " + error.message() +
                          "; remove it or choose another folder with --run");
    }
}

}  // namespace

void require_same_scene(const std::filesystem::path& simulated, const scene::Scene& scene) {
    const auto path = simulated / "scene.toml";
    if (!std::filesystem::exists(path))
        throw InputError(path.string() + ": the file does not exist; run tidewater-simulate again");
    constexpr auto stage = scene::Stage::simulate;
    const std::string difference =
        first_difference(stage_part(scene::read_scene(path), stage), stage_part(scene, stage));
    if (difference.empty()) return;
    throw InputError(path.string() + ": simulated with other settings (" + difference + "); pass " +
                     path.string() + " as the scene or run tidewater-simulate again");
}

void remove_earlier_results(const std::filesystem::path& folder) {
    static const std::regex ours(
        // Of each product its stem and the forms that it is written in.
        R"(((particles|water_surface|iceberg_surfaces)\.pvd|view\.py|(frames|report)\.html|frames\.mp4|)"
        R"((gauges|gauges_snapshots|space_time)\.nc|)"
        R"((gauges|celerity|energy|bodies|energy_split|first_wave|spectra|decay|space_time|run_up|sizes|calving)\.)"
        R"((svg|png)|)"
        R"((gauges|waves|first_wave|long_waves|waves_3d|tsunami|energy_split|spectra|decay|decay_fit|run_up|fragments|)"
        R"(icebergs|iceberg_summary|iceberg_events|calving|calving_wave|sizes|size_histogram|size_fits)\.csv)(\.part)?)");
    std::error_code error;
    std::vector<std::filesystem::path> found{folder / "report.html"};
    std::filesystem::directory_iterator entry(folder, error);
    for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
        const auto& path = entry->path();
        if (std::regex_match(path.filename().string(), ours)) found.push_back(path);
    }
    require_removal(folder, error);
    for (const auto& path : found) {
        std::filesystem::remove(path, error);
        require_removal(path, error);
    }
}

}  // namespace tidewater::postprocess
