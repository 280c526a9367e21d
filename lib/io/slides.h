// A page that shows a run's pictures one after the other: a slider, a play button and the time. The pictures
// are in the page itself, which opens without a network or other files.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/provenance.h"

namespace tidewater::io {

struct Slide {
    double time = 0.0;              // s
    std::filesystem::path picture;  // PNG
};

// What shows the slides within a page: their style, for its head; the controls and pictures, of which the
// first is shown where there is no JavaScript; and the script, to stand behind them. One page holds them
// once. slides_markup throws InputError if a picture cannot be read.
std::string slides_style();
std::string slides_markup(const std::string& title, const std::vector<Slide>& slides);
std::string slides_script();

// Replaces path as a whole by HTML with the provenance in a comment. Played, it takes as long as the time
// from the first slide to the last, but at least 2 s and at most 0.5 s a slide. The title may be any UTF-8.
// Throws InputError if a picture cannot be read, OutputError.
void write_slides(const std::filesystem::path& path, const std::string& title,
                  const std::vector<Slide>& slides, const Provenance& provenance);

}  // namespace tidewater::io
