// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/screen_marks.h"

#include "ui/canvas/view_theme.h"
#include "ui/figure/mark_painter.h"
#include "ui/figure/paper.h"
#include "ui/look/theme.h"

#include <QCoreApplication>
#include <QPainter>

namespace keyblock {

namespace {

struct MarkTexts {
    Q_DECLARE_TR_FUNCTIONS(Marks)
};

}  // namespace

MarkTheme screenMarks(const Theme& theme) {
    MarkTheme marks;
    marks.colours.ink = colourOf(theme.markInk);
    marks.colours.casing = marks.colours.hollow = colourOf(theme.markCasing);
    marks.colours.soft = colourOf(theme.text2);
    marks.colours.slipping = colourOf(theme.slipping);
    marks.colours.rim = colourOf(theme.dark ? theme.markCasing : theme.markInk);
    marks.colours.error = colourOf(theme.error);
    marks.colours.yielded = colourOf(theme.yielded);
    marks.sizes = screenMarkSizes;
    return marks;
}

void paintMark(QPainter& painter, MarkKind kind, const QPointF& at, const QPointF& along, bool small,
               const MarkTheme& theme) {
    painter.save();
    painter.translate(at);
    painter.scale(1.0 / unitsPerMm, 1.0 / unitsPerMm);  // a millimetre in a figure is a pixel here
    Ink ink(painter);
    drawMark(ink, kind, {0.0, 0.0}, {along.x(), along.y()}, small, theme);
    painter.restore();
}

QString markName(MarkKind kind) {
    switch (kind) {
        case MarkKind::Bonded: return MarkTexts::tr("Bonded");
        case MarkKind::Artificial: return MarkTexts::tr("Intermediate");
        case MarkKind::InGap: return MarkTexts::tr("In a gap");
        case MarkKind::Slipping: return MarkTexts::tr("Slipping");
        case MarkKind::Gone: return MarkTexts::tr("Failed");
        case MarkKind::Yielded: return MarkTexts::tr("Steel yielded");
        case MarkKind::Ruptured: return MarkTexts::tr("Ruptured");
        case MarkKind::Plate: return MarkTexts::tr("Face plate");
        case MarkKind::PlateLost: return MarkTexts::tr("Plate lost");
    }
    return {};
}

}  // namespace keyblock
