#include "cases.h"

#include <doctest/doctest.h>

#include <cmath>

#include "core/error.h"
#include "core/files.h"
#include "io/table.h"
#include "support/temporary_folder.h"

using namespace tidewater;
using namespace tidewater::lab;

namespace {

const Provenance provenance{"tidewater-test", "1", "tidewater-test", "", 0};

constexpr const char* names =
    "block,mass,speed,speed_time,F,S,M,P,impulse_amplitude,direction,amplitude,amplitude_time,amplitude_x,"
    "amplitude_distance,celerity,celerity_from,long_wave_celerity,error_percent,linear_celerity,block_energy,"
    "water_energy,lost_energy,greatest_rise\n";

// A gravity fall whose wave to the left is the higher one.
std::filesystem::path write_run(const test::TemporaryFolder& folder, const std::string& name) {
    const auto results = folder.path() / name / "postprocess";
    make_output_folder(results);
    write_text(results / "tsunami.csv",
               std::string(names) +
                   "1,230,1.0,0.4,0.32,0.5,0.23,0.07,0.05,-1,0.15,0.5,7,1,3.0,0.9,3.132,-4.2,"
                   "2.9,-100,70,30,0.5\n");
    write_text(results / "first_wave.csv",
               "time,x,distance,amplitude,amplitude_ratio,time_from_greatest,direction\n"
               "0.5,9,1,0.1,1,0,1\n0.6,9.3,1.3,0.09,0.9,0.1,1\n"
               "0.4,7.3,0.7,0.12,0.8,-0.1,-1\n0.5,7,1,0.15,1,0,-1\n0.7,6.4,1.6,0.12,0.8,0.2,-1\n");
    return folder.path() / name;
}

}  // namespace

TEST_CASE("a run is read with the wave that is higher, from where it was greatest") {
    const test::TemporaryFolder folder;
    const Case c = read_case("GF 0.04=" + write_run(folder, "a").string());
    CHECK(c.label == "GF 0.04");
    CHECK(c.speed == 1.0);
    CHECK(c.time == std::vector{-0.1, 0.0, 0.2});
    CHECK(c.ratio == std::vector{0.8, 1.0, 0.8});
    REQUIRE(c.run.size() == 3);
    CHECK(c.run[0] == doctest::Approx(-0.3));
    CHECK(c.run[2] == doctest::Approx(0.6));
    CHECK(c.celerity_error() == doctest::Approx(-4.215).epsilon(1e-3));
    CHECK(read_case(write_run(folder, "b").string()).label == "b");
}

TEST_CASE("the speed of long waves is that of the higher wave's way, else of the first that has one") {
    const test::TemporaryFolder folder;
    const auto run = write_run(folder, "a"), results = run / "postprocess";
    CHECK(std::isnan(read_case(run.string()).long_waves));
    write_text(results / "long_waves.csv", "direction,celerity,error\n1,3.2,0.1\n-1,3.1,0.02\n");
    const Case c = read_case(run.string());
    CHECK(c.long_waves == 3.1);
    CHECK(c.long_waves_error == 0.02);
    write_text(results / "long_waves.csv", "direction,celerity,error\n1,3.2,0.1\n-1,nan,nan\n");
    CHECK(std::isnan(read_case(run.string()).long_waves));
    write_text(results / "tsunami.csv",
               std::string(names) +
                   "1,230,1.0,0.4,0.32,0.5,0.23,0.07,0.05,nan,nan,nan,nan,nan,nan,nan,3.132,nan,"
                   "nan,-100,70,30,0.5\n");
    CHECK(read_case(run.string()).long_waves == 3.2);
}

TEST_CASE("the wave in 3D follows from the simulated speed or from the laboratory's") {
    const test::TemporaryFolder folder;
    const Case c = read_case("GF=" + write_run(folder, "a").string());
    // 0.192: lib/analysis/README.md, Slides.
    CHECK(c.amplitude_3d(2.0, true) == doctest::Approx(0.15 * 0.192).epsilon(0.005));
    CHECK(c.amplitude_3d(2.0) / c.amplitude_3d(2.0, true) ==
          doctest::Approx(std::pow(0.32 * 3.132 / 1.15, 0.4)).epsilon(1e-3));
    CHECK(c.slide().mass_ratio() == doctest::Approx(0.23));
}

TEST_CASE("labels name their experiment by how they begin") {
    CHECK(experiment_of("GF")->speed == 1.15);
    CHECK(experiment_of("BF, 1 cm")->speed == 0.48);
    CHECK(experiment_of("CS")->farthest == 15.0);
    CHECK(experiment_of("quickstart") == nullptr);
    CHECK(experiment_of("") == nullptr);
}

TEST_CASE("table and picture hold every run, also one without a wave or an experiment") {
    const test::TemporaryFolder folder;
    std::vector<Case> cases{read_case("GF=" + write_run(folder, "a").string()), {}, {}};
    cases[1].label = "BF";
    cases[2].label = "other";
    cases[2].long_waves = 3.15;
    write_cases(folder.path() / "lab.csv", cases, provenance);
    const std::string table = read_text(folder.path() / "lab.csv");
    CHECK(table.find("\nGF,1,1.15,-13.04") != table.npos);
    CHECK(table.find("\nBF,nan,0.48,nan,") != table.npos);
    CHECK(table.find("\nother,nan,nan,nan,") != table.npos);
    const std::string svg = draw_cases(cases, provenance);
    CHECK(svg.starts_with("<svg "));
    CHECK(svg.find("GF: 0.1500 m, 3.00 m/s (-4.2 %)") != svg.npos);
    CHECK(svg.find("BF: no crest<") != svg.npos);
    CHECK(svg.find("other: no crest, long waves 3.15 m/s") != svg.npos);
    CHECK(svg.find("nan") == svg.npos);
    CHECK(draw_cases({}, provenance).ends_with("</svg>\n"));
    CHECK(describe(cases).find("GF") != std::string::npos);
}

TEST_CASE("what a run lacks is told") {
    const test::TemporaryFolder folder;
    CHECK_THROWS_AS(read_case(folder.path().string()), InputError);
    const auto run = write_run(folder, "a");
    write_text(run / "postprocess" / "tsunami.csv", "speed\n1\n");
    CHECK_THROWS_AS(read_case(run.string()), InputError);
}
