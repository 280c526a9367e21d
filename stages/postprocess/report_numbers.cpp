#include <algorithm>
#include <cmath>

#include "analysis/beam.h"
#include "analysis/wave.h"
#include "io/cell_table.h"
#include "io/text.h"
#include "quantities.h"
#include "report_parts.h"

namespace tidewater::postprocess {
namespace {

std::string with_unit(double value, const std::string& unit) {
    return short_number(value) + (unit.empty() ? "" : " " + unit);
}

std::string range_text(double low, double high, const std::string& unit) {
    if (low == high) return with_unit(low, unit);
    if (std::isinf(low)) return "at most " + with_unit(high, unit);
    if (std::isinf(high)) return "at least " + with_unit(low, unit);
    return short_number(low) + " to " + with_unit(high, unit);
}

// In 2D volumes are per metre of width.
Quantity of_scene(Quantity quantity, const scene::Scene& scene) {
    if (scene.dimension == 2 && quantity.unit == volume_unit) quantity.unit += " per m of width";
    return quantity;
}

io::KeyNumber compared(const Quantity& quantity, double low, double high, const std::string& source) {
    const bool within = low <= quantity.value && quantity.value <= high;
    const io::Verdict verdict = std::isnan(quantity.value) ? io::Verdict::none
                                : within                   ? io::Verdict::within
                                                           : io::Verdict::outside;
    return {quantity.label, with_unit(quantity.value, quantity.unit), range_text(low, high, quantity.unit),
            source, verdict};
}

// Within 5 % of √(gD).
void add_long_wave(const StageContext& context, std::vector<io::KeyNumber>& numbers) {
    const scene::Scene& scene = context.scene;
    if (!scene.has("water") || scene.domain.gravity <= 0.0) return;
    const double celerity = analysis::long_wave_celerity(scene.water.depth, scene.domain.gravity);
    for (const char* name : {"celerity", "wave_celerity"}) {
        const Quantity quantity = find_quantity(context.folder, name);
        if (std::isnan(quantity.value)) continue;
        numbers.push_back(compared(quantity, 0.95 * celerity, 1.05 * celerity,
                                   "√(gD) = " + short_number(celerity) + " m/s, ±5 %"));
    }
}

// Within 15 % of the paper's eq. 1, of a slab that is pushed off a shelf.
void add_beam(const StageContext& context, std::vector<io::KeyNumber>& numbers) {
    const scene::Scene& scene = context.scene;
    const Quantity ratio = find_quantity(context.folder, "iceberg_length_ratio");
    if (!scene.has("shelf") || !scene.has("push") || std::isnan(ratio.value)) return;
    const double height = scene.ice.size.back();
    const analysis::Overhang overhang{.height = height,
                                      .depth = scene.water.depth - scene.shelf.height,
                                      .ice_density = scene.ice.model.density,
                                      .water_density = scene.water.model.density,
                                      .gravity = scene.domain.gravity};
    const double expected = analysis::paper_length_ratio(overhang, scene.ice.model.beta_p0);
    if (!std::isfinite(expected)) return;
    numbers.push_back(compared(ratio, 0.85 * expected, 1.15 * expected,
                               "Wolper et al. 2021, eq. 1: " + short_number(expected) + ", ±15 %"));
}

// Of each set of icebergs, whether the fitted exponent's interval meets what is published.
void add_sizes(const StageContext& context, std::vector<io::KeyNumber>& numbers) {
    const auto path = context.folder / "size_fits.csv";
    if (!std::filesystem::exists(path)) return;
    const io::CellTable fits = io::read_cells(path);
    for (std::size_t r = 0; r < fits.rows.size(); ++r) {
        const double exponent = fits.number(r, "exponent"), low = fits.number(r, "published_low"),
                     high = fits.number(r, "published_high");
        if (fits.word(r, "model") != "power_law" || std::isnan(exponent) || std::isnan(low)) continue;
        const double least = fits.number(r, "exponent_low"), greatest = fits.number(r, "exponent_high");
        io::KeyNumber number =
            compared({"", "exponent of iceberg sizes, set " + fits.word(r, "set"), "", exponent}, low, high,
                     "published");
        if (!std::isnan(least) && !std::isnan(greatest)) {
            number.value += " (" + short_number(least) + " to " + short_number(greatest) + ")";
            number.verdict = least <= high && low <= greatest ? io::Verdict::within : io::Verdict::outside;
            number.source = "published; within if the 95 % interval meets it";
        }
        numbers.push_back(number);
    }
}

bool is_told(const std::vector<io::KeyNumber>& numbers, const Quantity& quantity) {
    for (const io::KeyNumber& number : numbers) {
        if (number.name == quantity.label) return true;
    }
    return false;
}

}  // namespace

std::string short_number(double value) {
    if (std::isnan(value)) return "-";
    if (std::abs(value) >= 1000.0 && std::abs(value) < 1e6) return io::format_fixed(value, 0);
    return io::format_digits(value, 3);
}

std::vector<io::KeyNumber> report_numbers(const StageContext& context) {
    std::vector<io::KeyNumber> numbers;
    for (const Reference& reference : parse_references(context.scene.postprocess.references)) {
        const Quantity quantity = of_scene(find_quantity(context.folder, reference.quantity), context.scene);
        numbers.push_back(compared(quantity, reference.low, reference.high, reference.source));
    }
    add_long_wave(context, numbers);
    add_beam(context, numbers);
    add_sizes(context, numbers);
    for (const Quantity& quantity : told_quantities(context.folder)) {
        if (is_told(numbers, quantity)) continue;
        numbers.push_back(
            {quantity.label, with_unit(quantity.value, of_scene(quantity, context.scene).unit)});
    }
    return numbers;
}

}  // namespace tidewater::postprocess
