// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The legend at the right of the canvas: colour bars of the quantities, key of marks,
// scale of displacements. It is as high as its content. On a low canvas the notes below
// arrows and contact forces are left out first, then entries that do not fit; colour
// bars are kept the longest. A narrow canvas, such as half of a comparison on a small
// screen, only shows the colour bars, at the bottom right.
#pragma once

#include "ui/picture/section/section.h"

#include <QMarginsF>
#include <QRectF>
#include <QSizeF>

#include <vector>

class QPainter;

namespace keyblock {

struct Theme;

/// Parts of the legend whose colour scale the user can change.
enum class LegendPart { Blocks, Bolts };

struct LegendContent {
    const SectionPicture& picture;
    const ContactField* contacts = nullptr;  // contact forces in the view; null: none are drawn
    std::vector<MarkKind> kinds;  // marks explained in the key
    bool highlighted = false;  // a block is outlined
    double scale = 1.0;  // scale of the view [px per m]
};

/// Rectangle of the legend on a canvas of the given size [px]; empty if the legend does not fit or has no content.
QRectF legendRect(const Theme& theme, const LegendContent& content, const QSizeF& canvas);
void paintLegend(QPainter& painter, const Theme& theme, const LegendContent& content, const QSizeF& canvas);

/// Rectangle of the colour bar of a quantity [px]; empty if it is not shown.
QRectF legendPartRect(const Theme& theme, const LegendContent& content, const QSizeF& canvas, LegendPart part);

inline constexpr double legendExtent = 240.0;  // from the right side of the canvas to the left side of the panel [px]

/// Space that the legend takes up at the right or the bottom of a canvas [px]. On a narrow canvas it depends on the
/// colour bars and is zero if they do not fit. On a wider canvas it does not depend on the content, so that the section
/// does not move when marks appear.
QMarginsF legendRoom(const Theme& theme, const LegendContent& content, const QSizeF& canvas);

}  // namespace keyblock
