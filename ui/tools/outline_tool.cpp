// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/outline_tool.h"

#include "ui/edit/edits.h"

namespace keyblock {

std::vector<ToolField> OutlineTool::fields() {
    return {choiceField("what", tr("Outline of"), {tr("rock"), tr("region")}, what_, [this] { Q_EMIT changed(); }),
            shapeField()};
}

Edit OutlineTool::make(const std::vector<Point>& points) const {
    return what_ == 0 ? withDomain(scene(), points) : withRegion(scene(), {"", points});
}

QString OutlineTool::step() const {
    return what_ == 1 ? QString() : scene().domain ? tr("Change outline") : tr("Add outline");
}

}  // namespace keyblock
