// How large icebergs are: exceedance, histogram and fitted models (analysis/size_distribution.h) beside
// published exponents.
#pragma once

#include <string>
#include <vector>

#include "analysis/size_distribution.h"
#include "common/stage.h"
#include "iceberg_tables.h"

namespace tidewater::postprocess {

// A published exponent a of n(s) ∝ s^−a, or from one to another.
struct PublishedExponent {
    std::string source;
    double low = 0.0, high = 0.0;
};

struct SizeSet {
    std::string
        name;  // "last": the last frame's; "calved": all that came off, as they were then; "last_area"
    std::string title;  // for people
    std::string unit;   // "m³"
    std::vector<double> sizes;
    std::vector<PublishedExponent> published;
    analysis::SizeDistribution fits;
};

// Volumes of the icebergs in the last frame and of all that came off the glacier, each as it was when it did;
// in 3D also areas in plan in the last frame.
std::vector<SizeSet> find_sizes(const IcebergTables& tables, const scene::Scene& scene);

// sizes.csv, size_histogram.csv and size_fits.csv.
void write_sizes(const StageContext& context, const std::vector<SizeSet>& sets);

// sizes.svg, calving.svg
std::string size_chart(const std::vector<SizeSet>& sets, const StageContext& context);
std::string calving_chart(const CalvingSeries& calving, const StageContext& context);

// The lines that the stage prints for people.
std::string describe(const std::vector<SizeSet>& sets);

}  // namespace tidewater::postprocess
