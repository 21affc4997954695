// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "solver/files/drawing/section_import.h"

namespace keyblock {

/// The role that a layer's name speaks of, in a few languages; nothing where it speaks of none.
std::optional<LayerRole> guessedRole(std::string_view layer);

/// Gives every layer with lines its role and reports which were guessed, and which could not be: an error that lists
/// them. A given role whose layer the drawing lacks is an error. Layers that are frozen or off are left out unless a
/// role is given for them by name.
std::vector<ImportedLayer> layerRoles(const Drawing& drawing, const ImportSettings& settings,
                                      std::vector<Problem>& problems);

}  // namespace keyblock
