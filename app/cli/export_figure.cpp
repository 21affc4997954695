// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/export_figure.h"

#include "app/cli/figure_words.h"
#include "app/cli/output.h"
#include "app/cli/output_files.h"
#include "solver/files/scene/reference_file.h"
#include "solver/files/atomic_file.h"

#ifdef KEYBLOCK_HAS_FIGURES
#include "ui/figure/figure.h"
#endif

#include <algorithm>
#include <array>
#include <cassert>
#include <fstream>
#include <iterator>
#include <sstream>

namespace keyblock::cli {

namespace {

constexpr std::array<std::string_view, 3> endings{".svg", ".pdf", ".png"};  // in the order of `PaperFormat`

/// Index of the figure's kind in `figureWords`.
std::size_t kindOf(const ExportOptions& options) {
    const auto words = figureWords();
    const auto found = std::find(words.begin(), words.end(), *options.figure);
    if (found != words.end())
        return found - words.begin();
    std::string names;
    for (const std::string_view word : words)
        names += (names.empty() ? "" : ", ") + std::string(word);
    throw UsageError("there is no figure '" + *options.figure + "'; there are " + names);
}

/// Index of the format that belongs to the file's extension.
std::size_t formatOf(const ExportOptions& options) {
    const auto found = std::find(endings.begin(), endings.end(), options.out.extension().string());
    if (found == endings.end())
        throw UsageError("'" + options.out.string() + "': a figure is written as .svg, .pdf or .png");
    return found - endings.begin();
}

}  // namespace

void checkFigureOptions(const ExportOptions& options) {
#ifndef KEYBLOCK_HAS_FIGURES
    throw UsageError("this program was built without figures; build it with Qt 5 and QCustomPlot, or export tables");
#endif
    kindOf(options);
    if (const std::size_t format = formatOf(options); options.dpi && endings[format] != ".png")
        throw UsageError("--dpi applies to PNG only; " + std::string(endings[format]) +
                         " is vector graphics; omit it");
    if (options.at == "all")
        throw UsageError("a figure shows one frame; give --at STAGE:TIME or last");
}

#ifdef KEYBLOCK_HAS_FIGURES

namespace {

void tell(const std::vector<Problem>& problems) {
    for (const Problem& problem : problems) printToError(oneLine(problem) + '\n');
}

/// Reads all reference files and reports all problems. \return false if a file cannot be used.
bool readReferences(const ExportOptions& options, FigureRequest& request) {
    bool usable = true;
    for (const std::filesystem::path& file : options.references) {
        ReferenceReading reading = readReferenceFile(file);
        tell(reading.problems);
        usable = usable && !hasErrors(reading.problems);
        request.references.push_back(std::move(reading.table));
    }
    return usable;
}

/// A file with data of the figure, which is written next to it.
struct DataFile {
    std::filesystem::path path;
    std::string text;
};

bool hasText(const DataFile& file) {
    std::error_code error;
    if (!std::filesystem::is_regular_file(file.path, error) ||
        std::filesystem::file_size(file.path, error) != file.text.size())
        return false;
    std::ifstream in(file.path, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(in), {}) == file.text;
}

/// The data of the figure, without those that are in their file already: SVG, PDF and PNG of one figure share them.
std::vector<DataFile> dataFiles(const Figure& figure, const std::filesystem::path& out) {
    std::vector<DataFile> files;
    for (const FigureData& data : figure.data) {
        std::ostringstream text;
        data.write(text);
        files.push_back({out.parent_path() / (out.stem().string() + data.suffix + ".csv"), text.str()});
    }
    std::erase_if(files, hasText);
    return files;
}

/// Writes the figure and its data, or nothing if one of the files must not be replaced.
ExitCode writeFiles(const ExportOptions& options, const Figure& figure) {
    const std::vector<DataFile> data = dataFiles(figure, options.out);
    std::vector<OutputFile> files{{options.out}};
    for (const DataFile& file : data) files.push_back({file.path, options.overwrite});
    std::vector<std::filesystem::path> sources = options.references;
    sources.push_back(options.run);
    if (!mayBeWritten(files, sources)) return Usage;
    writeAtomically(options.out, [&](std::ostream& out) { out << figure.bytes; });
    for (const DataFile& file : data) writeAtomically(file.path, [&](std::ostream& out) { out << file.text; });
    tell(figure.warnings);
    return Done;
}

}  // namespace

ExitCode exportFigure(const ExportOptions& options, const RunSource& run, const TableFilter& filter) {
    assert(options.figure);
    FigureRequest request;
    request.kind = static_cast<FigureKind>(kindOf(options));
    request.format = static_cast<PaperFormat>(formatOf(options));
    request.filter = filter;
    request.quantity = options.quantity;
    request.width = options.width.value_or(request.width);
    request.dpi = options.dpi.value_or(request.dpi);
    request.factor = options.deformed.value_or(request.factor);
    request.whole = options.whole;
    request.runName = options.run.stem().string();
    if (!readReferences(options, request))
        return Invalid;
    try {
        return writeFiles(options, paintFigure(run, request));
    } catch (const CannotDraw& problem) {
        throw UsageError(problem.what());
    }
}

#else

ExitCode exportFigure(const ExportOptions& options, const RunSource&, const TableFilter&) {
    checkFigureOptions(options);
    return Usage;
}

#endif

}  // namespace keyblock::cli
