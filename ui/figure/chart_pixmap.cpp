// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figure/chart_pixmap.h"

#include "ui/figure/paper.h"

#include <qcustomplot.h>

namespace keyblock {

ChartPlace drawChart(QPixmap& onto, double pixelsPerMm, const Chart& chart, const Box& box, const ChartTheme& theme,
                     const ChartLayout& layout) {
    QCPPainter painter(&onto);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setModes(QCPPainter::pmNoCaching | QCPPainter::pmNonCosmetic);
    painter.scale(pixelsPerMm / unitsPerMm, pixelsPerMm / unitsPerMm);
    return drawChart(painter, chart, box, theme, layout);
}

}  // namespace keyblock
