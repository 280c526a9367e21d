#include "io/report.h"

#include <doctest/doctest.h>

#include "core/files.h"
#include "unit/io/fixture.h"

using namespace tidewater;
using namespace tidewater::io;

namespace {

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (auto at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++found;
    return found;
}

std::string page_of(const Report& report, const TemporaryFolder& folder) {
    write_report(folder / "report.html", report, test_provenance());
    return read_text(folder / "report.html");
}

}  // namespace

TEST_CASE("an empty report is a page that warns of nothing") {
    const TemporaryFolder folder;
    const std::string page = page_of({.title = "empty"}, folder);
    CHECK(page.starts_with("<!DOCTYPE html>\n"));
    CHECK(page.ends_with("</html>\n"));
    CHECK(count(page, "<h2>") == 1);
    CHECK(count(page, "Nothing in this run") == 1);
    CHECK(count(page, "<script>") == 1);
    CHECK(count(page, "command: tidewater-test a.toml") == 1);
}

TEST_CASE("a report needs nothing outside of itself, and escapes what it is given") {
    const TemporaryFolder folder;
    write_text(folder / "a.png", "picture");
    const Report report{
        .title = "ice & <water>",
        .summary = "a < b",
        .warnings = {"energy > 0 & \"more\""},
        .numbers = {{"celerity", "3.06 m/s", "3.13 m/s ± 5 %", "√(gD)", Verdict::within},
                    {"width <w>", "81 m", "50 to 60 m", "", Verdict::outside}},
        .slides = {{0.0, folder / "a.png"}, {1.0, folder / "a.png"}},
        .slides_note = "note",
        .figures = {{"η <x>", "caption", "<svg id=\"a\"/>"}},
        .tables = {{"Icebergs", "largest", {"iceberg", "volume"}, {{"0", "12.5"}, {"a<b", "nan"}}}},
        .facts = {{"scene", "a.toml"}}};
    const std::string page = page_of(report, folder);
    CHECK(count(page, "<h2>") == 6);
    CHECK(count(page, "<title>ice &amp; &lt;water&gt;</title>") == 1);
    CHECK(count(page, "energy &gt; 0 &amp; &quot;more&quot;") == 1);
    CHECK(count(page, "class=\"within\"") == 1);
    CHECK(count(page, "class=\"outside\"") == 1);
    CHECK(count(page, "<td class=\"number\">12.5</td>") == 1);
    CHECK(count(page, "<td>a&lt;b</td>") == 1);
    CHECK(count(page, "data:image/svg+xml;base64,PHN2ZyBpZD0iYSIvPg==") == 1);
    CHECK(count(page, "data:image/png;base64,") == 2);
    CHECK(count(page, "src=\"data:") == count(page, "src="));
    CHECK(count(page, "http") + count(page, "url(") + count(page, "@import") == 0);
}

TEST_CASE("a report with a picture that is missing is not written") {
    const TemporaryFolder folder;
    const std::string error = input_error([&] {
        write_report(folder / "report.html", {.title = "", .slides = {{0.0, folder / "no.png"}}},
                     test_provenance());
    });
    CHECK(error.find("no.png: cannot be read") != error.npos);
    CHECK(folder.file_count() == 0);
}
