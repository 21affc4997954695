// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The field table of each struct of a scene, selected by the type of the argument.
#pragma once

#include "solver/scene/field.h"

namespace keyblock {

const Structure& structureOf(const About*);
const Structure& structureOf(const Acceleration*);
const Structure& structureOf(const Analysis*);
const Structure& structureOf(const Anchor*);
const Structure& structureOf(const Block*);
const Structure& structureOf(const Bolt*);
const Structure& structureOf(const BoltType*);
const Structure& structureOf(const CellSettings*);
const Structure& structureOf(const Cutting*);
const Structure& structureOf(const Damping*);
const Structure& structureOf(const Dilation*);
const Structure& structureOf(const Expected*);
const Structure& structureOf(const InSituStress*);
const Structure& structureOf(const InitialVelocity*);
const Structure& structureOf(const JointMaterial*);
const Structure& structureOf(const Load*);
const Structure& structureOf(const Material*);
const Structure& structureOf(const Monitor*);
const Structure& structureOf(const Motion*);
const Structure& structureOf(const Output*);
const Structure& structureOf(const Plate*);
const Structure& structureOf(const RunLimits*);
const Structure& structureOf(const Safety*);
const Structure& structureOf(const SceneDomain*);
const Structure& structureOf(const SceneJoint*);
const Structure& structureOf(const SceneJointSet*);
const Structure& structureOf(const ScenePattern*);
const Structure& structureOf(const SceneRegion*);
const Structure& structureOf(const SceneTunnel*);
const Structure& structureOf(const SceneVoronoi*);
const Structure& structureOf(const Sine*);
const Structure& structureOf(const Stage*);
const Structure& structureOf(const StrengthChange*);
const Structure& structureOf(const StressGradient*);
const Structure& structureOf(const Support*);
const Structure& structureOf(const Until*);

/// The field table of the struct T. Each struct has a single table, so that tables can be compared by address.
template <typename T>
const Structure& tableOf() {
    return structureOf(static_cast<const T*>(nullptr));
}

}  // namespace keyblock
