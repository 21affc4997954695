// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/export_figure.h"

#include "app/cli/figure_words.h"
#include "app/cli/output.h"
#include "solver/files/scene/reference_file.h"
#include "solver/files/atomic_file.h"

#ifdef KEYBLOCK_HAS_FIGURES
#include "ui/figure/figure.h"
#endif

#include <algorithm>
#include <array>
#include <cassert>

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
        const Figure figure = paintFigure(run, request);
        writeAtomically(options.out, [&](std::ostream& out) { out << figure.bytes; });
        for (const FigureData& data : figure.data) {
            const std::string name = options.out.stem().string() + data.suffix + ".csv";
            writeAtomically(options.out.parent_path() / name, data.write);
        }
        tell(figure.warnings);
    } catch (const CannotDraw& problem) {
        throw UsageError(problem.what());
    }
    return Done;
}

#else

ExitCode exportFigure(const ExportOptions& options, const RunSource&, const TableFilter&) {
    checkFigureOptions(options);
    return Usage;
}

#endif

}  // namespace keyblock::cli
