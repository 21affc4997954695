// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lists are converted to metres when they are read, and their columns show what they
// contain.
#include "solver/files/drawing/csv_list.h"
#include "solver/files/drawing/dxf_entities.h"
#include "solver/files/drawing/dxf_file.h"
#include "solver/files/drawing/section_import.h"
#include "solver/files/text_file.h"

namespace keyblock {

namespace {

const TextFileLimits drawingLimits{std::uint64_t{512} << 20, "give the name of a DXF or CSV file",
                                   "export only the section"};

}  // namespace

Import importFile(const std::filesystem::path& path, const ImportSettings& settings) {
    const std::string text = readTextFile(path, drawingLimits);
    if (lowerCase(path.extension().string()) != ".csv") {
        Drawing drawing = readDxf(text);
        const UnitSymbol* unit = settings.unit ? settings.unit : drawing.unit;
        if (settings.sagitta && unit) drawing = readDxf(text, fromSi(*settings.sagitta, unit->unit));
        return importSection(std::move(drawing), settings, path.string());
    }
    Drawing drawing = readCsvList(text, path.stem().string(), settings.unit);
    ImportSettings own = settings;
    own.unit = nullptr;  // the drawing is already in metres
    if (own.roles.empty() && !drawing.lines.empty())
        own.roles = {{drawing.lines.front().layer, *layerRoleOf(drawing.lines.front().kind)}};
    Import import = importSection(std::move(drawing), own, path.string());
    if (!import.unit.empty()) import.unit = "by column";
    return import;
}

}  // namespace keyblock
