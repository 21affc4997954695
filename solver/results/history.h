// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the values of a history row are, derived from the scene alone: all code that fills a
// row, prints it or reads a quantity from it uses this.
#pragma once

#include "solver/results/results.h"
#include "solver/scene/quantity_text.h"

namespace keyblock {

/// Names every value of a history row: the monitors' as the history table prints them, then one for each
/// quantity of every bolt.
HistoryColumns historyColumns(const Scene& scene);

/// Position in a history row of what a quantity reads.
int historyColumn(const Scene& scene, const Subject& subject);

}  // namespace keyblock
