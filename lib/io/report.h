// A run's report as one HTML file: key numbers against their references, warnings, pictures behind a slider,
// charts, tables that sort, and what was run. Everything is in the file itself, which opens without a network
// or other files, prints, and can be read without JavaScript.
//
// Test: tests/unit/io/report_test.cpp; in a browser: tests/browser/report_test.sh
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/provenance.h"
#include "io/slides.h"

namespace tidewater::io {

// All texts are UTF-8 and are escaped where they are written.

struct Fact {
    std::string name = {}, value = {};
};

enum class Verdict { none, within, outside };  // of a number against its reference

struct KeyNumber {
    std::string name = {}, value = {}, reference = {},
                source = {};  // value and reference with their units; may be empty
    Verdict verdict = Verdict::none;
};

struct ReportFigure {
    std::string title = {}, caption = {};
    std::string svg = {};  // a whole SVG file
};

struct ReportTable {
    std::string title = {}, caption = {};
    std::vector<std::string> columns = {};
    std::vector<std::vector<std::string>> rows = {};  // of as many cells as there are columns
};

struct Report {
    std::string title = {}, summary = {};  // the summary is a sentence or two
    std::vector<std::string> warnings = {};
    std::vector<KeyNumber> numbers = {};
    std::vector<Slide> slides = {};
    std::string slides_note = {};  // under the pictures
    std::vector<ReportFigure> figures = {};
    std::vector<ReportTable> tables = {};
    std::vector<Fact> facts = {};
};

// Replaces path as a whole. What is empty is left out, but for the warnings, of which it then says that there
// are none. Throws InputError if a picture cannot be read, OutputError.
void write_report(const std::filesystem::path& path, const Report& report, const Provenance& provenance);

}  // namespace tidewater::io
