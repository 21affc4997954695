// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Connects panels and runs, which are independent of each other: the scene tree lists
// the runs of the scene, the model summary is not computed during a run and quotes a
// trade, and the Properties panel starts with the results.
#pragma once

namespace keyblock {

class ResultCard;
class Runs;
class TradeRuns;
struct Panels;

void showRunsIn(const Panels& panels, Runs& runs);

/// Quotes a trade in the model summary once its runs have ended.
void quoteTradeIn(const Panels& panels, const TradeRuns& trade);

/// Shows the results of the selected bolt or block in the Properties panel, above the fields.
void showResultsIn(const Panels& panels, ResultCard& results);

}  // namespace keyblock
