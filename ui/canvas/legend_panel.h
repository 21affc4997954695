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

/// Quantities whose scale the user can change.
enum class LegendPart { Blocks, Bolts };

struct LegendContent {
    const SectionPicture& picture;
    const ContactField* contacts = nullptr;  // those in view; null: none are drawn
    std::vector<MarkKind> kinds;  // of marks that the scene holds
    bool culprit = false;  // a block is outlined as one
    double scale = 1.0;  // of the view [px per m]
};

/// The panel on a canvas of this size [px]; empty where there is no room, or nothing to explain.
QRectF legendRect(const Theme& theme, const LegendContent& content, const QSizeF& canvas);
void paintLegend(QPainter& painter, const Theme& theme, const LegendContent& content, const QSizeF& canvas);

/// The bar of a quantity, as far as it is shown [px]; empty where it is not.
QRectF legendPartRect(const Theme& theme, const LegendContent& content, const QSizeF& canvas, LegendPart part);

/// What a legend takes of a canvas at its right [px]; 0 where it has no room.
double legendWidth(const QSizeF& canvas);

}  // namespace keyblock
