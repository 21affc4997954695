// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Vector and matrix types for the six unknowns of a block, shared by model and step.
#pragma once

#include <Eigen/Core>

namespace keyblock {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

}  // namespace keyblock
