// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Text of estimated errors.
#pragma once

#include "solver/results/quantity_estimate.h"

#include <string>

namespace keyblock::cli {

/// A table with a line for each quantity: value, estimated error, and the error as a share of the value.
std::string errorEstimateLines(const ErrorEstimate& estimate);

}  // namespace keyblock::cli
