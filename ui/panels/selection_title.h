// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the header of the property panel says of several objects.
#pragma once

#include "solver/scene/scene.h"

#include <QString>

#include <string>
#include <vector>

namespace keyblock {

struct SelectionTitle {
    QString title;  // "3 bolts"; "8 objects" of several kinds
    QString detail;  // what edits do, or how many objects there are of each kind
};

/// \pre several pointers.
SelectionTitle selectionTitle(const Scene& scene, const std::vector<std::string>& pointers);

}  // namespace keyblock
