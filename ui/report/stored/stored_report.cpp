// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/stored/stored_report.h"

#include "solver/files/program_version.h"
#include "solver/files/read_error.h"
#include "solver/files/run_store/build_id.h"
#include "solver/files/run_store/run_store.h"
#include "solver/files/run_store/stored_estimate.h"
#include "solver/files/run_store/stored_scene.h"
#include "solver/files/sha256.h"
#include "solver/files/text_file.h"
#include "solver/study/case_run.h"
#include "solver/study/sweep_results.h"
#include "solver/verify/verification_record.h"
#include "ui/report/report_html.h"
#include "ui/report/report_pdf.h"
#include "ui/report/study_report.h"

#include <algorithm>

namespace keyblock {

namespace {

constexpr std::uint64_t longestTemplate = std::uint64_t{1} << 20, longestLogo = std::uint64_t{20} << 20;  // [bytes]

/// The word as it is typed in a shell.
std::string shellWord(const std::string& word) {
    const bool plain = !word.empty() && word.find_first_not_of(
                                            "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                            "0123456789_-+=./,:@%") == std::string::npos;
    if (plain) return word;
    std::string text = "'";
    for (const char c : word) text += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return text + "'";
}

/// Name of a file or folder without the folders that contain it.
std::string nameOf(const std::filesystem::path& path) {
    return path.has_filename() ? path.filename().string() : path.parent_path().filename().string();
}

std::string reportCommand(const ReportOrder& order) {
    std::string text = "keyblock report " + shellWord(order.source.string()) + " --out " +
                       shellWord(order.out.string());
    if (order.layout) text += " --template " + shellWord(order.layout->string());
    if (!order.project.empty()) text += " --project " + shellWord(order.project);
    if (!order.author.empty()) text += " --author " + shellWord(order.author);
    if (!order.date.empty()) text += " --date " + shellWord(order.date);
    return text;
}

/// \throws CannotRead if a section of the template does not apply to reports of this kind.
void requireSections(const std::filesystem::path& path, const ReportTemplate& layout, ReportKind kind) {
    for (const TemplateSection& section : layout.sections) {
        const ReportContentRow& row = rowOf(section.content);
        if (appliesTo(row, kind)) continue;
        throw CannotRead("cannot use " + path.string() + ": the section '" + std::string(row.word) + "' applies to " +
                         (kind == ReportKind::Run ? "studies" : "runs") + " only; remove it");
    }
}

/// Reads the template and its logo into the request, and adds both to the inputs.
void takeTemplate(const std::filesystem::path& path, ReportKind kind, ReportRequest& request) {
    const std::string text = readTextFile(path, {longestTemplate, "give the name of a text file", "shorten its texts"});
    TemplateReading reading = readTemplate(text);
    if (!reading.layout) throw CannotRead("cannot use " + path.string() + ": " + reading.problem);
    requireSections(path, *reading.layout, kind);
    request.layout = std::move(*reading.layout);
    request.inputs.push_back({"template", path.filename().string(), sha256(text)});
    if (request.layout.logo.empty()) return;
    const std::filesystem::path logo = path.parent_path() / request.layout.logo;
    ReportLogo picture{
        readTextFile(logo, {longestLogo, "name a PNG, JPEG or SVG file in the template", "use a smaller one"}), ""};
    picture.mediaType = mediaTypeOf(picture.bytes);
    if (picture.mediaType.empty())
        throw CannotRead("cannot use " + logo.string() +
                         ": it is not PNG, JPEG or SVG; name another logo in the template");
    request.inputs.push_back({"logo", logo.filename().string(), sha256(picture.bytes)});
    request.logo = std::move(picture);
}

/// What the reports of runs and of studies have in common.
ReportRequest requestOf(const ReportOrder& order, ReportKind kind) {
    ReportRequest request;
    request.layout = defaultTemplate(kind);
    request.project = order.project;
    request.author = order.author;
    request.date = order.date;
    request.runName = nameOf(order.source);
    request.program = "Keyblock " + std::string(programVersion()) + ", build " + std::string(buildId());
    request.verification = verificationStatement(readVerificationRecord(verificationRecordPath()));
    request.progress = order.progress;
    request.draw = order.draw;
    return request;
}

ReportDocument runReport(const RunStore& store, const ReportOrder& order) {
    ReportRequest request = requestOf(order, ReportKind::Run);
    request.given = storedScene(order.source);
    request.estimate = storedEstimate(order.source);
    request.runProgram = "Keyblock " + store.programVersion();
    request.inputs = {{"scene", "in the run store, as JSON with its records", store.sceneHash()},
                      {"run store", request.runName, sha256OfFile(order.source)}};
    if (order.layout) takeTemplate(*order.layout, ReportKind::Run, request);
    request.commands = {"keyblock run SCENE.json --out " + shellWord(order.source.string()), reportCommand(order)};
    return reportOf(store, request);
}

/// The figures that `sweep collect` wrote, in order of their names.
std::vector<StudyFigure> collectedFigures(const std::filesystem::path& study) {
    std::vector<std::filesystem::path> files;
    std::error_code none;  // a study without figures
    for (const auto& entry : std::filesystem::directory_iterator(study / "figures", none))
        if (entry.path().extension() == ".svg") files.push_back(entry.path());
    std::ranges::sort(files);
    std::vector<StudyFigure> figures;
    for (const std::filesystem::path& file : files)
        figures.push_back({file.stem().string(),
                           readTextFile(file, {longestLogo, "collect the study again", "collect the study again"})});
    return figures;
}

ReportDocument studyReport(const ReportOrder& order) {
    const Sweep sweep = openSweep(order.source);
    const SweepResults results = collectResults(sweep, sweepRunOf(sweep, 1).quantities);
    ReportRequest request = requestOf(order, ReportKind::Study);
    request.inputs = {{"scene", sweepSceneName, sweep.plan.sceneHash},
                      {"study", sweepStudyName, sweep.plan.studyHash},
                      {"cases", sweepCasesName, sweep.plan.casesHash}};
    if (order.layout) takeTemplate(*order.layout, ReportKind::Study, request);
    const std::string folder = shellWord(order.source.string());
    const std::string all = std::to_string(sweep.plan.cases);
    request.commands = {"keyblock sweep plan STUDY.json --out " + folder,
                        "keyblock sweep run " + folder + " --index 1-" + all, "keyblock sweep collect " + folder,
                        reportCommand(order)};
    return studyReportOf(sweep, results, collectedFigures(order.source), request);
}

std::string warningOf(const RunStore& store, const std::filesystem::path& path) {
    if (!store.mayLackResults()) return {};
    return path.string() + ": the latest results may be missing, because the run did not end and the file " +
           path.filename().string() + "-wal is not next to it; copy both files together";
}

}  // namespace

ReportFile reportFile(const ReportOrder& order) {
    ReportFile file;
    ReportDocument document;
    if (std::filesystem::is_directory(order.source)) {
        document = studyReport(order);
    } else {
        const RunStore store(order.source);
        file.warning = warningOf(store, order.source);
        document = runReport(store, order);
    }
    if (order.progress) order.progress("", 1.0);
    file.bytes = order.out.extension() == ".pdf" ? reportPdf(document) : reportHtml(document);
    return file;
}

}  // namespace keyblock
