// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Solution with a supernodal Cholesky factor for one right side. A few columns at a
// time go through a small triangle in plain loops and are multiplied into all rows
// below at once; the triangular solution of the BLAS takes one column after the other,
// each by a call of its own.
#pragma once

#include <cholmod.h>

#include <span>
#include <vector>

namespace keyblock {

/// Replaces x, of n values in the order of elimination, by (L·Lᵀ)⁻¹·x.
/// \param work is resized as needed.
/// \pre the factor is supernodal.
void solveSupernodes(const cholmod_factor& factor, std::span<double> x, std::vector<double>& work);

}  // namespace keyblock
