// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The header of the Properties panel for several objects.
#pragma once

#include "solver/scene/scene.h"

#include <QString>

#include <string>
#include <vector>

namespace keyblock {

struct SelectionTitle {
    QString title;  // "3 bolts"; "8 objects" of several kinds
    QString detail;  // the effect of edits, or the number of objects of each kind
};

/// \pre several pointers.
SelectionTitle selectionTitle(const Scene& scene, const std::vector<std::string>& pointers);

}  // namespace keyblock
