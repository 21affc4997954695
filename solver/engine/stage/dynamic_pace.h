// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The length of the next time step. A step that does not converge is repeated with a
// shorter one, which is lengthened again afterwards. Wedged rock needs short steps for
// a while: after each further cut, the length stays the same for more steps, because an
// attempt that fails costs as many iterations as a step may take.
#pragma once

#include "solver/engine/step/sweeps_first.h"

namespace keyblock {

/// Values carried over from previous steps to the next step.
struct DynamicPace {
    double dt = 0.0;  // next time step to try [s]; 0: the maximum
    double lastMove = 0.0;  // largest displacement in the previous step [m]
    double roundedUp = 0.0;  // amount by which rounding has increased the stage's time [s]
    SweepsFirst sweepsFirst;
    int afterCut = 0;  // steps of equal length after the next cut, before a longer one is tried
    int equalSteps = 0;  // number of them still to make
    double last = 0.0;  // length of the last step [s]; 0: none yet
    bool still = false;  // the last step changed nothing, so that under the same loads the next one changes nothing
};

/// Shortens a time step that did not converge, to the length of the last step if that was shorter and not much shorter.
/// \return the next one to try [s].
double cutStep(DynamicPace& pace, double dt);

/// Lengthens the next time step after one of length `dt`, unless steps of equal length are still to be made.
/// \param longest the stage's time step [s].
void lengthenStep(DynamicPace& pace, double dt, double longest);

/// The time after a step of length `dt`, corrected for the rounding of the last sum, so that a million steps lose
/// nothing (Kahan 1965). \param end the end of the stage, which a step that reaches it meets exactly [s].
/// \param roundedUp as in `DynamicPace`; updated.
double later(double time, double dt, double end, double& roundedUp);

}  // namespace keyblock
