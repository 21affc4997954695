// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `report`: writes the report of a run as PDF or HTML.
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
#include "solver/files/run_store/stored_scene.h"
#include "solver/files/sha256.h"
#include "solver/files/text_file.h"
#include "solver/verify/verification_record.h"
#include "ui/figure/figure.h"
#include "ui/report/report.h"
#include "ui/report/report_html.h"
#include "ui/report/report_pdf.h"
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

std::string reportCommand(const ReportOptions& options) {
    std::string text = "keyblock report " + quotedWord(options.run.string()) + " --out " +
                       quotedWord(options.out.string());
    if (options.layout) text += " --template " + quotedWord(options.layout->string());
    if (!options.project.empty()) text += " --project " + quotedWord(options.project);
    if (!options.author.empty()) text += " --author " + quotedWord(options.author);
    if (!options.date.empty()) text += " --date " + quotedWord(options.date);
    return text;
}

/// Reads the template and its logo into the request, and adds both to the inputs.
void takeTemplate(const std::filesystem::path& path, ReportRequest& request) {
    const std::string text = readTextFile(path, {longestTemplate, "give the name of a text file", "shorten its texts"});
    TemplateReading reading = readTemplate(text);
    if (!reading.layout) throw CannotRead("cannot use " + path.string() + ": " + reading.problem);
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

ReportRequest requestOf(const ReportOptions& options, const RunStore& store) {
    ReportRequest request;
    request.project = options.project;
    request.author = options.author;
    request.date = options.date;
    request.given = storedScene(options.run);
    request.runName = options.run.filename().string();
    request.program = "Keyblock " + std::string(programVersion()) + ", build " + std::string(buildId());
    request.runProgram = "Keyblock " + store.programVersion();
    request.verification = verificationStatement(readVerificationRecord(verificationRecordPath()));
    request.inputs = {{"scene", "in the run store, as JSON with its records", store.sceneHash()},
                      {"run store", request.runName, sha256OfFile(options.run)}};
    if (options.layout) takeTemplate(*options.layout, request);
    request.commands = {"keyblock run SCENE.json --out " + quotedWord(options.run.string()), reportCommand(options)};
    return request;
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
    const RunStore store(options.run);
    warnOfMissingResults(store, options.run);
    const ReportRequest request = requestOf(options, store);
    try {
        const ReportDocument document = reportOf(store, request);
        const std::string bytes = ending == ".pdf" ? reportPdf(document) : reportHtml(document);
        writeAtomically(options.out, [&](std::ostream& out) { out << bytes; });
    } catch (const CannotDraw& problem) {
        throw CannotRead("cannot draw the report: " + std::string(problem.what()));
    }
    return Done;
#endif
}

}  // namespace keyblock::cli
