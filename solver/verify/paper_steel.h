// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The two sets of steel properties that the unified bolt paper gives for the same
// bolt: a yield strength of 490 MPa and 630 MPa at 16 % strain in its text, 509 MPa,
// 651 MPa and 24 % in its table.
#pragma once

#include "solver/scene/scene.h"

namespace keyblock {

/// Stress–strain curves of the steel, from the paper's text and from its table: points (strain, stress [Pa]).
inline const Table textSteel{{0, 0},          {0.0023, 490e6}, {0.021, 500e6}, {0.05, 560e6},
                             {0.09, 605e6},   {0.13, 625e6},   {0.16, 630e6}};
inline const Table tableSteel{{0, 0},        {0.0024, 509e6}, {0.021, 519e6}, {0.06, 585e6},
                              {0.11, 630e6}, {0.16, 651e6},   {0.24, 651e6}};

}  // namespace keyblock
