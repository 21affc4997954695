// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Quantiles of the distributions of a study. A case is found from a number between 0
// and 1 that belongs to it, so that Latin hypercubes and Monte Carlo plans share them.
#pragma once

#include "solver/study/study.h"

namespace keyblock {

/// Quantile of the standard normal distribution (Wichura 1988, AS 241), to about 16 digits. Made of sums, products and
/// square roots only, so that it is the same on every machine. \pre 0 < p < 1
double normalQuantile(double p);

/// Probability that a standard normal variable is below z.
double normalShare(double z);

/// The value below which a variable with this distribution lies with probability `u`. \pre 0 < u < 1; the distribution
/// has been checked, and its kind is not `Seed`.
double quantileOf(const StudyDistribution& distribution, double u);

/// Probability that a value lies below x. \pre as for `quantileOf`.
double shareBelow(const StudyDistribution& distribution, double x);

}  // namespace keyblock
