// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Text of the model summary of a scene: what is modelled, what is left out and why, and
// an estimate of run time and memory.
#pragma once

#include "solver/run/model_summary.h"

#include <string>

namespace keyblock::cli {

/// The model summary as several lines of text.
std::string modelSummaryLines(const ModelSummary& summary);

}  // namespace keyblock::cli
