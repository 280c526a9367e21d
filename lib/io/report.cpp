#include "io/report.h"

#include "core/files.h"
#include "io/html.h"
#include "io/report_page.h"
#include "io/text.h"

namespace tidewater::io {
namespace {

std::string element(const std::string& name, const std::string& text) {
    return "<" + name + ">" + escape_xml(text) + "</" + name + ">";
}

std::string section(const std::string& id, const std::string& title, const std::string& content) {
    if (content.empty()) return {};
    return "<section id=\"" + id + "\">\n<h2>" + escape_xml(title) + "</h2>\n" + content + "</section>\n";
}

std::string warnings(const Report& report) {
    if (report.warnings.empty())
        return "<p class=\"fine\">Nothing in this run's files calls for a warning.</p>\n";
    std::string text = "<ul>\n";
    for (const std::string& warning : report.warnings) text += element("li", warning) + "\n";
    return text + "</ul>\n";
}

std::string verdict_cell(Verdict verdict) {
    if (verdict == Verdict::within) return "<td class=\"within\">&#10003; within</td>";
    if (verdict == Verdict::outside) return "<td class=\"outside\">&#9650; outside</td>";
    return "<td></td>";
}

std::string numbers(const Report& report) {
    if (report.numbers.empty()) return {};
    std::string text =
        "<div class=\"wide\"><table>\n<thead><tr><th scope=\"col\">What</th><th scope=\"col\">This run</th>"
        "<th scope=\"col\">Reference</th><th scope=\"col\">Verdict</th><th scope=\"col\">Source</th></tr>"
        "</thead>\n<tbody>\n";
    for (const KeyNumber& number : report.numbers) {
        text += "<tr>" + element("td", number.name) + "<td class=\"number\">" + escape_xml(number.value) +
                "</td>" + element("td", number.reference) + verdict_cell(number.verdict) +
                element("td", number.source) + "</tr>\n";
    }
    return text + "</tbody>\n</table></div>\n";
}

std::string slides(const Report& report) {
    if (report.slides.empty()) return {};
    return slides_markup(report.title, report.slides) + "<p class=\"soft\">" +
           escape_xml(report.slides_note) + "</p>\n";
}

// As images, in which nothing of one chart can reach into another.
std::string figures(const Report& report) {
    if (report.figures.empty()) return {};
    std::string text = "<div class=\"figures\">\n";
    for (const ReportFigure& figure : report.figures) {
        text += "<figure>\n" + element("h3", figure.title) + "\n<img alt=\"" + escape_xml(figure.title) +
                "\" src=\"data:image/svg+xml;base64," + encode_base64(figure.svg) + "\">\n" +
                element("figcaption", figure.caption) + "\n</figure>\n";
    }
    return text + "</div>\n";
}

std::string cell(const std::string& text) {
    const std::string start = parse_number(text) ? "<td class=\"number\">" : "<td>";
    return start + escape_xml(text) + "</td>";
}

std::string table(const ReportTable& table) {
    std::string text = element("h3", table.title) + "\n<div class=\"wide\"><table class=\"sortable\">\n" +
                       element("caption", table.caption) + "\n<thead><tr>";
    for (const std::string& column : table.columns)
        text += "<th scope=\"col\">" + escape_xml(column) + "</th>";
    text += "</tr></thead>\n<tbody>\n";
    for (const auto& row : table.rows) {
        text += "<tr>";
        for (const std::string& each : row) text += cell(each);
        text += "</tr>\n";
    }
    return text + "</tbody>\n</table></div>\n";
}

std::string tables(const Report& report) {
    std::string text;
    for (const ReportTable& each : report.tables) text += table(each);
    return text;
}

std::string facts(const Report& report) {
    if (report.facts.empty()) return {};
    std::string text = "<div class=\"wide\"><table>\n<tbody>\n";
    for (const Fact& fact : report.facts)
        text += "<tr><th scope=\"row\">" + escape_xml(fact.name) + "</th>" + element("td", fact.value) +
                "</tr>\n";
    return text + "</tbody>\n</table></div>\n";
}

struct Part {
    const char* id;
    const char* title;
    std::string content;
};

}  // namespace

void write_report(const std::filesystem::path& path, const Report& report, const Provenance& provenance) {
    const Part parts[] = {
        {"warnings", "Warnings", warnings(report)}, {"numbers", "Key numbers", numbers(report)},
        {"pictures", "Pictures", slides(report)},   {"charts", "Charts", figures(report)},
        {"tables", "Tables", tables(report)},       {"run", "What was run", facts(report)}};
    std::string links, sections;
    for (const Part& part : parts) {
        if (part.content.empty()) continue;
        links += "<a href=\"#" + std::string(part.id) + "\">" + part.title + "</a>\n";
        sections += section(part.id, part.title, part.content);
    }
    const std::string script = report.slides.empty() ? "" : slides_script();
    write_text(path,
               "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
               "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
               "<link rel=\"icon\" href=\"data:,\">\n" +
                   provenance_comment(provenance) + element("title", report.title) + "\n<style>\n" +
                   report_style + slides_style() + "</style>\n</head>\n<body>\n<header>\n" +
                   element("h1", report.title) + "\n" + element("p", report.summary) + "\n<nav>\n" + links +
                   "</nav>\n</header>\n<main>\n" + sections + "</main>\n" + script + report_script +
                   "</body>\n</html>\n");
}

}  // namespace tidewater::io
