// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Where four blocks or more meet at a place, some of them share no face there
// but only a corner. While bonds hold the others together round that place they
// hold these, too: a contact between the two corners would only be one more spring
// that pushes but does not pull, and would make intact rock uneven.
#pragma once

#include "solver/engine/model/state.h"

#include <vector>

namespace keyblock {

/// Takes out the contacts that carry nothing and whose two blocks bonded contacts at the same place, in the scene as it
/// was given, hold together by way of other blocks (theory, "Contacts"). The order of the rest stays.
void dropHeldCorners(const Model& model, std::vector<Contact>& contacts);

}  // namespace keyblock
