#include "waves_3d.h"

#include <string>
#include <vector>

#include "io/table.h"
#include "io/text.h"

namespace tidewater::postprocess {

void write_waves_3d(const std::filesystem::path& path, const analysis::Slide& slide,
                    const analysis::ImpulseProduct& impulse, double greatest,
                    const std::function<double(double)>& here, const Provenance& provenance) {
    io::TableWriter table(
        path, provenance,
        {"distance_ratio", "factor", "amplitude_2d", "amplitude_3d_low", "amplitude_3d", "amplitude_3d_high",
         "amplitude_2d_here", "amplitude_3d_of_here", "impulse_height", "impulse_range"});
    for (const double ratio : analysis::laboratory_distances) {
        const double factor = analysis::radial_factor(slide, ratio), middle = factor * greatest;
        const double local = here(ratio * slide.depth);
        std::vector<std::string> cells;
        for (const double value :
             {ratio, factor, greatest, (1.0 - analysis::radial_scatter) * middle, middle,
              (1.0 + analysis::radial_scatter) * middle, local, factor * local, impulse.height(ratio)})
            cells.push_back(io::format_number(value));
        cells.push_back(impulse.is_valid() ? "validated" : outside_range);
        table.append_cells(cells);
    }
    table.finish();
}

}  // namespace tidewater::postprocess
