// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Solution with a supernodal Cholesky factor for one right-hand side. A few columns at
// a time are solved with a small triangle in plain loops and then multiplied into all
// rows below at once. The triangular solver of the BLAS processes one column after the
// other, each with a separate call.
#pragma once

#include <cholmod.h>

#include <span>
#include <vector>

namespace keyblock {

/// Replaces x (n values in elimination order) by (L·Lᵀ)⁻¹·x.
/// \param work the workspace, resized as needed.
/// \pre the factor is supernodal.
void solveSupernodes(const cholmod_factor& factor, std::span<double> x, std::vector<double>& work);

}  // namespace keyblock
