#include "io/slides.h"

#include <doctest/doctest.h>

#include "core/files.h"
#include "io/text.h"
#include "unit/io/fixture.h"

using namespace tidewater;
using namespace tidewater::io;

namespace {

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (auto at = text.find(part); at != text.npos; at = text.find(part, at + 1)) ++found;
    return found;
}

}  // namespace

TEST_CASE("the page holds every picture with its time, and needs nothing else") {
    const TemporaryFolder folder;
    write_text(folder / "a.png", "first picture");
    write_text(folder / "b.png", std::string("\x89PNG\0\xff", 6));
    write_slides(folder / "frames.html", "ice & <water>", {{0.0, folder / "a.png"}, {4.0, folder / "b.png"}},
                 test_provenance());
    CHECK(folder.file_count() == 3);
    const std::string page = read_text(folder / "frames.html");
    CHECK(page.starts_with("<!DOCTYPE html>\n"));
    CHECK(page.ends_with("</html>\n"));
    CHECK(count(page, "<img ") == 2);
    CHECK(count(page, "data-time=\"0.00\" src=\"data:image/png;base64,Zmlyc3QgcGljdHVyZQ==\"") == 1);
    CHECK(count(page, "data-time=\"4.00\" src=\"data:image/png;base64,iVBORwD/\"") == 1);
    CHECK(count(page, "src=") == 2);
    CHECK(count(page, "href") + count(page, "http") + count(page, "url(") + count(page, "import") == 0);
    CHECK(count(page, "<title>ice &amp; &lt;water&gt;</title>") == 1);
    CHECK(count(page, "max=\"1\"") == 1);
    CHECK(count(page, "data-interval=\"500\"") == 1);  // no more, for a pair that is 4 s apart
    CHECK(count(page, "command: tidewater-test a.toml") == 1);
}

TEST_CASE("played, the page takes as long as the run") {
    const TemporaryFolder folder;
    write_text(folder / "a.png", "a");
    std::vector<Slide> slides;
    for (int i = 0; i <= 50; ++i) slides.push_back({0.1 * i, folder / "a.png"});
    write_slides(folder / "frames.html", "", slides, test_provenance());
    CHECK(count(read_text(folder / "frames.html"), "data-interval=\"100\"") == 1);
}

TEST_CASE("a page without pictures is one, a picture that is missing is told") {
    const TemporaryFolder folder;
    write_slides(folder / "frames.html", "none", {}, test_provenance());
    CHECK(count(read_text(folder / "frames.html"), "<img ") == 0);
    const std::string error = input_error([&] {
        write_slides(folder / "more.html", "", {{0.0, folder / "no.png"}}, test_provenance());
    });
    CHECK(error.find("no.png: cannot be read") != error.npos);
    CHECK(folder.file_count() == 1);
}

TEST_CASE("a command cannot end the comment that it stands in") {
    const TemporaryFolder folder;
    Provenance provenance = test_provenance();
    provenance.command = "tidewater-test --set title=\"-->\"";
    write_slides(folder / "frames.html", "", {}, provenance);
    CHECK(count(read_text(folder / "frames.html"), "-->") == 1);
}
