// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Figures are images in `data:` addresses: a reader shows them as drawn, and nothing in
// them can reach out of the file.
#include "ui/report/report_html.h"

#include "solver/scene/xml_text.h"

#include <QByteArray>

#include <cmath>

namespace keyblock {

namespace {

constexpr std::size_t longestTitle = 60;  // letters, of the title of the window

constexpr const char* htmlStyle = R"(
:root { color-scheme: light; }
body { margin: 0 auto; padding: 2rem 1.5rem; max-width: 60rem; color: #1b1f24; background: #fff;
  font: 1rem/1.5 Inter, "Noto Sans", "Helvetica Neue", Arial, sans-serif; }
header { border-bottom: 2px solid #1b1f24; margin-bottom: 1.5rem; }
header img { float: right; max-width: 12rem; max-height: 5rem; }
h1 { font-size: 1.8rem; line-height: 1.25; margin: 0 0 1rem; }
h2 { font-size: 1.3rem; margin: 2.5rem 0 .75rem; }
dl { display: grid; grid-template-columns: max-content auto; gap: .15rem 1.5rem; margin: 0 0 1.25rem; }
dt { color: #4a5260; }
dd { margin: 0; overflow-wrap: anywhere; }
nav ol { margin: 0; padding-left: 1.5rem; }
a { color: #1c4e9c; }
.scroll { overflow-x: auto; margin: 1.25rem 0; }
table { border-collapse: collapse; font-size: .85rem; font-variant-numeric: tabular-nums; min-width: 50%; }
caption { text-align: left; font-weight: 600; padding-bottom: .4rem; }
th, td { text-align: left; vertical-align: top; padding: .25rem .75rem .25rem 0; border-bottom: 1px solid #d9dde2;
  overflow-wrap: anywhere; }
thead th { border-bottom: 1.5px solid #1b1f24; vertical-align: bottom; overflow-wrap: normal; }
.number { text-align: right; white-space: nowrap; }
thead .number { white-space: normal; }
figure { margin: 1.25rem 0; }
figure img { width: 100%; height: auto; border: 1px solid #e4e7eb; }
figcaption { font-weight: 600; font-size: .85rem; }
.answer { font-size: 1.15rem; font-weight: 600; }
.warning { color: #a01d24; font-weight: 600; }
pre { background: #f3f4f6; padding: .75rem 1rem; white-space: pre-wrap; overflow-wrap: anywhere; font-size: .85rem; }
footer { margin-top: 3rem; border-top: 1px solid #d9dde2; color: #4a5260; font-size: .85rem; padding-top: .5rem; }
@media print {
  body { max-width: none; padding: 0; font-size: 9.5pt; }
  h2 { break-after: avoid; }
  figure, tr { break-inside: avoid; }
  .scroll { overflow: visible; }
  thead { display: table-header-group; }
}
@page { size: A4; margin: 20mm; }
)";

/// The first letters of a text in UTF-8.
std::string firstLetters(const std::string& text, std::size_t most) {
    std::size_t letters = 0;
    for (std::size_t at = 0; at < text.size(); ++at)
        if ((static_cast<unsigned char>(text[at]) & 0xC0) != 0x80 && ++letters > most) return text.substr(0, at) + "…";
    return text;
}

std::string dataAddress(const std::string& bytes, const std::string& mediaType) {
    const QByteArray raw = QByteArray::fromRawData(bytes.data(), static_cast<int>(bytes.size()));
    return "data:" + mediaType + ";base64," + raw.toBase64().toStdString();
}

class HtmlWriter {
public:
    explicit HtmlWriter(const ReportDocument& document) : document_(document) {}

    std::string write() {
        out_ = "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n";
        out_ += "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n";
        out_ += "<meta name=\"generator\" content=\"Keyblock\">\n<title>" +
                xmlText(firstLetters(document_.title, longestTitle)) + "</title>\n<style>" + htmlStyle +
                "</style>\n</head>\n<body>\n";
        writeHead();
        writeContents();
        out_ += "<main>\n";
        for (std::size_t i = 0; i < document_.sections.size(); ++i) writeSection(i);
        out_ += "</main>\n<footer>\n<p>" + xmlText(document_.foot) + "</p>\n</footer>\n</body>\n</html>\n";
        return std::move(out_);
    }

private:
    void writeHead() {
        out_ += "<header>\n";
        if (document_.logo)
            out_ += "<img src=\"" + dataAddress(document_.logo->bytes, document_.logo->mediaType) +
                    "\" alt=\"Logo\">\n";
        out_ += "<h1>" + xmlText(document_.title) + "</h1>\n";
        if (!document_.facts.empty()) {
            out_ += "<dl>\n";
            for (const auto& [name, value] : document_.facts)
                out_ += "<dt>" + xmlText(name) + "</dt>\n<dd>" + xmlText(value) + "</dd>\n";
            out_ += "</dl>\n";
        }
        out_ += "</header>\n";
    }

    static std::string id(std::size_t section) { return "section-" + std::to_string(section + 1); }

    void writeContents() {
        out_ += "<nav aria-labelledby=\"contents\">\n<h2 id=\"contents\">Contents</h2>\n<ol>\n";
        for (std::size_t i = 0; i < document_.sections.size(); ++i)
            out_ += "<li><a href=\"#" + id(i) + "\">" + xmlText(document_.sections[i].heading) + "</a></li>\n";
        out_ += "</ol>\n</nav>\n";
    }

    void writeSection(std::size_t i) {
        const ReportSection& section = document_.sections[i];
        out_ += "<section aria-labelledby=\"" + id(i) + "\">\n<h2 id=\"" + id(i) + "\">" + std::to_string(i + 1) + " " +
                xmlText(section.heading) + "</h2>\n";
        for (const ReportPart& part : section.parts) std::visit([this](const auto& one) { write(one); }, part);
        out_ += "</section>\n";
    }

    void write(const ReportText& text) {
        switch (text.kind) {
            case ReportTextKind::Body: out_ += "<p>" + xmlText(text.text) + "</p>\n"; break;
            case ReportTextKind::Answer: out_ += "<p class=\"answer\">" + xmlText(text.text) + "</p>\n"; break;
            case ReportTextKind::Warning: out_ += "<p class=\"warning\">" + xmlText(text.text) + "</p>\n"; break;
            case ReportTextKind::Command: out_ += "<pre><code>" + xmlText(text.text) + "</code></pre>\n"; break;
        }
    }

    static std::string classOf(const ReportColumn& column) { return column.isNumber ? " class=\"number\"" : ""; }

    void write(const ReportTable& table) {
        out_ += "<div class=\"scroll\">\n<table>\n<caption>Table " + std::to_string(++tables_) + ". " +
                xmlText(table.caption) + ".</caption>\n<thead>\n<tr>";
        for (const ReportColumn& column : table.columns)
            out_ += "<th scope=\"col\"" + classOf(column) + ">" + xmlText(column.title) + "</th>";
        out_ += "</tr>\n</thead>\n<tbody>\n";
        for (const std::vector<std::string>& row : table.rows) {
            out_ += "<tr>";
            for (std::size_t c = 0; c < row.size(); ++c)
                out_ += "<td" + classOf(table.columns[c]) + ">" + xmlText(row[c]) + "</td>";
            out_ += "</tr>\n";
        }
        out_ += "</tbody>\n</table>\n</div>\n";
    }

    void write(const ReportFigure& figure) {
        const std::string caption = "Figure " + std::to_string(++figures_) + ". " + xmlText(figure.caption) + ".";
        out_ += "<figure>\n<img src=\"" + dataAddress(figure.svg, "image/svg+xml") + "\" width=\"" +
                std::to_string(std::lround(figure.width * 96.0 / 25.4)) + "\" height=\"" +
                std::to_string(std::lround(figure.height * 96.0 / 25.4)) + "\" alt=\"" + xmlText(figure.caption) +
                "\">\n<figcaption>" + caption + "</figcaption>\n</figure>\n";
    }

    const ReportDocument& document_;
    std::string out_;
    int tables_ = 0, figures_ = 0;
};

}  // namespace

std::string reportHtml(const ReportDocument& document) { return HtmlWriter(document).write(); }

}  // namespace keyblock
