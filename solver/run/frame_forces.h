// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The forces that a frame stores, out of all forces listed by the engine. Those that
// follow from its contacts are left out to keep the run store small.
#pragma once

#include "solver/engine/stage/acting_forces.h"

namespace keyblock {

/// Converts the list of forces from the engine to the form stored in a frame.
/// \param state the state for which the engine listed the forces.
/// \param frame the frame made from `state`.
/// \param moves true if the forces act over a dynamic step. Contact forces are then stored as well, because they differ
///        from those in `frame.contacts`, which act at the end of the step.
FrameForces frameForces(const std::vector<SingleForce>& forces, const State& state, const Frame& frame, bool moves);

}  // namespace keyblock
