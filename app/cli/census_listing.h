// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The census of a scene for people: what is modelled, what is left out and why,
// what a run may take.
#pragma once

#include "solver/run/census.h"

#include <string>

namespace keyblock::cli {

/// A line each.
std::string censusLines(const Census& census);

}  // namespace keyblock::cli
