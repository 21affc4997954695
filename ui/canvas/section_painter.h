// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Paints what is shown above the rendering of a section: marks and names of bolts, the
// force diagram, call-outs, legend and scale bar. Legend and scale bar are placed
// first, then names, then call-outs where they cover nothing.
#pragma once

#include "ui/canvas/call_out.h"
#include "ui/canvas/canvas_map.h"
#include "ui/canvas/highlighted_block.h"
#include "ui/canvas/legend_panel.h"
#include "ui/picture/section/placement.h"
#include "ui/picture/section/ribbon_shape.h"
#include "ui/picture/section/section.h"

#include <QRectF>

#include <vector>

class QPainter;

namespace keyblock {

struct Theme;

class SectionPainter {
public:
    /// All arguments passed by reference must outlive this object.
    /// \param selected indices of the selected bolts in the scene.
    /// \param covered parts of the canvas that are hidden by widgets [px].
    SectionPainter(const SectionPicture& picture, const CanvasMap& map, const Theme& theme, bool hasLegend,
                   const std::vector<int>& selected, const std::optional<HighlightedBlock>& highlighted,
                   std::vector<QRectF> covered = {});

    void paint(QPainter& painter);

    /// Rectangles [px] of the legend and the scale bar, if they are shown.
    std::vector<QRectF> panels() const;
    /// Rectangle of the colour bar of a quantity in the legend [px]; empty if it is not shown.
    QRectF legendPart(LegendPart part) const;

private:
    Point onSheet(const Point& place) const;
    QPolygonF onSheet(const std::vector<Point>& places) const;
    std::vector<Point> sheetPoints(const std::vector<Point>& places) const;
    void chooseMarks();
    void keepOffBolts();
    void paintMoved(QPainter& painter) const;
    void paintHighlighted(QPainter& painter) const;
    void paintBroken(QPainter& painter) const;
    void paintDashes(QPainter& painter) const;
    void paintMarks(QPainter& painter) const;
    void paintNames(QPainter& painter);
    void paintName(QPainter& painter, const BoltShape& bolt, const QString& name, const QRectF& box) const;
    void paintRibbon(QPainter& painter);
    void callOutRibbon(const RibbonShape& shape);
    void callOutMoved();
    void callOutEvents();
    void paintCallOuts(QPainter& painter);
    LegendContent legendContent() const;
    void keepOffPanels();
    void paintPanels(QPainter& painter) const;
    bool isSelected(const BoltShape& bolt) const;
    bool isSeen(const Point& place) const;
    Point footWithin(const std::vector<Point>& outline) const;

    const SectionPicture& picture_;
    const CanvasMap& map_;
    const Theme& theme_;
    bool hasLegend_;
    const std::vector<int>& selected_;
    const std::optional<HighlightedBlock>& highlighted_;
    std::vector<QRectF> covered_;
    std::optional<ContactField> contacts_;  // contact forces in the view
    std::vector<double> spacing_;  // distance of each bolt from the nearest other one [px]
    std::vector<std::vector<Mark>> marks_;  // of each bolt, thinned out
    std::vector<const BlockShape*> moved_;
    std::vector<CallOut> callOuts_;  // in order of precedence
    Placement placement_;
};

}  // namespace keyblock
