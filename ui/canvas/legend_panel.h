// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The legend at the right of the canvas: bars of the quantities, the key of marks,
// how displacements are drawn. As high as its content; what finds no room on a
// small canvas is left out from below. On a narrow canvas, such as half of a
// comparison on a small screen, the bars alone are at the bottom right.
#pragma once

#include "ui/picture/section.h"

#include <QMarginsF>
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

inline constexpr double legendExtent = 240.0;  // of the panel, from the right side of the canvas [px]

/// What the legend takes of the right or the bottom of a canvas [px]; 0 where it has no room. Only the bars of the content
/// count on a narrow canvas, and nothing of it on others, so that the section keeps its place as marks come and go.
QMarginsF legendRoom(const Theme& theme, const LegendContent& content, const QSizeF& canvas);

}  // namespace keyblock
