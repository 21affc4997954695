// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// From a drawing to a scene. Layers are given roles, or roles are guessed from
// their names and reported; what a drawing does not contain (materials, gravity, a missing
// boundary) is assumed, bears a name that shows it, and is reported. Every entity is
// accounted for.
#pragma once

#include "solver/files/drawing/drawing.h"
#include "solver/files/scene/scene_file.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace keyblock {

enum class LayerRole { Joint, Boundary, Tunnel, Bolt, Ignore };

std::string_view wordOf(LayerRole role);  // joint, boundary, tunnel, bolt, ignore
std::optional<LayerRole> layerRoleOf(std::string_view word);

struct ImportSettings {
    std::vector<std::pair<std::string, LayerRole>> roles;  // by layer; `*`: every layer that has none
    const UnitSymbol* unit = nullptr;  // null: the one that the file says
    std::optional<double> sagitta;  // of curves [m]; null: 5e-4 of the drawing's longer side
};

struct ImportedLayer {
    std::string name;
    LayerRole role = LayerRole::Ignore;
    bool known = true;
    std::string source;  // of the role, for people: given, guessed from its name, frozen or off
};

/// How many entities of a kind and layer became what.
struct ImportRow {
    std::string kind;
    std::string layer;
    std::string became;
    int count = 0;
};

struct Import {
    std::optional<Scene> scene;  // there when no problem is an error: it reads and checks
    std::optional<SceneCut> cut;  // what it is cut to
    std::string unit;
    std::vector<ImportedLayer> layers;  // with lines, by name
    std::vector<ImportRow> rows;  // by kind, layer and what became of them
    std::vector<NotTaken> notTaken;  // by line
    std::vector<std::string> assumed;
    std::vector<Problem> problems;
};

/// Makes a scene of a drawing; `name` is the file's.
Import importSection(Drawing drawing, const ImportSettings& settings, const std::string& name);

/// The same from a file: `.csv` is a list, anything else a DXF. \throws CannotRead where it cannot be opened.
Import importFile(const std::filesystem::path& path, const ImportSettings& settings);

}  // namespace keyblock
