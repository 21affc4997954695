// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faults in the installation of bolts: which bolt has which fault in a case, and the
// scene with these faults. Each draw depends on the seed, the case and the names of
// fault and bolt only.
#pragma once

#include "solver/files/scene/scene_file.h"
#include "solver/study/study.h"

#include <string>
#include <vector>

namespace keyblock {

/// One fault of one bolt.
struct BoltFault {
    int fault = 0;  // index of the study's fault
    std::string bolt;
    FaultKind kind = FaultKind::Missing;
    double from = 0.0, to = 0.0;  // part without bond [m] from the far end
    double share = 0.0;  // of its length
    double offset = 0.0;  // [m] along the wall, or to the left of the bolt seen from its far end
    double angle = 0.0;  // [°] counter-clockwise
};

/// The faults of a case, counted from 1, fault by fault and bolt by bolt.
/// \param read the scene of the case, which has no errors.
std::vector<BoltFault> faultsOf(const Study& study, long number, const SceneReading& read);

/// The scene with faults, in which patterns are replaced by their bolts. A missing bolt is removed at the start of the
/// first stage, so that monitors of it stay valid.
Scene withFaults(const SceneReading& read, const std::vector<BoltFault>& faults);

/// One number for each fault of the study: missing bolts, mean share of the length without bond of the bolts concerned,
/// or root mean square of the offsets [m] (of the angles [°] if there are no offsets).
std::vector<double> faultMeasures(const Study& study, const std::vector<BoltFault>& faults, const SceneReading& read);

}  // namespace keyblock
