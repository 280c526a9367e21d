#include "io/slides.h"

#include <algorithm>

#include "core/files.h"
#include "io/html.h"
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

constexpr const char* page_style =
    R"(body { margin: 0 auto; max-width: 1600px; padding: 12px; background: #fff; color: #262a30;
       font: 16px "DejaVu Sans", Arial, sans-serif; }
)";

constexpr const char* style = R"(#slides img { display: none; width: 100%; height: auto; }
#slides img.shown { display: block; }
#controls { display: flex; gap: 14px; align-items: center; }
#slider { flex: 1; }
#time { min-width: 7em; text-align: right; font-variant-numeric: tabular-nums; }
#play { font: inherit; min-width: 5.5em; padding: 4px 10px; }
)";

constexpr const char* script = R"(<script>
const images = document.querySelectorAll("#slides img"), slider = document.getElementById("slider");
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
// On a page with more than the slides, keys count only where they have the focus.
const keys = document.querySelector("main") ? document.getElementById("slides") : document;
keys.addEventListener("keydown", (event) => {
  if (event.target.closest("input, button, a, summary")) return;
  if (event.key === " ") { event.preventDefault(); play.click(); }
  const step = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
  if (step) { stop(); show(Math.min(Math.max(Number(slider.value) + step, 0), images.length - 1)); }
});
if (images.length) show(0);
</script>
)";

}  // namespace

std::string slides_style() { return style; }

std::string slides_script() { return script; }

std::string slides_markup(const std::string& title, const std::vector<Slide>& slides) {
    const std::string name = escape_xml(title);
    const std::size_t last = slides.empty() ? 0 : slides.size() - 1;
    std::string text =
        "<div id=\"slides\">\n<div id=\"controls\">\n<button id=\"play\" type=\"button\" data-interval=\"" +
        format_fixed(interval(slides), 0) +
        "\">Play</button>\n<input id=\"slider\" type=\"range\" min=\"0\" max=\"" + std::to_string(last) +
        "\" value=\"0\" aria-label=\"time\">\n<output id=\"time\"></output>\n</div>\n";
    for (const Slide& slide : slides) {
        const std::string seconds = format_fixed(slide.time, 2);
        text += std::string("<img ") + (&slide == slides.data() ? "class=\"shown\" " : "") + "alt=\"" + name +
                ", t = " + seconds + " s\" data-time=\"" + seconds + "\" src=\"data:image/png;base64," +
                encode_base64(read_text(slide.picture)) + "\">\n";
    }
    return text + "</div>\n";
}

void write_slides(const std::filesystem::path& path, const std::string& title,
                  const std::vector<Slide>& slides, const Provenance& provenance) {
    write_text(path, "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n" +
                         provenance_comment(provenance) + "<title>" + escape_xml(title) +
                         "</title>\n<style>\n" + page_style + style + "</style>\n</head>\n<body>\n" +
                         slides_markup(title, slides) + script + "</body>\n</html>\n");
}

}  // namespace tidewater::io
