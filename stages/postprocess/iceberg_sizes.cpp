#include "iceberg_sizes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "io/table.h"
#include "io/text.h"

namespace tidewater::postprocess {
namespace {

constexpr int bins_per_decade = 4;

std::vector<double> last_sizes(const IcebergTables& tables, double IcebergRow::*size) {
    std::vector<double> sizes;
    if (tables.calving.time.empty()) return sizes;
    for (const IcebergRow& row : tables.rows) {
        if (row.time == tables.calving.time.back()) sizes.push_back(row.*size);
    }
    return sizes;
}

std::vector<double> calved_sizes(const IcebergTables& tables) {
    std::vector<double> sizes;
    for (const IcebergStory& story : tables.stories) {
        if (story.calved) sizes.push_back(tables.rows[story.first_row].volume);
    }
    return sizes;
}

std::string number(double value) { return io::format_number(value); }

struct ModelRow {
    const char* name;
    const analysis::SizeFit& fit;
    const analysis::LikelihoodRatio& ratio;
    const char* against;
};

std::array<ModelRow, 3> models(const analysis::SizeDistribution& d) {
    return {ModelRow{"power_law", d.power_law, d.power_over_exponential, "exponential"},
            ModelRow{"truncated_power_law", d.truncated, d.truncated_over_power, "power_law"},
            ModelRow{"exponential", d.exponential, d.truncated_over_exponential, "truncated_power_law"}};
}

void write_fits(const std::filesystem::path& path, const std::vector<SizeSet>& sets,
                const Provenance& provenance) {
    io::TableWriter table(path, provenance,
                          {"set",
                           "model",
                           "sizes",
                           "smallest",
                           "fitted",
                           "decades",
                           "exponent",
                           "exponent_low",
                           "exponent_high",
                           "cutoff",
                           "cutoff_low",
                           "cutoff_high",
                           "log_likelihood",
                           "distance",
                           "p",
                           "against",
                           "likelihood_ratio",
                           "ratio_p",
                           "published_low",
                           "published_high",
                           "doubt"});
    for (const SizeSet& set : sets) {
        const analysis::SizeDistribution& d = set.fits;
        double low = analysis::none, high = analysis::none;
        for (const PublishedExponent& published : set.published) {
            low = published.low;
            high = published.high;
        }
        std::string doubt = d.doubt;
        std::ranges::replace(doubt, ',', ';');
        for (const ModelRow& m : models(d)) {
            // The ratio of the exponential's row is that of the truncated law over it: turned round here.
            const double sign = std::string_view(m.name) == "exponential" ? -1.0 : 1.0;
            std::vector<std::string> cells{set.name, m.name, std::to_string(set.sizes.size())};
            for (const double value : {d.smallest, static_cast<double>(d.count), d.decades, m.fit.exponent,
                                       m.fit.exponent_interval.low, m.fit.exponent_interval.high,
                                       m.fit.cutoff, m.fit.cutoff_interval.low, m.fit.cutoff_interval.high,
                                       m.fit.log_likelihood, m.fit.distance, m.fit.p})
                cells.push_back(number(value));
            cells.push_back(m.against);
            for (const double value : {sign * m.ratio.ratio, m.ratio.p, low, high})
                cells.push_back(number(value));
            cells.push_back(doubt);
            table.append_cells(cells);
        }
    }
    table.finish();
}

}  // namespace

std::vector<SizeSet> find_sizes(const IcebergTables& tables, const scene::Scene& scene) {
    const bool deep = scene.dimension == 3;
    const double a = deep ? analysis::fragment_exponent_3d : analysis::fragment_exponent_2d;
    const std::string unit = deep ? "m³" : "m²";
    const std::vector<PublishedExponent> brittle{{"brittle fragments", a, a}};
    std::vector<SizeSet> sets{
        {"last", "icebergs of the last frame", unit, last_sizes(tables, &IcebergRow::volume), brittle, {}},
        {"calved", "all that came off, as they were then", unit, calved_sizes(tables), brittle, {}}};
    if (deep) {
        sets.push_back({"last_area",
                        "their areas in plan, last frame",
                        "m²",
                        last_sizes(tables, &IcebergRow::area),
                        {{"icebergs (Sulak 2017)", analysis::iceberg_area_exponent_low,
                          analysis::iceberg_area_exponent_high}},
                        {}});
    }
    for (SizeSet& set : sets) set.fits = analysis::fit_sizes(set.sizes, {.seed = scene.seed});
    return sets;
}

void write_sizes(const StageContext& context, const std::vector<SizeSet>& sets) {
    io::TableWriter sizes(context.folder / "sizes.csv", context.provenance, {"set", "size", "count"});
    io::TableWriter histogram(context.folder / "size_histogram.csv", context.provenance,
                              {"set", "low", "high", "count", "density"});
    for (const SizeSet& set : sets) {
        for (const auto& e : analysis::exceedance(set.sizes))
            sizes.append_cells(std::array{set.name, number(e.size), std::to_string(e.count)});
        for (const auto& bin : analysis::logarithmic_histogram(set.sizes, bins_per_decade)) {
            histogram.append_cells(std::array{set.name, number(bin.low), number(bin.high),
                                              std::to_string(bin.count), number(bin.density)});
        }
    }
    sizes.finish();
    histogram.finish();
    write_fits(context.folder / "size_fits.csv", sets, context.provenance);
}

std::string describe(const std::vector<SizeSet>& sets) {
    std::string text;
    for (const SizeSet& set : sets) {
        const analysis::SizeFit& fit = set.fits.truncated;
        text += "sizes, " + set.title + ": " + std::to_string(set.sizes.size());
        if (!std::isnan(fit.exponent)) {
            text += "; exponent " + io::format_fixed(fit.exponent, 2) + " (" +
                    io::format_fixed(fit.exponent_interval.low, 2) + " to " +
                    io::format_fixed(fit.exponent_interval.high, 2) + ") with a cut-off";
        }
        text += set.fits.trustworthy() ? "\n" : "; not to be trusted: " + set.fits.doubt + "\n";
    }
    return text;
}

}  // namespace tidewater::postprocess
