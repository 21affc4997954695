// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Mouse clicks on the section while results are shown: a click selects and outlines a
// block, and a context menu offers actions for the block or bolt under the cursor.
#pragma once

#include "ui/canvas/canvas_tool.h"
#include "ui/picture/section/pick.h"

#include <QObject>

#include <functional>

class QMenu;

namespace keyblock {

class BlockChoice;
class BoltChoice;
class Canvas;
class Commands;
class SectionFeed;
class Themes;

struct ResultSelectionNeeds {
    Canvas& canvas;
    const Themes& themes;
    Commands& commands;
    const SectionFeed& feed;
    BoltChoice& bolts;
    BlockChoice& blocks;
    std::function<void(const Pick&, const Point&)> pin;  // pins a point on a block or bolt
};

class ResultSelection : public QObject, public CanvasOverlay {
    Q_OBJECT

public:
    explicit ResultSelection(ResultSelectionNeeds needs, QObject* parent);
    ~ResultSelection() override;

    /// Paints the outline of the selected block.
    void paint(QPainter& painter, const CanvasMap& map) const override;
    /// Fills the context menu for a right click at `pixel`.
    void fillMenu(QMenu& menu, const QPointF& pixel);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    bool isProbing() const;
    void chooseAt(const QPointF& pixel);
    void addPicked(QMenu& menu, const Pick& pick, const QPointF& pixel);

    ResultSelectionNeeds needs_;
    QPointF pressed_;
};

}  // namespace keyblock
