// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The model summary of a scene for people: what is modelled, what is left out and why,
// what a run may take.
#pragma once

#include "solver/run/model_summary.h"

#include <string>

namespace keyblock::cli {

/// A line each.
std::string modelSummaryLines(const ModelSummary& summary);

}  // namespace keyblock::cli
