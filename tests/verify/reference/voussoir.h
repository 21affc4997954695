// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// An independent calculation of a voussoir beam: half of it in bilinear finite
// elements, with faces at the abutment and in the middle that can press but not
// pull. It shares no line with the program that it checks. Displacements are
// small, so the thrust is in proportion to the weight.
#pragma once

namespace keyblock::reference {

/// One crack in the middle, plane stress, 1 m thick.
struct VoussoirBeam {
    double span = 0.0, depth = 0.0;  // [m]
    double youngsModulus = 0.0;  // [Pa]
    double poissonsRatio = 0.0;
    double unitWeight = 0.0;  // [N/m³]
};

struct VoussoirThrust {
    double thrust = 0.0;  // [N]
    double arm = 0.0;  // between its places in the middle and at the abutment [m]
    int rounds = 0;  // until no node changed between touching and open
};

/// With `rows` rows of elements, each as long as it is high.
/// \pre half of the span is a whole number of element heights
VoussoirThrust voussoirThrust(const VoussoirBeam& beam, int rows);

}  // namespace keyblock::reference
