#include "cases.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/files.h"
#include "support/temporary_folder.h"

using namespace tidewater;
using namespace tidewater::overhang;

namespace {

const Provenance provenance{"tidewater-test", "1", "tidewater-test", "", 0};

Case make_case(const std::string& name, double height, double ratio, double length_ratio) {
    return {.name = name,
            .overhang = {.height = height, .depth = ratio * height},
            .strength = 0.5e6,
            .uniaxial_strength = 0.25e6,
            .time = 1.0,
            .length_ratio = length_ratio,
            .start_height = 0.1,
            .crack_time = 0.5,
            .crack_start_height = ratio < 0.9 ? 0.9 : 0.1,
            .crack_position = 0.8,
            .end_time = 9.0,
            .overhang_ratio = 0.5 * length_ratio};
}

std::vector<Case> some_cases() {
    std::vector<Case> cases{make_case("c", 200, 0.2, 0.5), make_case("b", 40, 0.2, 1.0),
                            make_case("a", 40, 1.0, 2.0), make_case("d", 40, 0.0, NAN)};
    sort_cases(cases);
    return cases;
}

int count(const std::string& text, const std::string& part) {
    int found = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

}  // namespace

TEST_CASE("cases are sorted by height, then by depth") {
    std::string names;
    for (const Case& c : some_cases()) names += c.name;
    CHECK(names == "dbac");
    CHECK(some_cases()[0].alike(some_cases()[2]));
    CHECK(!some_cases()[2].alike(some_cases()[3]));
}

TEST_CASE("the table tells the difference to each theory") {
    const test::TemporaryFolder folder;
    write_cases(folder.path() / "a.csv", some_cases(), provenance);
    const std::string text = read_text(folder.path() / "a.csv");
    const auto begin = text.find("\nb,40,0.2,");
    REQUIRE(begin != text.npos);
    std::string row = text.substr(begin + 1, text.find('\n', begin + 1) - begin - 1);
    std::vector<double> values;
    std::ranges::replace(row, ',', ' ');
    for (std::istringstream words(row.substr(2)); !words.eof();) words >> values.emplace_back();
    REQUIRE(values.size() == 21);
    CHECK(values[5] == 1.0);
    CHECK(values[8] == 0.9);
    CHECK(values[9] == 0.8);
    CHECK(values[10] == 0.5);
    const double eq1 = values[12];
    CHECK(std::abs(eq1 - 1.102) < 6e-4);
    CHECK(values[13] == doctest::Approx(100.0 * (1.0 / eq1 - 1.0)));
    CHECK(values[14] == doctest::Approx(100.0 * (0.5 / eq1 - 1.0)));
    CHECK(values[15] == doctest::Approx(eq1 / std::sqrt(2.0)));
    CHECK(values[18] == doctest::Approx(eq1 / 2.0));
    CHECK(values[19] == doctest::Approx(100.0 * (2.0 / eq1 - 1.0)));
    CHECK(values[20] == doctest::Approx(100.0 * (1.0 / eq1 - 1.0)));
    CHECK(text.find("\nd,40,0,5e+05,250000,1,nan,") != text.npos);
}

TEST_CASE("the chart has a panel for cases that are alike, and curves that end before they diverge") {
    const std::string svg = draw_cases(some_cases(), provenance);
    CHECK(count(svg, ">H = 40 m, ") == 1);
    CHECK(count(svg, ">H = 200 m, ") == 1);
    CHECK(count(svg, "<path") == 6);
    CHECK(count(svg, "<polygon") == 4 + 3);  // the cases, and three kinds in the legend
    CHECK(count(svg, "<circle") == 3 + 1);   // the overhangs at which something came off
    CHECK(svg.find("inf") == svg.npos);
    CHECK(draw_cases({}, provenance).find("</svg>") != std::string::npos);
}

TEST_CASE("the direction of a triangle is that of the first crack") {
    auto only = [](double crack_start_height) {
        Case c = make_case("a", 40, 0.2, 1.0);
        c.crack_start_height = crack_start_height;
        return draw_cases({c}, provenance);
    };
    CHECK(only(0.9).find("from top") != std::string::npos);
    CHECK(only(0.1).find("from bottom") != std::string::npos);
    CHECK(only(0.5).find("from inside") != std::string::npos);
}

TEST_CASE("beyond the ice's height the formula goes on, beside that of submerged ice") {
    const std::string svg = draw_cases({make_case("a", 40, 1.2, 1.0)}, provenance);
    CHECK(count(svg, "<path") == 4);
    CHECK(count(svg, ">eq. 1, submerged<") == 1);
    CHECK(make_case("a", 40, 1.2, 1.0).eq1() < make_case("a", 40, 1.2, 1.0).eq1_submerged());
}
