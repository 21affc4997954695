// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Connects panels and runs, which are independent of each other: the scene tree lists
// the runs of the scene, the model summary is not computed during a run, and the
// Properties panel starts with the results.
#pragma once

namespace keyblock {

class ResultCard;
class Runs;
struct Panels;

void showRunsIn(const Panels& panels, Runs& runs);

/// Shows the results of the selected bolt or block in the Properties panel, above the fields.
void showResultsIn(const Panels& panels, ResultCard& results);

}  // namespace keyblock
