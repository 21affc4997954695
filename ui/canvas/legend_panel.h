// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The legend at the right of the canvas: bars of the quantities, the key of marks,
// how displacements are drawn. As high as its content; what finds no room on a
// small canvas is left out from below.
#pragma once

#include "ui/picture/section.h"

#include <QRectF>
#include <QSizeF>

#include <vector>

class QPainter;

namespace keyblock {

struct Theme;

struct LegendContent {
    const SectionPicture& picture;
    std::vector<MarkKind> kinds;  // of marks that the scene holds
    bool culprit = false;  // a block is outlined as one
};

/// The panel that it was painted on [px]; empty where there is no room, or nothing to explain.
QRectF paintLegend(QPainter& painter, const Theme& theme, const LegendContent& content, const QSizeF& canvas);

}  // namespace keyblock
