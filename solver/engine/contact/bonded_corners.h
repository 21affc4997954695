// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where four or more blocks meet at a point, some of them share only that corner and
// no face. As long as bonds connect them through the other blocks at that point, they
// need no contact of their own. A contact between the two corners would be an extra
// spring that acts in compression only and would make the stiffness of intact rock
// non-uniform.
#pragma once

#include "solver/engine/model/state.h"

#include <vector>

namespace keyblock {

/// Removes each contact that carries no force and whose two blocks are connected, directly or through other blocks, by
/// bonds at the contact's position in the original scene (theory, "Contacts"). The order of the remaining contacts is
/// kept.
void dropHeldCorners(const Model& model, std::vector<Contact>& contacts);

}  // namespace keyblock
