#include "core/files.h"

#include <doctest/doctest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <fstream>
#include <string>

#include "core/error.h"
#include "support/temporary_folder.h"

using namespace tidewater;
namespace fs = std::filesystem;

TEST_CASE("a part file has its final name only after commit") {
    const test::TemporaryFolder folder;
    const fs::path path = folder.path() / "gauges.csv";
    PartFile file(path);
    std::ofstream(file.part_path()) << "whole";
    CHECK(fs::exists(file.part_path()));
    CHECK_FALSE(fs::exists(path));
    file.commit();
    CHECK_FALSE(fs::exists(file.part_path()));
    CHECK(read_text(path) == "whole");
}

TEST_CASE("a part file that is not committed leaves nothing, and the earlier file stays") {
    const test::TemporaryFolder folder;
    const fs::path path = folder.path() / "gauges.csv";
    write_text(path, "earlier");
    {
        const PartFile file(path);
        std::ofstream(file.part_path()) << "half";
    }
    CHECK(read_text(path) == "earlier");
    CHECK(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()) == 1);
}

TEST_CASE("a part file that is kept stays under its own name, and the earlier file too") {
    const test::TemporaryFolder folder;
    const fs::path path = folder.path() / "gauges.csv";
    write_text(path, "earlier");
    {
        PartFile file(path);
        std::ofstream(file.part_path()) << "half";
        file.keep();
    }
    CHECK(read_text(path) == "earlier");
    CHECK(read_text(folder.path() / "gauges.csv.part") == "half");
}

TEST_CASE("a part file in a folder that does not exist is an output error that names the file and a remedy") {
    const test::TemporaryFolder folder;
    const fs::path path = folder.path() / "missing" / "gauges.csv";
    try {
        const PartFile file(path);
        FAIL("no error");
    } catch (const OutputError& error) {
        const std::string line = error.what();
        CHECK(line.starts_with(path.string() + ": cannot be written: No such file or directory; "));
        CHECK(line.find("--run") != line.npos);
        CHECK(error.code() == ExitCode::output);
    }
}

TEST_CASE("committing onto a folder is an output error") {
    const test::TemporaryFolder folder;
    fs::create_directories(folder.path() / "taken" / "inside");
    PartFile file(folder.path() / "taken");
    CHECK_THROWS_AS(file.commit(), OutputError);
}

TEST_CASE("text reads back as written, without and with zero bytes") {
    const test::TemporaryFolder folder;
    for (const std::string& text : {std::string(), std::string("one\r\ntwo\n"), std::string("a\0b", 3)}) {
        write_text(folder.path() / "text", text);
        CHECK(read_text(folder.path() / "text") == text);
    }
}

TEST_CASE("reading a missing file or a folder is an input error") {
    const test::TemporaryFolder folder;
    CHECK_THROWS_AS(read_text(folder.path() / "missing"), InputError);
    CHECK_THROWS_AS(read_text(folder.path()), InputError);
}

TEST_CASE("an output folder is made with its parents and left empty") {
    const test::TemporaryFolder folder;
    const fs::path made = folder.path() / "a" / "b";
    make_output_folder(made);
    make_output_folder(made);
    CHECK(fs::is_empty(made));
}

TEST_CASE("an output folder below a file or without the right to write is an output error") {
    const test::TemporaryFolder folder;
    write_text(folder.path() / "file", "");
    CHECK_THROWS_AS(make_output_folder(folder.path() / "file" / "below"), OutputError);
    CHECK_THROWS_AS(make_output_folder("/proc/tidewater"), OutputError);
    CHECK_THROWS_AS(make_output_folder("/proc"), OutputError);
}

TEST_CASE("a folder that one lock holds is refused to another until it is let go") {
    const test::TemporaryFolder folder;
    {
        const FolderLock lock(folder.path());
        CHECK_THROWS_WITH_AS(FolderLock(folder.path()), doctest::Contains("another run is writing here"),
                             OutputError);
    }
    CHECK_NOTHROW(FolderLock(folder.path()));
}
