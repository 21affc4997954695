// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The six unknowns of a block, and matrices over them: what model and step share.
#pragma once

#include <Eigen/Core>

namespace keyblock {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

}  // namespace keyblock
