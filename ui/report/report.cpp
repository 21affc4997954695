// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/report.h"

#include "solver/results/result_names.h"
#include "solver/results/settled_blocks.h"
#include "solver/scene/number_text.h"
#include "solver/scene/units.h"
#include "ui/report/report_facts.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace keyblock {

namespace report {

Facts::Facts(const RunSource& source, const ReportRequest& wanted)
    : run(source), request(wanted), stages(source.stages()), events(source.events()),
      verdict(verdictOf(stages, source.scene())), settled(settledBlocks(source, verdict)) {
    if (!run.frames().empty()) designs = boltDesigns(run, run.frames().size() - 1);
}

std::string Facts::block(int index) const { return blockName(run.blockNames(), index); }

namespace {

constexpr std::array<const char*, 10> raisedDigits{"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};

/// "·10⁻⁵" for "-05".
std::string powerText(const std::string& exponent) {
    const int value = std::stoi(exponent);
    std::string text = value < 0 ? "·10⁻" : "·10";
    for (const char digit : std::to_string(std::abs(value))) text += raisedDigits.at(digit - '0');
    return text;
}

}  // namespace

std::string numeral(double value) {
    const std::string text = rounded(value == 0.0 ? 0.0 : value);  // not -0
    const std::size_t e = text.find('e');
    if (e == std::string::npos) return text;
    if (std::abs(value) >= 1e3 && std::abs(value) < 1e9) return std::to_string(std::llround(std::stod(text)));
    return text.substr(0, e) + powerText(text.substr(e + 1));
}

std::string inUnit(double value, std::string_view unit) {
    const std::optional<Unit> known = readUnit(unit);
    return numeral(known ? fromSi(value, *known) : value);
}

std::string percentText(double share) { return numeral(std::round(1000.0 * share) / 10.0); }

void addText(ReportSection& section, const std::string& text, ReportTextKind kind) {
    section.parts.emplace_back(ReportText{text, kind});
}

void addTable(ReportSection& section, ReportTable table) {
    if (!table.rows.empty()) section.parts.emplace_back(std::move(table));
}

namespace {

void addInputs(const ReportRequest& request, ReportSection& section) {
    ReportTable table{"Inputs with their SHA-256 hashes", {{"Input"}, {"Name"}, {"SHA-256"}}, {}};
    for (const ReportInput& input : request.inputs) table.rows.push_back({input.what, input.name, input.hash});
    addTable(section, std::move(table));
}

void addCommands(const ReportRequest& request, ReportSection& section) {
    addText(section,
            "These commands make the results and this report again, with the same numbers on the same build of the "
            "program. SCENE.json and STUDY.json are the files whose hashes are given among the inputs ('keyblock info' "
            "prints the hash of the scene of a run).");
    for (const std::string& command : request.commands) addText(section, command, ReportTextKind::Command);
}

void addContent(const Facts& facts, ReportContent content, ReportSection& section) {
    switch (content) {
        case ReportContent::Summary: return addSummary(facts, section);
        case ReportContent::Sections: return addSectionFigures(facts, section);
        case ReportContent::Model: return addModel(facts, section);
        case ReportContent::Stages: return addStages(facts, section);
        case ReportContent::Numerics: return addNumerics(facts, section);
        case ReportContent::Bolts: return addBolts(facts, section);
        case ReportContent::Events: return addEvents(facts, section);
        case ReportContent::Curves: return addCurves(facts, section);
        case ReportContent::Diagnostics: return addDiagnostics(facts, section);
        default: return addCommonContent(facts.request, content, section);
    }
}

void addFact(ReportDocument& document, const std::string& name, const std::string& value) {
    if (!value.empty()) document.facts.emplace_back(name, value);
}

/// The document without its sections.
ReportDocument titleBlock(const std::string& own, const std::string& what, const ReportRequest& request) {
    ReportDocument document;
    document.title = request.layout.title.empty() ? own : request.layout.title;
    document.logo = request.logo;
    addFact(document, "Project", request.project);
    addFact(document, "Author", request.author);
    addFact(document, "Date", request.date);
    addFact(document, what, own == document.title ? "" : own);
    addFact(document, "Results", request.runName);
    addFact(document, "Run by", request.runProgram);
    addFact(document, "Report by", request.program);
    document.foot =
        (request.project.empty() ? document.title : request.project) + " · Keyblock report of " + request.runName;
    return document;
}

}  // namespace

void addCommonContent(const ReportRequest& request, ReportContent content, ReportSection& section) {
    if (content == ReportContent::Verification) addText(section, request.verification);
    if (content == ReportContent::Inputs) addInputs(request, section);
    if (content == ReportContent::Reproduce) addCommands(request, section);
}

ReportDocument assembled(const std::string& own, const std::string& what, const ReportRequest& request,
                         const std::function<void(ReportContent, ReportSection&)>& add) {
    ReportDocument document = titleBlock(own, what, request);
    const auto count = static_cast<double>(request.layout.sections.size());
    for (const TemplateSection& wanted : request.layout.sections) {
        ReportSection section;
        section.heading = wanted.heading.empty() ? std::string(rowOf(wanted.content).heading) : wanted.heading;
        if (request.progress)
            request.progress(section.heading, static_cast<double>(document.sections.size()) / count);
        for (const std::string& paragraph : wanted.paragraphs) addText(section, paragraph);
        add(wanted.content, section);
        document.sections.push_back(std::move(section));
    }
    return document;
}

}  // namespace report

ReportDocument reportOf(const RunSource& run, const ReportRequest& request) {
    const report::Facts facts(run, request);
    const std::string own = run.scene().title.empty() ? request.runName : run.scene().title;
    return report::assembled(own, "Scene", request, [&facts](ReportContent content, ReportSection& section) {
        report::addContent(facts, content, section);
    });
}

}  // namespace keyblock
