// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The header of the Properties panel if several objects are selected.
#pragma once

#include "solver/scene/scene.h"

#include <QString>

#include <string>
#include <vector>

namespace keyblock {

struct SelectionTitle {
    QString title;  // "3 bolts", or "8 objects" if they are of several kinds
    QString detail;  // what an edit will change, or the number of objects of each kind
};

/// Title and detail for a selection of the objects at `pointers`. \pre there are at least two pointers.
SelectionTitle selectionTitle(const Scene& scene, const std::vector<std::string>& pointers);

}  // namespace keyblock
