#include "report.h"

#include <algorithm>
#include <regex>

#include "io/text.h"
#include "report_parts.h"

namespace tidewater::postprocess {
namespace {

constexpr std::size_t most_slides = 60;  // about 10 MB

// The pictures that there are, by time, and of many every n-th and the last.
std::vector<io::Slide> find_slides(const std::filesystem::path& folder) {
    static const std::regex picture(R"(frame_t=(\d+\.\d+)\.png)");
    std::vector<io::Slide> all;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        std::smatch match;
        const std::string name = entry.path().filename().string();
        if (std::regex_match(name, match, picture)) all.push_back({std::stod(match[1]), entry.path()});
    }
    std::ranges::sort(all, {}, &io::Slide::time);
    if (all.size() <= most_slides) return all;
    std::vector<io::Slide> some;
    for (std::size_t i = 0; i < most_slides; ++i)
        some.push_back(all[i * (all.size() - 1) / (most_slides - 1)]);
    return some;
}

// "3 of 4 numbers with a reference lie within it."
std::string summary(const io::Report& report) {
    const auto count = [&](io::Verdict verdict) {
        return std::ranges::count(report.numbers, verdict, &io::KeyNumber::verdict);
    };
    const auto within = count(io::Verdict::within), compared = within + count(io::Verdict::outside);
    std::string text;
    if (compared > 0) {
        text = std::to_string(within) + " of " + std::to_string(compared) +
               " numbers with a reference lie within it. ";
    }
    const std::size_t warnings = report.warnings.size();
    if (warnings == 0) return text + "No warnings.";
    return text + std::to_string(warnings) + (warnings == 1 ? " warning." : " warnings.");
}

}  // namespace

void write_run_report(const StageContext& context, const Frames& frames,
                      const std::optional<io::RunFacts>& run) {
    io::Report report{.title = context.scene.title.empty() ? "A run of tidewater" : context.scene.title,
                      .warnings = report_warnings(context, frames, run),
                      .numbers = report_numbers(context),
                      .slides = find_slides(context.folder),
                      .figures = report_figures(context),
                      .tables = report_tables(context),
                      .facts = report_facts(context, frames, run)};
    report.slides_note =
        "Water by speed, ice by damage. frames.html has every picture; particles.pvd opens in ParaView.";
    report.summary = summary(report);
    io::write_report(context.folder / "report.html", report, context.provenance);
}

}  // namespace tidewater::postprocess
