#include "io/chart.h"

#include <doctest/doctest.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkXMLDataElement.h>
#include <vtkXMLUtilities.h>

#include <cmath>
#include <cstdio>
#include <string>

#include "unit/io/fixture.h"

using namespace tidewater;
using namespace tidewater::io;

namespace {

Chart two_panels() {
    const double gap = std::nan("");
    Chart chart{.title = "a < b & \"c\"", .x_label = "time (s)", .panels = {}};
    for (const char* title : {"x = 2 m", "x = 4 m"}) {
        ChartPanel panel{.title = title, .y_label = "η (m)", .lines = {}, .marks = {}};
        panel.lines = {{.label = "η", .x = {0, 1, 2, 3, 4}, .y = {0, 0.1, gap, 0.2, 0}}};
        panel.marks = {{.label = "crest", .x = 3, .y = 0.2, .note = "0.2 m"},
                       {.label = "arrival", .shape = MarkShape::rule, .x = 1, .note = {}},
                       {.label = "none", .x = gap, .y = gap, .note = {}}};
        chart.panels.push_back(panel);
    }
    return chart;
}

int count(const std::string& text, const std::string& part) {
    int found = 0;
    for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

bool well_formed(const std::string& svg) {
    const auto root =
        vtkSmartPointer<vtkXMLDataElement>::Take(vtkXMLUtilities::ReadElementFromString(svg.c_str()));
    return root && std::string(root->GetName()) == "svg";
}

}  // namespace

TEST_CASE("a chart is well-formed XML, whatever its texts") {
    const std::string svg = draw_chart(two_panels(), test_provenance());
    CHECK(well_formed(svg));
    CHECK(svg.find("a &lt; b &amp; &quot;c&quot;") != std::string::npos);
    CHECK(svg.find("tidewater-test a.toml") != std::string::npos);
}

TEST_CASE("gaps interrupt a line, and marks without a place are left out") {
    const std::string svg = draw_chart(two_panels(), test_provenance());
    CHECK(count(svg, "<path") == 2);
    const auto path = svg.substr(svg.find("<path"), svg.find("/>", svg.find("<path")) - svg.find("<path"));
    CHECK(count(path, "M") == 2);
    CHECK(count(path, "L") == 2);
    CHECK(count(svg, "<circle") == 2 + 2);  // one per panel; the legend's for "crest" and for "none"
    CHECK(svg.find("nan") == std::string::npos);
}

TEST_CASE("each label is in the legend once, and the lower panel alone has the times") {
    const std::string svg = draw_chart(two_panels(), test_provenance());
    CHECK(count(svg, ">arrival<") == 1);
    CHECK(count(svg, ">η (m)<") == 2);
    CHECK(count(svg, ">time (s)<") == 1);
    CHECK(count(svg, ">2.5<") == 1);
}

TEST_CASE("marks have shapes, and what lies beyond a panel is told at its top") {
    Chart chart{.title = "t", .x_label = "x", .panels = {ChartPanel{}}};
    chart.panels[0].lines = {{.label = "l", .x = {0, 1}, .y = {0, 1}}};
    chart.panels[0].marks = {
        {.label = "a", .shape = MarkShape::point_down, .x = 0.5, .y = 3.0, .note = {}},
        {.label = "b", .shape = MarkShape::point_up, .x = 0.5, .y = 0.5, .note = {}},
        {.label = "c", .shape = MarkShape::beyond, .x = 0.5, .y = std::nan(""), .note = {}},
        {.label = "d", .shape = MarkShape::ring, .x = 0.5, .y = 1.0, .note = {}}};
    const std::string svg = draw_chart(chart, test_provenance());
    CHECK(well_formed(svg));
    CHECK(count(svg, "<polygon") == 6);
    CHECK(count(svg, "fill=\"white\" stroke-width") == 2);
    CHECK(count(svg, "r=\"4\" fill=\"none\"") == 2);
    CHECK(count(svg, ">3<") == 1);
    CHECK(svg.find("nan") == std::string::npos);
}

TEST_CASE("a legend that is too long goes on in a line below, and the panels make room") {
    Chart chart{.title = "t", .x_label = "x", .panels = {ChartPanel{}}, .width = 400.0};
    const std::string shorter = draw_chart(chart, test_provenance());
    for (const char* label : {"first of the lines", "second of the lines", "third of the lines"})
        chart.panels[0].lines.push_back({.label = label, .x = {}, .y = {}});
    const std::string svg = draw_chart(chart, test_provenance());
    CHECK(well_formed(svg));
    CHECK(count(svg, " 52.00)\">") == 1);
    CHECK(count(svg, " 72.00)\">") == 1);
    CHECK(count(svg, " 92.00)\">") == 1);
    const auto height = [](const std::string& chart_text) {
        return std::stod(chart_text.substr(chart_text.find("height=\"") + 8));
    };
    CHECK(height(svg) == doctest::Approx(height(shorter) + 40.0));
}

TEST_CASE("one range of y makes panels comparable") {
    Chart chart = two_panels();
    chart.panels[1].lines[0].y = {0, 10, 0, 0, 0};
    CHECK(count(draw_chart(chart, test_provenance()), ">10<") == 1);
    chart.one_y_range = true;
    CHECK(count(draw_chart(chart, test_provenance()), ">10<") == 2);
}

TEST_CASE("a panel with a label of its own has its own axis and leaves the others theirs") {
    Chart chart = two_panels();
    const std::string before = draw_chart(chart, test_provenance());
    ChartPanel own{
        .title = {}, .y_label = "q (kPa)", .lines = {}, .marks = {}, .x_label = "p (kPa)", .height = 300.0};
    own.lines = {{.label = {}, .x = {-500, 700}, .y = {0, 900}, .faint = true}};
    chart.panels.insert(chart.panels.begin(), own);
    const std::string svg = draw_chart(chart, test_provenance());
    CHECK(well_formed(svg));
    CHECK(count(svg, ">p (kPa)<") == 1);
    CHECK(count(svg, ">time (s)<") == 1);
    CHECK(count(svg, ">-400<") == 1);
    CHECK(count(svg, ">2.5<") == 1);  // times still below the last
    CHECK(count(svg, "height=\"300.00\"") == 1);
    const auto height = [](const std::string& text) {
        return std::stod(text.substr(text.find("height=\"") + 8));
    };
    CHECK(height(svg) == doctest::Approx(height(before) + 300 + 14 + 52));
    chart.panels.push_back(own);
    CHECK(count(draw_chart(chart, test_provenance()), ">time (s)<") == 1);
}

TEST_CASE("on logarithmic axes a power law is straight, and what is not above zero leaves a gap") {
    ChartPanel panel{.title = {}, .y_label = "N", .lines = {}, .marks = {}};
    panel.lines = {{.label = {}, .x = {0, 1, 10, 100, 1000}, .y = {5, 1e6, 1e4, 1e2, 0}}};
    panel.marks = {{.label = {}, .x = -1, .y = 10, .note = "nowhere"},
                   {.label = {}, .x = 10, .y = 10, .note = "there"}};
    panel.log_x = panel.log_y = true;
    const std::string svg = draw_chart({.title = "t", .x_label = "s", .panels = {panel}}, test_provenance());
    CHECK(well_formed(svg));
    double x[3], y[3];
    const char* path = svg.c_str() + svg.find("<path d=\"M") + 10;
    REQUIRE(std::sscanf(path, "%lf %lfL%lf %lfL%lf %lf\"", x, y, x + 1, y + 1, x + 2, y + 2) == 6);
    CHECK(x[2] - x[1] == doctest::Approx(x[1] - x[0]).epsilon(1e-3));
    CHECK(y[2] - y[1] == doctest::Approx(y[1] - y[0]).epsilon(1e-3));
    CHECK(count(svg, "nowhere") == 0);
    CHECK(count(svg, "there") == 1);
    CHECK(count(svg, ">10⁴<") == 1);
    CHECK(count(svg, "inf") + count(svg, "nan") == 0);
}

TEST_CASE("logarithmic charts with nothing to show, with one point or a short range are well-formed too") {
    Chart chart{.title = "t", .x_label = "x", .panels = {ChartPanel{}}};
    chart.panels[0].log_x = chart.panels[0].log_y = true;
    chart.panels[0].lines = {{.label = {}, .x = {0.0, -1.0}, .y = {0.0, 3.0}}};
    CHECK(well_formed(draw_chart(chart, test_provenance())));
    chart.panels[0].lines[0] = {.label = {}, .x = {5.0}, .y = {3.0}, .dots = true};
    const std::string svg = draw_chart(chart, test_provenance());
    CHECK(svg.find("nan") == std::string::npos);
    CHECK(count(svg, "<circle") == 1);
    chart.panels[0].lines[0] = {.label = {}, .x = {5.0, 6.0}, .y = {3.0, 3.3}};
    CHECK(count(draw_chart(chart, test_provenance()), ">3.1<") == 1);
}

TEST_CASE("a line that is level but for rounding is drawn as a level one") {
    for (const double value : {2132.0, 3e11, -4.5}) {
        ChartPanel panel{.title = {}, .y_label = "y", .lines = {}, .marks = {}};
        panel.lines = {{.label = {}, .x = {0, 1}, .y = {value, std::nextafter(value, 1e300)}}};
        CHECK(well_formed(draw_chart({.title = "t", .x_label = "x", .panels = {panel}}, test_provenance())));
    }
}

TEST_CASE("charts without panels, lines, points or extent are well-formed too") {
    Chart chart{.title = "empty", .x_label = "x", .panels = {}};
    CHECK(well_formed(draw_chart(chart, test_provenance())));
    chart.panels.push_back({.title = {}, .y_label = "y", .lines = {}, .marks = {}});
    CHECK(well_formed(draw_chart(chart, test_provenance())));
    chart.panels[0].lines = {{.label = "one", .x = {2.0}, .y = {5.0}, .dots = true}};
    const std::string svg = draw_chart(chart, test_provenance());
    CHECK(well_formed(svg));
    CHECK(svg.find("nan") == std::string::npos);
    CHECK(svg.find("inf") == std::string::npos);
}
