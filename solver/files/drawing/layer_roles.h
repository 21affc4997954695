// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/files/drawing/section_import.h"

namespace keyblock {

/// The role suggested by the name of a layer, in several languages; none if the name suggests none.
std::optional<LayerRole> guessedRole(std::string_view layer);

/// Roles of all layers that contain lines; `ImportedLayer::source` shows which roles were guessed. A single error lists
/// all layers whose role is neither given nor guessed. A role given for a layer that is not in the drawing is an error.
/// Layers that are frozen or off are ignored unless a role is given for them by name.
std::vector<ImportedLayer> layerRoles(const Drawing& drawing, const ImportSettings& settings,
                                      std::vector<Problem>& problems);

}  // namespace keyblock
