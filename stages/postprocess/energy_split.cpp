#include "energy_split.h"

#include <algorithm>
#include <array>

namespace tidewater::postprocess {
namespace {

// Linear between the times, which rise; as at the nearest end beyond them.
double value_at(const std::vector<double>& time, const std::vector<double>& value, double at) {
    const auto after = std::ranges::upper_bound(time, at);
    if (after == time.begin()) return value.front();
    const auto i = static_cast<std::size_t>(after - time.begin());
    if (after == time.end()) return value.back();
    return value[i - 1] + (value[i] - value[i - 1]) * (at - time[i - 1]) / (time[i] - time[i - 1]);
}

}  // namespace

double EnergySplit::greatest_rise() const {
    return lost.empty() ? 0.0 : std::max(0.0, -std::ranges::min(lost));
}

EnergySplit split_energy(const io::Table& ledger, const std::filesystem::path& path,
                         const std::vector<Body>& bodies) {
    const auto column = [&](const char* name) -> const std::vector<double>& {
        return io::require_column(ledger, name, path);
    };
    const auto &time = column("time"), &kinetic = column("kinetic"), &gravitational = column("gravitational"),
               &elastic = column("elastic"), &work = column("boundary_work"),
               &outflow = column("outflow_energy"), &energy = column("energy");
    // Runs of before friction and drag were booked have neither column.
    const std::vector<double>*friction = ledger.find("friction_work"), *drag = ledger.find("drag_work");
    EnergySplit split{.time = time, .block = {}, .water = {}, .lost = {}, .brought = {}};
    for (std::size_t r = 0; r < time.size(); ++r) {
        double blocks = 0.0;
        for (const Body& body : bodies)
            blocks += value_at(body.time, body.energy, time[r]) - body.energy.front();
        const auto change = [&](const std::vector<double>& values) { return values[r] - values.front(); };
        split.block.push_back(blocks);
        split.water.push_back(change(kinetic) + change(gravitational) + change(elastic) - blocks);
        split.lost.push_back(-change(energy));
        double brought = change(work) - change(outflow);
        for (const auto* slowed : {friction, drag}) {
            if (slowed != nullptr) brought += change(*slowed);
        }
        split.brought.push_back(brought);
    }
    return split;
}

void write_energy_split(const std::filesystem::path& path, const EnergySplit& split,
                        const Provenance& provenance) {
    io::TableWriter table(path, provenance, {"time", "block", "water", "lost", "brought"});
    for (std::size_t r = 0; r < split.time.size(); ++r) {
        table.append(
            std::array{split.time[r], split.block[r], split.water[r], split.lost[r], split.brought[r]});
    }
    table.finish();
}

}  // namespace tidewater::postprocess
