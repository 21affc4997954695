// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/fuzz/drawing_property.h"

#include "solver/files/drawing/csv_list.h"
#include "solver/files/drawing/dxf_entities.h"
#include "solver/files/drawing/dxf_file.h"
#include "solver/files/drawing/section_import.h"

#include <algorithm>

namespace keyblock {
namespace {

std::string brokenImport(const Import& import) {
    if (hasErrors(import.problems) == import.scene.has_value())
        return import.scene ? "a scene beside an error" : "neither a scene nor an error";
    for (const Problem& problem : import.problems)
        if (problem.message.empty() || (problem.severity == Severity::Error && problem.remedy.empty()))
            return "a problem without a message or a remedy";
    for (const NotTaken& item : import.notTaken)
        if (item.why.empty() || item.place.line < 1) return "something was not taken without a reason or a line";
    return {};
}

std::size_t accountedFor(const Import& import) {
    std::size_t count = 0;
    for (const ImportRow& row : import.rows) count += static_cast<std::size_t>(row.count);
    return count;
}

ImportSettings everythingIsAJoint() {
    ImportSettings settings;
    settings.roles = {{"*", LayerRole::Joint}};
    settings.unit = lengthUnitOf("m");
    return settings;
}

}  // namespace

std::string brokenDrawingProperty(std::string_view bytes) {
    const Import drawn = importSection(readDxf(bytes), everythingIsAJoint(), "drawing");
    if (std::string broken = brokenImport(drawn); !broken.empty()) return broken;
    const DxfGroups groups = readDxfGroups(bytes);
    if (drawn.scene && accountedFor(drawn) < sortDxf(groups).entities.size()) return "an entity is not accounted for";
    Drawing list = readCsvList(bytes, "list", lengthUnitOf("m"));
    const std::size_t rows = list.lines.size();
    ImportSettings settings;
    settings.roles = {{"*", LayerRole::Joint}};
    const Import listed = importSection(std::move(list), settings, "list");
    if (listed.scene && accountedFor(listed) != rows) return "a row is not accounted for";
    return brokenImport(listed);
}

}  // namespace keyblock
