// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `report`: writes the report of a run or of a study as PDF or HTML.
#include "app/cli/cli_commands.h"
#include "app/cli/output.h"
#include "app/cli/output_files.h"
#include "app/cli/store_warning.h"

#ifdef KEYBLOCK_HAS_FIGURES
#include "solver/files/atomic_file.h"
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
#include "ui/figure/figure.h"
#include "ui/report/report.h"
#include "ui/report/report_html.h"
#include "ui/report/report_pdf.h"
#include "ui/report/study_report.h"

#include <algorithm>
#endif

namespace keyblock::cli {

#ifdef KEYBLOCK_HAS_FIGURES

namespace {

constexpr std::uint64_t longestTemplate = std::uint64_t{1} << 20, longestLogo = std::uint64_t{20} << 20;  // [bytes]

/// The word as it is typed in a shell.
std::string quotedWord(const std::string& word) {
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

std::string reportCommand(const ReportOptions& options) {
    std::string text = "keyblock report " + quotedWord(options.run.string()) + " --out " +
                       quotedWord(options.out.string());
    if (options.layout) text += " --template " + quotedWord(options.layout->string());
    if (!options.project.empty()) text += " --project " + quotedWord(options.project);
    if (!options.author.empty()) text += " --author " + quotedWord(options.author);
    if (!options.date.empty()) text += " --date " + quotedWord(options.date);
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
ReportRequest requestOf(const ReportOptions& options, ReportKind kind) {
    ReportRequest request;
    request.layout = defaultTemplate(kind);
    request.project = options.project;
    request.author = options.author;
    request.date = options.date;
    request.runName = nameOf(options.run);
    request.program = "Keyblock " + std::string(programVersion()) + ", build " + std::string(buildId());
    request.verification = verificationStatement(readVerificationRecord(verificationRecordPath()));
    return request;
}

ReportDocument runReport(const ReportOptions& options) {
    const RunStore store(options.run);
    warnOfMissingResults(store, options.run);
    ReportRequest request = requestOf(options, ReportKind::Run);
    request.given = storedScene(options.run);
    request.estimate = storedEstimate(options.run);
    request.runProgram = "Keyblock " + store.programVersion();
    request.inputs = {{"scene", "in the run store, as JSON with its records", store.sceneHash()},
                      {"run store", request.runName, sha256OfFile(options.run)}};
    if (options.layout) takeTemplate(*options.layout, ReportKind::Run, request);
    request.commands = {"keyblock run SCENE.json --out " + quotedWord(options.run.string()), reportCommand(options)};
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

ReportDocument studyReport(const ReportOptions& options) {
    const Sweep sweep = openSweep(options.run);
    const SweepResults results = collectResults(sweep, sweepRunOf(sweep, 1).quantities);
    ReportRequest request = requestOf(options, ReportKind::Study);
    request.inputs = {{"scene", sweepSceneName, sweep.plan.sceneHash},
                      {"study", sweepStudyName, sweep.plan.studyHash},
                      {"cases", sweepCasesName, sweep.plan.casesHash}};
    if (options.layout) takeTemplate(*options.layout, ReportKind::Study, request);
    const std::string folder = quotedWord(options.run.string());
    const std::string all = std::to_string(sweep.plan.cases);
    request.commands = {"keyblock sweep plan STUDY.json --out " + folder,
                        "keyblock sweep run " + folder + " --index 1-" + all, "keyblock sweep collect " + folder,
                        reportCommand(options)};
    return studyReportOf(sweep, results, collectedFigures(options.run), request);
}

}  // namespace

#endif

ExitCode perform([[maybe_unused]] const ReportOptions& options) {
#ifndef KEYBLOCK_HAS_FIGURES
    throw UsageError(
        "this program was built without figures; build it with Qt 5 and QCustomPlot, or use info and export");
#else
    const std::string ending = options.out.extension().string();
    if (ending != ".pdf" && ending != ".html")
        throw UsageError("'" + options.out.string() + "': a report is written as .pdf or .html");
    std::vector<std::filesystem::path> sources{options.run};
    if (options.layout) sources.push_back(*options.layout);
    const OutputFile file{options.out, options.overwrite};
    if (!mayBeWritten({&file, 1}, sources)) return Usage;
    try {
        const ReportDocument document = std::filesystem::is_directory(options.run) ? studyReport(options)
                                                                                   : runReport(options);
        const std::string bytes = ending == ".pdf" ? reportPdf(document) : reportHtml(document);
        writeAtomically(options.out, [&](std::ostream& out) { out << bytes; });
    } catch (const CannotDraw& problem) {
        throw CannotRead("cannot draw the report: " + std::string(problem.what()));
    }
    return Done;
#endif
}

}  // namespace keyblock::cli
