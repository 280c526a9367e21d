#include <doctest/doctest.h>

#include "scene/effects/effects.h"
#include "scene/text.h"
#include "unit/scene/fixture.h"

using namespace tidewater;
using namespace tidewater::scene;
using Lines = std::vector<std::string>;

TEST_CASE("a scene that is in order reads with its values and the defaults") {
    const Scene scene = read_text_as_scene(block_scene);
    CHECK(scene.domain.size == std::vector<double>{16.0, 1.0});
    CHECK(scene.domain.cell_size == 0.01);
    CHECK(scene.domain.gravity == 9.81);
    CHECK(scene.water.model.sound_speed == mpm::WaterModel{}.sound_speed);
    CHECK(scene.blocks[0].center == std::vector<double>{0.3, 0.7});
    CHECK(scene.has("water"));
    CHECK(scene.has("rigid"));
    CHECK_FALSE(scene.has("ice"));
    CHECK(problems(water_scene_3d).empty());
}

TEST_CASE("every type of key reads from the file") {
    const Scene scene = read_text_as_scene(
        "title = \"a \\\"b\\\"\"\nseed = 9223372036854775807\n" + block_scene +
        "gauges = [1, 2.5]\nprecision = \"double\"\n[particles]\nper_axis = 3\n[domain.unused]\n");
    CHECK(scene.title == "a \"b\"");
    CHECK(scene.seed == 9223372036854775807u);
    CHECK(scene.simulate.gauges == Points{{1.0}, {2.5}});
    CHECK(scene.simulate.precision == Precision::double_precision);
    CHECK(scene.particles.per_axis == 3);
}

TEST_CASE("gauges are places along the tank or points, and print as they were written") {
    const Sets sets{"simulate.gauges=[0.5, [2, 0.25], [3]]", "postprocess.gauges=[[1, 2]]",
                    "simulate.pressure_gauges=[[4, 1, 0], [2, 0.5, 0.25]]"};
    const Scene scene = read_text_as_scene(water_scene_3d, sets);
    CHECK(scene.simulate.gauges == Points{{0.5}, {2.0, 0.25}, {3.0}});
    CHECK(scene.postprocess.gauges == Points{{1.0, 2.0}});
    CHECK(scene.simulate.pressure_gauges == Points{{4.0, 1.0, 0.0}, {2.0, 0.5, 0.25}});
    CHECK(resolved_text(scene).find("\ngauges = [0.5, [2, 0.25], 3] ") != std::string::npos);
    CHECK(resolved_text(read_text_as_scene(resolved_text(scene))) == resolved_text(scene));
    CHECK(problem(water_scene_3d, {"simulate.gauges=[[1, \"a\"]]"})
              .find("needs a list of numbers or points in m") != std::string::npos);
}

TEST_CASE("sections may be headers, dotted keys or inline tables") {
    const std::string inline_tables =
        "effects = [\"water\"]\ndomain = {size = [2, 1], cell_size = 0.1}\nwater.depth = 0.5\n"
        "[simulate]\nend_time = 1\nsnapshot_interval = 1\n";
    CHECK(read_text_as_scene(inline_tables).domain.cell_size == 0.1);
}

TEST_CASE("a missing file or a folder is an input error") {
    const test::TemporaryFolder folder;
    CHECK_THROWS_AS(read_scene(folder.path() / "a.toml"), InputError);
    CHECK_THROWS_AS(read_scene(folder.path()), InputError);
}

TEST_CASE("an empty file lacks the keys that every scene needs") {
    CHECK(problems("") ==
          Lines{"a.toml: effects: missing; add it, e.g. effects = [\"water\", \"rigid\"]",
                "a.toml: domain.size: missing; add it under [domain], e.g. size = [16, 1]",
                "a.toml: domain.cell_size: missing; add it under [domain], e.g. cell_size = 0.01",
                "a.toml: simulate.end_time: missing; add it under [simulate], e.g. end_time = 10",
                "a.toml: simulate.snapshot_interval: missing; add it under [simulate], e.g. "
                "snapshot_interval = 0.1"});
}

TEST_CASE("an effect needs its own keys") {
    const Lines lines = problems(
        "effects = [\"water\", \"rigid\"]\n[domain]\nsize = [2, 1]\ncell_size = 0.1\n"
        "[simulate]\nend_time = 1\nsnapshot_interval = 1\n");
    REQUIRE(lines.size() == 3);
    CHECK(lines[0] == "a.toml: water.depth: missing; add it under [water], e.g. depth = 0.5");
    CHECK(lines[1] == "a.toml: block.size: missing; add it under [block], e.g. size = [0.5, 0.5]");
    CHECK(lines[2] == "a.toml: block.center: missing; add it under [block], e.g. center = [0.25, 0.75]");
}

TEST_CASE("an unknown key is told with its line and the nearest known one") {
    CHECK(problem("titel = \"x\"\n" + block_scene) == "a.toml:1: titel: unknown key; did you mean title?");
    CHECK(problem(block_scene + "end_tme = 1\n") ==
          "a.toml:13: simulate.end_tme: unknown key; did you mean simulate.end_time?");
    CHECK(problem("cell_size = 1\n" + block_scene) ==
          "a.toml:1: cell_size: unknown key; did you mean domain.cell_size?");
    CHECK(problem(block_scene + "[blok]\nangle = 1\n") ==
          "a.toml:14: blok.angle: unknown key; did you mean block.angle?");
}

TEST_CASE("an unknown key that is near none points to the reference") {
    CHECK(problem("viscosity = 1\n" + block_scene) ==
          "a.toml:1: viscosity: unknown key; --help-scene lists all keys");
}

TEST_CASE("a section that is given as a value or as a list is an unknown key") {
    CHECK(problem("particles = 3\n" + block_scene) ==
          "a.toml:1: particles: unknown key; --help-scene lists all keys");
    CHECK(problem(block_scene + "[[particles]]\njitter = 1\n") ==
          "a.toml:14: particles.1.jitter: unknown key; did you mean particles.jitter?");
}

TEST_CASE("a wrong type is told with what is needed, an example and what was found") {
    CHECK(set_problem("domain.cell_size=fine") ==
          "needs a number in m, e.g. cell_size = 0.01; got text \"fine\"");
    CHECK(set_problem("domain.cell_size=[1]") ==
          "needs a number in m, e.g. cell_size = 0.01; got a list of 1 number");
    CHECK(set_problem("particles.per_axis=2.5") == "needs a whole number, e.g. per_axis = 2; got 2.5");
    CHECK(set_problem("seed=-1") == "needs a whole number of 0 or more, e.g. seed = 1; got -1");
    CHECK(set_problem("title=3") ==
          "needs text in quotes, e.g. title = \"A block falls into the tank\"; got 3");
    CHECK(set_problem("simulate.gauges=2") ==
          "needs a list of numbers or points in m, e.g. gauges = [2, 4.5]; got 2");
    CHECK(set_problem("simulate.gauges=[\"a\", \"b\"]") ==
          "needs a list of numbers or points in m, e.g. gauges = [2, 4.5]; got a list of 2 words");
    CHECK(set_problem("simulate.gauges=[2, \"b\"]") ==
          "needs a list of numbers or points in m, e.g. gauges = [2, 4.5]; got a list of numbers and words");
    CHECK(set_problem("block.size=true") ==
          "needs a list with one number per dimension in m, e.g. size = [0.5, 0.5]; got true");
    CHECK(set_problem("effects=[1]") ==
          "needs a list of words in quotes, e.g. effects = [\"water\", \"rigid\"]; got a list of 1 number");
    CHECK(set_problem("simulate.end_time=1979-05-27") ==
          "needs a number in s, e.g. end_time = 10; got a date or time");
}

TEST_CASE("a name out of a fixed set is told with the set") {
    CHECK(set_problem("domain.wall_top=stik") ==
          "needs one of \"slip\", \"stick\" or \"separate\", e.g. wall_top = \"slip\"; got text \"stik\"");
    CHECK(set_problem("simulate.precision=half") ==
          "needs one of \"float\" or \"double\", e.g. precision = \"float\"; got text \"half\"");
}

TEST_CASE("a value out of range is told with the range and the unit") {
    CHECK(set_problem("water.depth=0") == "0 m is out of range; it must be above 0 m");
    CHECK(set_problem("domain.gravity=-1") == "-1 m/s² is out of range; it must be at least 0 m/s²");
    CHECK(set_problem("particles.jitter=1.5") == "1.5 is out of range; it must be from 0 to 1");
    CHECK(set_problem("simulate.cfl=0") == "0 is out of range; it must be above 0 and at most 1");
    CHECK(set_problem("block.size=[1, -1]") == "-1 m is out of range; it must be above 0 m");
    CHECK(set_problem("simulate.gauges=[2, -1]") == "-1 m is out of range; it must be at least 0 m");
    CHECK(set_problem("dimension=4") == "4 is out of range; it must be from 2 to 3");
    CHECK(set_problem("particles.per_axis=99999999999") ==
          "1000000000 is out of range; it must be from 1 to 8");
}

TEST_CASE("infinity and not-a-number are out of every range") {
    CHECK(set_problem("water.depth=inf") == "inf m is out of range; it must be a finite number above 0 m");
    CHECK(set_problem("block.center=[nan, 1]") == "nan m is out of range; it must be a finite number");
}

TEST_CASE("the ends of a closed range are allowed") {
    CHECK(set_problem("particles.jitter=0") == "");
    CHECK(set_problem("particles.jitter=1") == "");
    CHECK(set_problem("simulate.cfl=1") == "");
}

TEST_CASE("a list has one number per dimension") {
    CHECK(set_problem("block.center=[1, 2, 3]") == "has 3 numbers, but dimension = 2 needs 2: (x, z)");
    CHECK(set_problem("block.center=[]") == "has 0 numbers, but dimension = 2 needs 2: (x, z)");
    CHECK(problem(water_scene_3d, {"domain.size=[4]"}) ==
          "--set domain.size=[4]: has 1 number, but dimension = 3 needs 3: (x, y, z)");
}

TEST_CASE("a key of 3D is an error in 2D") {
    CHECK(set_problem("domain.wall_front=slip") == "exists in 3D only; remove it or set dimension = 3");
    CHECK(problem(water_scene_3d, {"domain.wall_front=stick"}) == "");
}

TEST_CASE("a key of an effect that is not named is an error") {
    CHECK(problems(block_scene, {"effects=[\"water\"]"}) ==
          Lines{"a.toml:8: block.size: belongs to the effect \"rigid\"; add \"rigid\" to effects or remove "
                "the key",
                "a.toml:9: block.center: belongs to the effect \"rigid\"; add \"rigid\" to effects or remove "
                "the key"});
}

TEST_CASE("an unknown effect is told with the nearest known one") {
    CHECK(set_problem("effects=[\"watter\", \"rigid\"]") ==
          "unknown effect \"watter\"; did you mean \"water\"?");
    CHECK(set_problem("effects=[\"magma\"]") ==
          "unknown effect \"magma\"; known are " + enumeration(known_effects(), "and"));
}

TEST_CASE("a scene without effects has no particles, and one named twice is an error") {
    CHECK(set_problem("effects=[]") ==
          "names none, so there would be no particles; e.g. effects = [\"water\"]");
    CHECK(set_problem("effects=[\"water\", \"rigid\", \"water\"]") == "\"water\" is named twice");
}

TEST_CASE("a duplicate key is told with its line and its section") {
    CHECK(problem(block_scene + "end_time = 11\n") ==
          "a.toml:13: simulate.end_time: duplicate key; keep one of them");
    CHECK(problem("seed = 1\nseed = 1\n" + block_scene) == "a.toml:2: seed: duplicate key; keep one of them");
}

TEST_CASE("a duplicate section is told with its line") {
    CHECK(problem(block_scene + "[water]\nlength = 1\n") ==
          "a.toml:13: duplicate section 'water'; move its keys to the first one");
}

TEST_CASE("a word without quotes is told as such, at its key") {
    CHECK(problem(block_scene + "precision = double  # fine\n") ==
          "a.toml:13: simulate.precision: needs one of \"float\" or \"double\", e.g. precision = \"float\"; "
          "got double, "
          "which is not a TOML value (text needs quotes)");
}

TEST_CASE("what is not TOML is told with its line") {
    CHECK(problem("effects = [\"water\"\nseed = 1\n").starts_with("a.toml:2: not TOML: "));
    CHECK(problem("\xff\n").starts_with("a.toml:1: not TOML: "));
}

TEST_CASE("all problems of a scene are told at once, in the order of the file") {
    const std::string text = R"(titel = "x"
effects = ["water", "rigid"]
[domain]
size = [16.003, 1]
cell_size = 0.01
wall_top = stick
[water]
depth = "deep"
[block]
size = [0.5, 0.25, 1]
[simulate]
end_time = 10
end_time = 11
snapshot_interval = 20
cfl = 2
)";
    const Lines lines = problems(text, {"water.dpeth=1"});
    const Lines starts{"a.toml:13: simulate.end_time: duplicate key",
                       "a.toml:1: titel: unknown key",
                       "a.toml:6: domain.wall_top: needs one of",
                       "a.toml:8: water.depth: needs a number",
                       "a.toml:10: block.size: has 3 numbers",
                       "a.toml:15: simulate.cfl: 2 is out of range",
                       "--set water.dpeth=1: unknown key",
                       "a.toml: block.center: missing",
                       "a.toml:4: domain.size: 16.003 m along x",
                       "a.toml:14: simulate.snapshot_interval: 20 s is longer"};
    REQUIRE(lines.size() == starts.size());
    for (std::size_t i = 0; i < starts.size(); ++i) CHECK_MESSAGE(lines[i].starts_with(starts[i]), lines[i]);
}

TEST_CASE("--set replaces the file's value, even a wrong one, and the last of two counts") {
    CHECK(read_text_as_scene(block_scene, {"water.depth=0.4"}).water.depth == 0.4);
    CHECK(read_text_as_scene(block_scene, {"water.depth=0.4", "water.depth=0.3"}).water.depth == 0.3);
    CHECK(read_text_as_scene("seed = \"x\"\n" + block_scene, {"seed=5"}).seed == 5);
}

TEST_CASE("--set takes TOML, and bare words as text") {
    CHECK(read_text_as_scene(block_scene, {"title=Eqip 2014"}).title == "Eqip 2014");
    CHECK(read_text_as_scene(block_scene, {"title=\"2014\""}).title == "2014");
    CHECK(read_text_as_scene(block_scene, {"title = a=b "}).title == "a=b");
    CHECK(read_text_as_scene(block_scene, {"title="}).title == "");
    CHECK(read_text_as_scene(block_scene, {"domain.wall_top=separate"}).domain.wall_top ==
          mpm::WallRule::separate);
    CHECK(read_text_as_scene(block_scene, {"simulate.gauges=[]"}).simulate.gauges.empty());
    CHECK(read_text_as_scene(block_scene, {"title=a\nseed = 3"}).seed == 1);
}

TEST_CASE("--set without a key and a value is an error that shows the form") {
    for (const char* text : {"seed", "=1", ""}) {
        CHECK_THROWS_WITH_AS(
            parse_override(text),
            (std::string("--set ") + text + ": needs key=value, e.g. --set domain.cell_size=0.02").c_str(),
            SceneError);
    }
}
