// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/files/drawing/section_import.h"

namespace keyblock {

/// The role suggested by the name of a layer, which may be in one of several languages; none if it suggests none.
std::optional<LayerRole> guessedRole(std::string_view layer);

/// Roles of all layers that contain lines, sorted by name. `ImportedLayer::source` shows which roles were guessed. One
/// error lists all layers whose role is neither given nor guessed. A role given for a layer without entities is an
/// error. Layers that are frozen or off are ignored unless a role is given for them by name.
std::vector<ImportedLayer> layerRoles(const Drawing& drawing, const ImportSettings& settings,
                                      std::vector<Problem>& problems);

}  // namespace keyblock
