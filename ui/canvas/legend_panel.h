// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The legend at the right of the canvas: colour bars of the quantities, the key of
// marks, the scale of displacements. As high as its content; on a small canvas,
// entries that do not fit are left out from the bottom. On a narrow canvas, such as
// half of a comparison on a small screen, only the colour bars are shown, at the
// bottom right.
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
    const ContactField* contacts = nullptr;  // those in the view; null: none are drawn
    std::vector<MarkKind> kinds;  // marks of the scene
    bool highlighted = false;  // a block is outlined
    double scale = 1.0;  // of the view [px per m]
};

/// The panel on a canvas of this size [px]; empty if it does not fit or has no content.
QRectF legendRect(const Theme& theme, const LegendContent& content, const QSizeF& canvas);
void paintLegend(QPainter& painter, const Theme& theme, const LegendContent& content, const QSizeF& canvas);

/// The visible bar of a quantity [px]; empty if it is not shown.
QRectF legendPartRect(const Theme& theme, const LegendContent& content, const QSizeF& canvas, LegendPart part);

inline constexpr double legendExtent = 240.0;  // of the panel, from the right side of the canvas [px]

/// Room that the legend takes at the right or the bottom of a canvas [px]; 0 if it does not fit. On a narrow canvas only
/// the bars of the content matter, on others none of it, so that the section keeps its position as marks appear.
QMarginsF legendRoom(const Theme& theme, const LegendContent& content, const QSizeF& canvas);

}  // namespace keyblock
