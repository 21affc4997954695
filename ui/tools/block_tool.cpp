// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/block_tool.h"

#include "ui/edit/edits.h"
#include "ui/tools/choices.h"

namespace keyblock {

std::vector<ToolField> BlockTool::fields() {
    const QStringList rocks = materialNames(scene());
    keepAmong(block_.material, rocks);
    keepAmong(block_.jointMaterial, jointMaterialNames(scene()));
    const auto tell = [this] { Q_EMIT changed(); };
    std::vector<ToolField> fields{shapeField()};
    if (!rocks.isEmpty()) fields.push_back(rowField("blocks", "material", &block_, tr("Material"), tell, rocks));
    fields.push_back(rowField("blocks", "joint_material", &block_, tr("Faces"), tell, jointMaterialNames(scene())));
    return fields;
}

Edit BlockTool::make(const std::vector<Point>& points) const {
    Block block = block_;
    block.points = points;
    return withBlock(scene(), block);
}

}  // namespace keyblock
