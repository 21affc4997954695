// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/joint_tool.h"

#include "ui/edit/edits.h"
#include "ui/tools/choices.h"

namespace keyblock {

std::vector<ToolField> JointTool::fields() {
    keepAmong(joint_.jointMaterial, jointMaterialNames(scene()));
    return {rowField("joints", "joint_material", &joint_, tr("Joint material"), [this] { Q_EMIT changed(); },
                     jointMaterialNames(scene()))};
}

Edit JointTool::make(const std::vector<Point>& points) const {
    SceneJoint joint = joint_;
    joint.points = points;
    return withJoint(scene(), joint);
}

}  // namespace keyblock
