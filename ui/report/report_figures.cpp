// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/report_figures.h"

#include "solver/results/result_names.h"
#include "ui/figure/section_figure.h"
#include "ui/picture/captions.h"

#include <charconv>

namespace keyblock::report {

namespace {

constexpr double figureWidth = 166.0;  // as wide as the text of an A4 page [mm]

/// The value of `width="166mm"` in the head of an SVG file; 0 if there is none.
double millimetresOf(const std::string& svg, const std::string& attribute) {
    const std::string begin = " " + attribute + "=\"";
    const std::size_t at = svg.find(begin);
    double value = 0.0;
    if (at != std::string::npos) std::from_chars(svg.data() + at + begin.size(), svg.data() + svg.size(), value);
    return value;
}

std::string frameText(const Facts& facts, std::size_t index) {
    const FrameHead& head = facts.run.frames()[index];
    const bool moves = facts.scene().stages[head.stage].kind == StageKind::Dynamic;
    return stageTitle(facts.scene(), head.stage) + (moves ? " at " : " at pseudo-time ") +
           timeText(facts.scene(), head.stage, head.time);
}

FigureRequest sectionAt(const Facts& facts, std::size_t index) {
    const FrameHead& head = facts.run.frames()[index];
    FigureRequest request;
    request.kind = FigureKind::Section;
    request.filter.stage = head.stage;
    request.filter.when = When::At;
    request.filter.time = head.time;
    request.filter.events = head.events;
    return request;
}

}  // namespace

void addFigure(const Facts& facts, FigureRequest request, const std::string& caption, ReportSection& section) {
    request.format = PaperFormat::Svg;
    request.width = figureWidth;
    request.runName = facts.request.runName;
    try {
        std::string bytes;
        const auto paint = [&] { bytes = paintFigure(facts.run, request).bytes; };
        if (facts.request.draw && hasCharts(request.kind)) facts.request.draw(paint);
        else paint();
        addSvg(bytes, caption, section);
    } catch (const CannotDraw& problem) {
        addText(section, caption + ": not drawn, because " + problem.what() + ".");
    }
}

void addSvg(const std::string& svg, const std::string& caption, ReportSection& section) {
    section.parts.emplace_back(
        ReportFigure{caption, svg, millimetresOf(svg, "width"), millimetresOf(svg, "height")});
}

void addSectionFigures(const Facts& facts, ReportSection& section) {
    if (facts.run.frames().empty()) return addText(section, "The run has no frames yet.");
    const std::size_t last = facts.run.frames().size() - 1;
    FigureRequest before = sectionAt(facts, 0), after = sectionAt(facts, last);
    before.quantity = before.boltQuantity = plainWord;
    before.window = after.window = sectionPicture(facts.run, sectionRequestOf(facts.run, after)).window;
    addFigure(facts, before, "Section before: " + frameText(facts, 0), section);
    if (last > 0) addFigure(facts, after, "Section after: " + frameText(facts, last), section);
}

void addCurves(const Facts& facts, ReportSection& section) {
    FigureRequest request;
    request.kind = FigureKind::Curves;
    addFigure(facts, request, "Curves of the run", section);
}

}  // namespace keyblock::report
