// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/status_line.h"

#include "ui/canvas/canvas.h"
#include "ui/document/document.h"
#include "ui/look/display.h"
#include "ui/look/elided_label.h"

#include <QLabel>
#include <QStatusBar>
#include <QUndoStack>

namespace keyblock {

namespace {

constexpr int mostOfLabel = 420;  // [px]
const QString dot = QString::fromUtf8(" · ");

QLabel* addLabel(QStatusBar& bar, const char* name, bool right) {
    auto* label = new ElidedLabel(&bar);
    label->setMost(mostOfLabel);
    label->setObjectName(QString("status.") + name);
    label->setTextFormat(Qt::PlainText);
    if (right) bar.addPermanentWidget(label);
    else bar.addWidget(label);
    return label;
}

QString metres(double value) { return QString::number(value, 'f', 3).replace('-', QChar(0x2212)); }

QString blockText(const SectionPicture& picture, const BlockShape& block) {
    QString text = StatusLine::tr("Block %1").arg(QString::fromStdString(block.name));
    if (block.value && picture.blockLegend)
        text += dot + QString::fromStdString(picture.blockLegend->title) + ' ' +
                Display::number(withoutRoundOff(*block.value, picture.blockLegend->unit)) + ' ' +
                QString::fromStdString(picture.blockLegend->unit);
    return text;
}

QString pickText(const SectionPicture& picture, const Pick& pick) {
    if (pick.kind == PickKind::Block) return blockText(picture, picture.blocks[pick.shape]);
    const QString bolt = QString::fromStdString(picture.bolts[pick.shape].name);
    return pick.kind == PickKind::Node ? StatusLine::tr("Bolt %1, node %2").arg(bolt).arg(pick.node + 1)
                                       : StatusLine::tr("Bolt %1").arg(bolt);
}

}  // namespace

StatusLine::StatusLine(QStatusBar& bar, Document& document, Canvas& canvas, Display& display)
    : QObject(&bar), document_(document), canvas_(canvas), display_(display), place_(addLabel(bar, "place", false)),
      under_(addLabel(bar, "under", false)), counts_(addLabel(bar, "counts", true)),
      undo_(addLabel(bar, "undo", true)), units_(addLabel(bar, "units", true)) {
    place_->setMinimumWidth(150);
    connect(&canvas, &Canvas::hovered, this, [this](const Point& place, bool inside) {
        place_->setText(inside ? tr("x %1   y %2 m").arg(metres(place.x()), metres(place.y())) : QString());
        const auto pick = inside ? canvas_.pickAt(canvas_.map().toPixel(place)) : std::nullopt;
        under_->setText(pick ? pickText(*canvas_.picture(), *pick) : QString());
    });
    connect(&document, &Document::checkedChanged, this, &StatusLine::showCounts);
    connect(&document.undo(), &QUndoStack::indexChanged, this, &StatusLine::showUndo);
    const auto showUnits = [this] { units_->setText(display_.summary()); };
    connect(&display, &Display::changed, this, showUnits);
    showUnits();
    showCounts();
    showUndo();
}

void StatusLine::showCounts() {
    const Checked& checked = document_.checked();
    if (!checked.picture) {
        counts_->clear();
        return;
    }
    // Counted as in the tree: including the blocks that are excavated later, which the drawing omits.
    const std::size_t blocks = checked.cut ? checked.cut->scene.blocks.size() : checked.scene->blocks.size();
    const std::size_t bolts = checked.picture->bolts.size();
    counts_->setText((blocks == 1 ? tr("1 block") : tr("%1 blocks").arg(blocks)) + dot +
                     (bolts == 1 ? tr("1 bolt") : tr("%1 bolts").arg(bolts)));
}

void StatusLine::showUndo() {
    const QUndoStack& undo = document_.undo();
    undo_->setText(undo.canUndo() ? tr("Undo: %1").arg(undo.undoText()) : QString());
}

}  // namespace keyblock
