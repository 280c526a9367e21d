// The charts of iceberg_sizes.h.
#include <algorithm>
#include <cmath>

#include "iceberg_sizes.h"
#include "io/chart.h"
#include "io/text.h"

namespace tidewater::postprocess {
namespace {

constexpr int points_per_line = 60;

io::ChartLine counted(const SizeSet& set) {
    io::ChartLine line{.label = "counted", .x = {}, .y = {}, .color = 0, .dots = set.sizes.size() < 300};
    for (const auto& e : analysis::exceedance(set.sizes)) {
        line.x.push_back(e.size);
        line.y.push_back(static_cast<double>(e.count));
    }
    return line;
}

// From the fits' least size to the greatest, on a logarithmic scale; count(s) is what is drawn.
template <class Count>
io::ChartLine curve(const SizeSet& set, const std::string& label, std::size_t color, const Count& count) {
    io::ChartLine line{.label = label, .x = {}, .y = {}, .color = color, .dashed = true};
    for (int i = 0; i <= points_per_line; ++i) {
        const double s = set.fits.smallest * std::pow(10.0, set.fits.decades * i / points_per_line);
        const double n = count(s);
        if (n < 0.5) break;  // below what can be counted
        line.x.push_back(s);
        line.y.push_back(n);
    }
    return line;
}

void add_fits(const SizeSet& set, io::ChartPanel& panel) {
    const analysis::SizeDistribution& d = set.fits;
    const auto all = static_cast<double>(d.count);
    std::size_t color = 1;
    for (const auto& [label, fit] :
         {std::pair{"power law", d.power_law}, std::pair{"with a cut-off", d.truncated},
          std::pair{"exponential", d.exponential}}) {
        panel.lines.push_back(curve(set, label, color++, [&](double s) {
            return all * analysis::modelled_exceedance(fit, d.smallest, s);
        }));
    }
    for (const PublishedExponent& published : set.published) {
        for (const double a : {published.low, published.high}) {
            io::ChartLine line = curve(set, "published slope", 0,
                                       [&](double s) { return all * std::pow(s / d.smallest, 1.0 - a); });
            line.faint = true;
            panel.lines.push_back(line);
            if (published.low == published.high) break;
        }
    }
}

// "a = 1.52 (1.40 to 1.64), published 1.5"
std::string exponent_text(const SizeSet& set) {
    const analysis::SizeFit& fit = set.fits.truncated;
    std::string text;
    if (!std::isnan(fit.exponent)) {
        text = ": a = " + io::format_fixed(fit.exponent, 2) + " (" +
               io::format_fixed(fit.exponent_interval.low, 2) + " to " +
               io::format_fixed(fit.exponent_interval.high, 2) + ") with a cut-off";
        for (const PublishedExponent& published : set.published) {
            text += ", published " + io::format_number(published.low);
            if (published.high != published.low) text += " to " + io::format_number(published.high);
        }
    }
    return text + (set.fits.trustworthy() ? "" : " – not to be trusted: " + set.fits.doubt);
}

}  // namespace

std::string size_chart(const std::vector<SizeSet>& sets, const StageContext& context) {
    io::Chart chart{.title = context.scene.title, .x_label = {}, .panels = {}, .panel_height = 300.0};
    for (const SizeSet& set : sets) {
        io::ChartPanel panel{.title = set.title + exponent_text(set),
                             .y_label = "number of at least s",
                             .lines = {},
                             .marks = {}};
        panel.x_label = "s (" + set.unit + ")";
        panel.log_x = panel.log_y = true;
        panel.lines.push_back(counted(set));
        if (!std::isnan(set.fits.power_law.exponent)) add_fits(set, panel);
        chart.panels.push_back(panel);
    }
    return io::draw_chart(chart, context.provenance);
}

std::string calving_chart(const CalvingSeries& calving, const StageContext& context) {
    const std::string unit = context.scene.dimension == 3 ? "m³" : "m²";
    io::Chart chart{.title = context.scene.title, .x_label = "time (s)", .panels = {}, .panel_height = 150.0};
    const auto panel = [&](const std::string& title, const std::string& label,
                           const std::vector<double>& values) {
        io::ChartPanel& added = chart.panels.emplace_back();
        added.title = title;
        added.y_label = label;
        added.lines.push_back({.label = {}, .x = calving.time, .y = values});
    };
    panel("came off the glacier, less what grew to it again", "volume (" + unit + ")", calving.total);
    panel("calving rate over " + io::format_number(calving.window) + " s", "rate (" + unit + "/s)",
          calving.rate);
    panel("front of the glacier near the waterline", "x (m)", calving.front);
    panel("icebergs", "number", calving.icebergs);
    panel("ice that failed", "volume (" + unit + ")", calving.failed);
    return io::draw_chart(chart, context.provenance);
}

}  // namespace tidewater::postprocess
