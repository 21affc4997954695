// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far the points of a trade are from its reference, how regularly they approach it,
// and which of them are worth their time.
#pragma once

#include "solver/trade/convergence.h"
#include "solver/trade/trade.h"

namespace keyblock {

/// Whether a quantity is a verdict or a number of events, which does not converge but is right or wrong.
bool isCounted(const std::string& quantity);

/// Error of quantity q at a point against the reference: relative to the reference, or absolute if that is 0; for an
/// order, the share of bolts, joints or blocks that are missing or out of order. None for the energy balance error, which is
/// an error itself, and if only one of the two has a value. 0 if neither has one.
std::optional<double> errorOf(const TradePoint& point, const TradePoint& reference,
                              const std::vector<std::string>& quantities, std::size_t q);

/// Largest error over all quantities. Infinite if a run failed or a quantity has a value at only one of the two points.
double largestError(const TradePoint& point, const TradePoint& reference, const std::vector<std::string>& quantities);

/// Convergence of quantity q along an axis; unknown if fewer than three of its finest settings have a number.
ConvergenceOrder convergenceOrder(const Trade& trade, const std::string& axis, std::size_t q);

/// How far the reference itself may be off because quantity q does not converge regularly: the scatters along all axes
/// together, relative to the reference, or absolute if that is 0. The error of a point is known to within this. 0 if
/// the quantity is regular, or unaffected, or its convergence is unknown.
double scatterOf(const Trade& trade, std::size_t q);

/// Whether no other point is both faster and closer to the reference.
bool isOnFront(const Trade& trade, std::size_t point);

/// The fastest point with an error of at most `most`; −1 if there is none. The reference is never recommended: its own
/// error is unknown.
int recommendedPoint(const Trade& trade, double most);

/// Whether a run took less time than that with the scene's own settings, by more than times vary from run to run, and not
/// by chance: it did less work, solved for fewer unknowns, or is on an axis that changes the time alone.
bool isCheaper(const TradePoint& point, const TradePoint& own);

/// Whether the point was measured with a preset, the scene's own included.
bool isPreset(const TradePoint& point);

/// The fastest preset with an error of at most `most`, the scene's own unless another is cheaper; −1 if there is none. The
/// reference is never recommended.
int recommendedPreset(const Trade& trade, double most);

/// Why none of the settings is recommended, as part of a sentence.
std::string withoutRecommendation(const Trade& trade, double most);

/// One sentence on a point, to quote: how much faster than the scene's own settings, for a preset by the name of the
/// scene's own, and the largest errors, with their scatter where they are not regular.
std::string sentenceOn(const Trade& trade, std::size_t point);

/// What the point is called in tables, e.g. "divisions 60".
std::string nameOf(const TradePoint& point);

}  // namespace keyblock
