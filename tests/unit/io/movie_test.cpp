#include "io/movie.h"

#include <doctest/doctest.h>

#include <cstdlib>
#include <fstream>

#include "core/files.h"
#include "io/canvas.h"
#include "unit/io/fixture.h"

using namespace tidewater;
using namespace tidewater::io;

namespace {

// A program in place of ffmpeg, which writes its arguments and the list it is given to the movie's file.
std::filesystem::path fake_ffmpeg(const TemporaryFolder& folder, int exit_code) {
    const auto path = folder / "ffmpeg";
    std::ofstream(path)
        << "#!/bin/sh\nwhile [ $# -gt 1 ]; do [ \"$1\" = -i ] && list=$2; echo \"$1\" >>\"$0.log\";"
        << " shift; done\ncat \"$list\" >\"$1\"\nexit " << exit_code << "\n";
    std::filesystem::permissions(path, std::filesystem::perms::owner_all);
    return path;
}

}  // namespace

TEST_CASE("a movie is as fast as its times, within what the eye can follow") {
    CHECK(movie_rate({0.0, 0.1, 0.2}) == doctest::Approx(10.0));
    CHECK(movie_rate({0.0, 50.0, 100.0}) == 4.0);
    CHECK(movie_rate({0.0, 1e-3}) == 30.0);
    CHECK(movie_rate({}) == 4.0);
    CHECK(movie_rate({5.0}) == 4.0);
}

TEST_CASE("a program is looked for in the folders of PATH") {
    CHECK(find_on_path("sh"));
    CHECK(!find_on_path("no-such-program-of-tidewater"));
}

TEST_CASE(
    "ffmpeg gets the pictures in order, whatever their names, and what it writes gets its name at the end") {
    const TemporaryFolder folder;
    const auto movie = folder / "frames.mp4";
    write_movie(fake_ffmpeg(folder, 0), {folder / "b it's.png", folder / "a.png"}, 12.5, movie);
    const std::string list = read_text(movie);
    CHECK(list.find("b it'\\''s.png'\n") < list.find("a.png'\n"));
    CHECK(read_text(folder / "ffmpeg.log").find("\n12.500\n") != std::string::npos);
    CHECK(folder.file_count() == 3);
}

TEST_CASE("a movie that fails is told, and leaves the earlier one and no part") {
    const TemporaryFolder folder;
    const auto movie = folder / "frames.mp4";
    write_text(movie, "earlier");
    CHECK_THROWS_AS(write_movie(fake_ffmpeg(folder, 3), {folder / "a.png"}, 5.0, movie), OutputError);
    CHECK_THROWS_AS(write_movie(folder / "none", {folder / "a.png"}, 5.0, movie), OutputError);
    CHECK(read_text(movie) == "earlier");
    CHECK(folder.file_count() == 3);
}

TEST_CASE("where ffmpeg is there, it makes a movie of pictures of odd sizes") {
    const auto ffmpeg = find_on_path("ffmpeg");
    if (!ffmpeg) return;
    const TemporaryFolder folder;
    std::vector<std::filesystem::path> pictures;
    for (const char* name : {"a.png", "b.png", "c.png"}) {
        pictures.push_back(folder / name);
        Canvas(101, 51, scale_color(0.3 * static_cast<double>(pictures.size())))
            .write_png(pictures.back(), test_provenance());
    }
    write_movie(*ffmpeg, pictures, 10.0, folder / "frames.mp4");
    CHECK(read_text(folder / "frames.mp4").find("ftyp") == 4);
    CHECK(folder.file_count() == 4);
}
