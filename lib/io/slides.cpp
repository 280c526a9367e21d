#include "io/slides.h"

#include <algorithm>
#include <fstream>

#include "core/error.h"
#include "core/files.h"
#include "io/text.h"

namespace tidewater::io {
namespace {

constexpr double shortest = 2000.0, longest_slide = 500.0;  // ms

// Between slides, ms.
double interval(const std::vector<Slide>& slides) {
    if (slides.size() < 2) return longest_slide;
    const double duration = 1000.0 * (slides.back().time - slides.front().time);
    return std::min(std::max(duration, shortest) / static_cast<double>(slides.size() - 1), longest_slide);
}

// "--" would end a comment.
std::string comment(const Provenance& provenance) {
    std::string text = "<!--\n";
    for (const auto& [name, value] : provenance_fields(provenance)) {
        std::string line = name + ": " + escape_xml(value);
        for (auto at = line.find("--"); at != line.npos; at = line.find("--", at)) line.replace(at, 2, "- -");
        text += line + "\n";
    }
    return text + "-->\n";
}

constexpr const char* style = R"(<style>
body { margin: 0 auto; max-width: 1600px; padding: 12px; background: #fff; color: #262a30;
       font: 16px "DejaVu Sans", Arial, sans-serif; }
img { display: none; width: 100%; height: auto; }
img.shown { display: block; }
#controls { display: flex; gap: 14px; align-items: center; }
#slider { flex: 1; }
#time { min-width: 7em; text-align: right; font-variant-numeric: tabular-nums; }
button { font: inherit; min-width: 5.5em; padding: 4px 10px; }
</style>
)";

constexpr const char* script = R"(<script>
const images = document.querySelectorAll("img"), slider = document.getElementById("slider");
const time = document.getElementById("time"), play = document.getElementById("play");
let timer = null;
function show(index) {
  images.forEach((image, i) => image.classList.toggle("shown", i === index));
  slider.value = index;
  time.textContent = "t = " + images[index].dataset.time + " s";
}
function stop() {
  clearInterval(timer);
  timer = null;
  play.textContent = "Play";
}
function start() {
  if (Number(slider.value) === images.length - 1) show(0);
  play.textContent = "Pause";
  timer = setInterval(() => {
    const next = Number(slider.value) + 1;
    if (next < images.length) show(next); else stop();
  }, Number(play.dataset.interval));
}
play.addEventListener("click", () => timer === null ? start() : stop());
slider.addEventListener("input", () => { stop(); show(Number(slider.value)); });
document.addEventListener("keydown", (event) => {
  if (event.target === slider || event.target === play) return;
  if (event.key === " ") { event.preventDefault(); play.click(); }
  const step = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
  if (step) { stop(); show(Math.min(Math.max(Number(slider.value) + step, 0), images.length - 1)); }
});
if (images.length) show(0);
</script>
)";

}  // namespace

void write_slides(const std::filesystem::path& path, const std::string& title,
                  const std::vector<Slide>& slides, const Provenance& provenance) {
    PartFile part(path);
    std::ofstream page(part.part_path(), std::ios::binary);
    const std::string name = escape_xml(title);
    const std::size_t last = slides.empty() ? 0 : slides.size() - 1;
    page << "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
         << comment(provenance) << "<title>" << name << "</title>\n"
         << style
         << "</head>\n<body>\n<div id=\"controls\">\n<button id=\"play\" type=\"button\" data-interval=\""
         << format_fixed(interval(slides), 0)
         << "\">Play</button>\n<input id=\"slider\" type=\"range\" min=\"0\" max=\"" << last
         << "\" value=\"0\" aria-label=\"time\">\n<output id=\"time\"></output>\n</div>\n";
    for (const Slide& slide : slides) {
        const std::string seconds = format_fixed(slide.time, 2);
        page << "<img alt=\"" << name << ", t = " << seconds << " s\" data-time=\"" << seconds
             << "\" src=\"data:image/png;base64," << encode_base64(read_text(slide.picture)) << "\">\n";
    }
    page << script << "</body>\n</html>\n";
    page.flush();
    if (!page) throw OutputError(path.string() + ": writing failed; is the disk full?");
    page.close();
    part.commit();
}

}  // namespace tidewater::io
