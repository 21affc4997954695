// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lists are converted to metres when they are read, and their columns show what they
// contain.
#include "solver/files/drawing/csv_list.h"
#include "solver/files/drawing/dxf_entities.h"
#include "solver/files/drawing/dxf_file.h"
#include "solver/files/read_error.h"
#include "solver/files/drawing/section_import.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

namespace keyblock {

namespace {

std::string contentOf(const std::filesystem::path& path) {
    constexpr std::uintmax_t longest = std::uintmax_t{512} << 20;
    errno = 0;
    std::ifstream file(path, std::ios::binary);
    std::error_code error;
    if (!file || std::filesystem::is_directory(path, error))
        throw CannotRead("cannot read " + path.string() + ": " + std::strerror(errno != 0 ? errno : EISDIR) +
                         "; give the name of a DXF or CSV file");
    if (std::filesystem::is_regular_file(path, error) && std::filesystem::file_size(path, error) > longest)
        throw CannotRead("cannot read " + path.string() + ": it is larger than 512 MB; export only the section");
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

Import importFile(const std::filesystem::path& path, const ImportSettings& settings) {
    const std::string text = contentOf(path);
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
