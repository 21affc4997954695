// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Converts a drawing to a scene. The roles of layers are given, or guessed from their
// names and reported. Data that a drawing does not contain (materials, gravity, a
// missing boundary) are assumed, named accordingly and reported. Every entity is
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
    std::vector<std::pair<std::string, LayerRole>> roles;  // by layer; `*`: every layer without a role
    const UnitSymbol* unit = nullptr;  // length unit of the file; null: the one given in the file
    std::optional<double> sagitta;  // largest deviation from curves [m]; null: 5e-4 of the drawing's longer side
};

struct ImportedLayer {
    std::string name;
    LayerRole role = LayerRole::Ignore;
    bool known = true;  // whether the role is known
    std::string source;  // source of the role for messages: given, guessed from its name, frozen or off, …
};

/// Number of entities of the kind `kind` on the layer `layer` that became scene objects of the type `became`.
struct ImportRow {
    std::string kind;
    std::string layer;
    std::string became;
    int count = 0;
};

struct Import {
    std::optional<Scene> scene;  // a valid scene; present if no problem is an error
    std::optional<SceneCut> cut;  // result of cutting the scene
    std::string unit;
    std::vector<ImportedLayer> layers;  // layers with lines, sorted by name
    std::vector<ImportRow> rows;  // sorted by kind, layer and `became`
    std::vector<NotTaken> notTaken;  // sorted by line
    std::vector<std::string> assumed;
    std::vector<Problem> problems;
};

/// Makes a scene from a drawing.
/// \param name the file name of the drawing.
Import importSection(Drawing drawing, const ImportSettings& settings, const std::string& name);

/// Makes a scene from a file. The file is read as a list of joints or bolts if its name ends in `.csv`, otherwise as a
/// DXF drawing.
/// \throws CannotRead if it is not a regular file of at most 512 MB that can be opened.
Import importFile(const std::filesystem::path& path, const ImportSettings& settings);

}  // namespace keyblock
