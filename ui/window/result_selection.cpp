// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/result_selection.h"

#include "ui/canvas/canvas.h"
#include "ui/look/commands.h"
#include "ui/look/plain_text.h"
#include "ui/look/theme.h"
#include "ui/runs/block_choice.h"
#include "ui/runs/bolt_choice.h"
#include "ui/runs/section_feed.h"

#include <QContextMenuEvent>
#include <QLineF>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>

#include <algorithm>

namespace keyblock {

namespace {

constexpr double dragStart = 4.0;  // [px]

}  // namespace

ResultSelection::ResultSelection(ResultSelectionNeeds needs, QObject* parent) : QObject(parent), needs_(std::move(needs)) {
    needs_.canvas.installEventFilter(this);
    needs_.canvas.addOverlay(this);
    connect(&needs_.blocks, &BlockChoice::changed, this, [this] { needs_.canvas.refresh(); });
}

ResultSelection::~ResultSelection() { needs_.canvas.removeOverlay(this); }

bool ResultSelection::isProbing() const { return needs_.commands.action("view.probe")->isChecked(); }

void ResultSelection::paint(QPainter& painter, const CanvasMap& map) const {
    const int block = needs_.blocks.block();
    if (block < 0 || !needs_.feed.showsResults() || !needs_.canvas.picture()) return;
    const auto& shapes = needs_.canvas.picture()->blocks;
    const auto shape = std::ranges::find_if(shapes, [&](const BlockShape& each) { return each.block == block; });
    if (shape == shapes.end()) return;
    QPolygonF outline;
    for (const Point& corner : shape->outline) outline << map.toPixel(corner);
    const Theme& theme = needs_.themes.current();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(Qt::NoBrush);
    for (const auto& [colour, width] : {std::pair(theme.panel, 4.5), std::pair(theme.accent, 2.5)}) {
        painter.setPen(QPen(colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolygon(outline);
    }
    painter.restore();
}

void ResultSelection::chooseAt(const QPointF& pixel) {
    const auto pick = needs_.canvas.pickAt(pixel);
    const bool isBlock = pick && pick->kind == PickKind::Block;
    needs_.bolts.choose(pick && !isBlock ? pick->bolt : -1);
    needs_.blocks.choose(isBlock && pick->block != needs_.blocks.block() ? pick->block : -1);
}

void ResultSelection::addPicked(QMenu& menu, const Pick& pick, const QPointF& pixel) {
    const SectionPicture& picture = *needs_.canvas.picture();
    const bool isBlock = pick.kind == PickKind::Block;
    const QString name = QString::fromStdString(isBlock ? picture.blocks[pick.shape].name : picture.bolts[pick.shape].name);
    const QString what = isBlock ? tr("block %1").arg(name) : tr("bolt %1").arg(name);
    const Box box = boxOf(isBlock ? picture.blocks[pick.shape].outline : picture.bolts[pick.shape].nodes);
    menu.addAction(asMenuText(tr("Show results for %1").arg(what)), this, [this, pick, isBlock] {
        if (isBlock) needs_.blocks.choose(pick.block);
        else needs_.bolts.choose(pick.bolt);
    });
    menu.addAction(tr("Pin this point and plot its values over time"), this,
                   [this, pick, place = needs_.canvas.map().toPlace(pixel)] { needs_.pin(pick, place); });
    menu.addAction(asMenuText(tr("Zoom to %1").arg(what)), this, [this, box] {
        needs_.canvas.zoomTo(grown(box, std::max(0.5, 0.5 * (box.max - box.min).maxCoeff())));
    });
    menu.addSeparator();
}

void ResultSelection::fillMenu(QMenu& menu, const QPointF& pixel) {
    if (const auto pick = needs_.canvas.pickAt(pixel)) addPicked(menu, *pick, pixel);
    for (const char* id : {"view.fit", "view.probe", "export.figure"})
        if (needs_.commands.has(id)) menu.addAction(needs_.commands.action(id));
}

bool ResultSelection::eventFilter(QObject* watched, QEvent* event) {
    const bool isMouse = event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonRelease;
    if (!needs_.feed.showsResults() || (!isMouse && event->type() != QEvent::ContextMenu))
        return QObject::eventFilter(watched, event);
    if (event->type() == QEvent::ContextMenu) {
        auto* menu = new QMenu(&needs_.canvas);
        menu->setAttribute(Qt::WA_DeleteOnClose);
        fillMenu(*menu, static_cast<QContextMenuEvent*>(event)->pos());
        menu->popup(static_cast<QContextMenuEvent*>(event)->globalPos());
        return true;
    }
    const auto& mouse = static_cast<QMouseEvent&>(*event);
    if (mouse.button() != Qt::LeftButton || isProbing()) return QObject::eventFilter(watched, event);
    if (event->type() == QEvent::MouseButtonPress) pressed_ = mouse.localPos();
    else if (QLineF(pressed_, mouse.localPos()).length() < dragStart) chooseAt(mouse.localPos());
    return QObject::eventFilter(watched, event);
}

}  // namespace keyblock
