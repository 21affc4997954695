// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The columns of a history row, derived from the scene alone. All code that fills a
// row, prints it or reads a quantity from it uses them.
#pragma once

#include "solver/results/results.h"
#include "solver/scene/quantity_text.h"

namespace keyblock {

/// Names of the columns of the history: first the columns of the monitors, as printed in the history table, then one
/// column for each quantity of every bolt.
HistoryColumns historyColumns(const Scene& scene);

/// Index in `historyColumns(scene).names` of the column that records the values of `subject`; of a magnitude, that of ux,
/// which uy follows.
int historyColumn(const Scene& scene, const Subject& subject);

/// The value of `subject` in a row, whose column is `column`. NaN if the row has none.
double valueIn(const HistoryRow& row, const Subject& subject, int column);

}  // namespace keyblock
