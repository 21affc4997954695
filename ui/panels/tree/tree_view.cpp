// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/tree/tree_view.h"

#include "ui/document/visibility.h"
#include "ui/look/theme.h"
#include "ui/panels/tree/tree_model.h"

#include <QMouseEvent>
#include <QPainter>

namespace keyblock {

namespace {

constexpr int rowHeight = 24, step = 14, iconSize = 16, right = 8, edge = 2;

const TreeNode& nodeOf(const QModelIndex& index) {
    return static_cast<const TreeModel*>(index.model())->nodeAt(index);
}

QFont treeFont(const QFont& base, int pixels, QFont::Weight weight) {
    QFont font = base;
    font.setPixelSize(pixels);
    font.setWeight(weight);
    return font;
}

/// Only objects that can be picked with the mouse can be locked.
bool canLock(const TreeNode& node) { return node.isObject && node.hasPlace; }

}  // namespace

TreeRows::TreeRows(const Themes& themes, const Visibility& visibility, QObject* parent)
    : QStyledItemDelegate(parent), themes_(themes), visibility_(visibility) {}

QRect TreeRows::eyeOf(const QRect& row) {
    return {row.right() - right - iconSize, row.center().y() - iconSize / 2 + 1, iconSize, iconSize};
}

QRect TreeRows::lockOf(const QRect& row) { return eyeOf(row).translated(-iconSize - 4, 0); }

QSize TreeRows::sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const { return {80, rowHeight}; }

/// Paints the eye, the lock and the badge from the right. Returns the right limit of the texts.
int TreeRows::paintRight(QPainter& painter, const QRect& row, const TreeNode& node, bool selected) const {
    const Theme& t = themes_.current();
    const bool hidden = visibility_.isHidden(node.id);
    const bool locked = visibility_.isLocked(node.id);
    int x = eyeOf(row).left();
    if (node.canHide)
        themes_.icon(hidden ? "eye-off" : "eye", hidden ? t.text3 : selected ? t.accent : t.text2)
            .paint(&painter, eyeOf(row));
    if (canLock(node) && locked) {
        themes_.icon("lock", t.text2).paint(&painter, lockOf(row));
        x = lockOf(row).left();
    }
    if (node.badge) {
        const bool error = *node.badge == Severity::Error;
        const QRect place(x - iconSize - 4, eyeOf(row).top(), iconSize, iconSize);
        themes_.icon(error ? "error" : "warning", error ? t.error : t.warningFill).paint(&painter, place);
        x = place.left();
    }
    return x - 4;
}

void TreeRows::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const TreeNode& node = nodeOf(index);
    const Theme& t = themes_.current();
    const bool selected = option.state & QStyle::State_Selected;
    const bool hidden = visibility_.isHidden(node.id);
    painter->save();
    painter->setClipRect(option.rect);
    const QRect& row = option.rect;
    const int end = paintRight(*painter, row, node, selected);
    const QRect icon(row.left() + 2, row.center().y() - iconSize / 2 + 1, iconSize, iconSize);
    themes_.icon(node.icon, hidden ? t.text3 : selected ? t.accent : t.text2).paint(painter, icon);
    const bool bold = node.bold || selected;
    painter->setFont(treeFont(option.font, 12, bold ? QFont::DemiBold : QFont::Normal));
    const int left = icon.right() + 7;
    const QFontMetrics metrics(painter->font());
    const QString name = metrics.elidedText(node.name, Qt::ElideRight, std::max(0, end - left));
    painter->setPen(hidden ? t.text3 : t.text);
    painter->drawText(QRect(left, row.top(), end - left, row.height()), Qt::AlignVCenter, name);
    const int after = left + metrics.horizontalAdvance(name) + 6;
    painter->setFont(treeFont(option.font, 11, QFont::Normal));
    painter->setPen(hidden ? t.text3 : t.text2);
    if (end - after > 14)
        painter->drawText(QRect(after, row.top(), end - after, row.height()), Qt::AlignVCenter,
                          QFontMetrics(painter->font()).elidedText(node.detail, Qt::ElideRight, end - after));
    painter->restore();
}

void TreeRows::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option, const QModelIndex&) const {
    editor->setGeometry(option.rect.adjusted(iconSize + 3, 1, -right, -1));
}

TreeView::TreeView(const Themes& themes, const Visibility& visibility, TreeModel& model, QWidget* parent)
    : QTreeView(parent), themes_(themes), model_(model) {
    setObjectName("sceneTreeView");
    setAccessibleName(tr("Scene"));
    setModel(&model);
    setItemDelegate(new TreeRows(themes, visibility, this));
    setHeaderHidden(true);
    setIndentation(step);
    setUniformRowHeights(true);
    setSelectionMode(ExtendedSelection);
    setEditTriggers(EditKeyPressed | DoubleClicked);
    setDragDropMode(InternalMove);
    setDropIndicatorShown(true);
    setExpandsOnDoubleClick(true);
    setContextMenuPolicy(Qt::CustomContextMenu);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setFrameShape(NoFrame);
    setMouseTracking(true);
}

void TreeView::drawRow(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const QRect row(0, option.rect.top(), viewport()->width(), option.rect.height());
    const Theme& t = themes_.current();
    if (selectionModel()->isSelected(index)) {
        painter->fillRect(row, t.accentRow);
        painter->fillRect(QRect(0, row.top(), edge, row.height()), t.accent);
    } else if (option.state & QStyle::State_MouseOver) {
        painter->fillRect(row, t.header);
    }
    QTreeView::drawRow(painter, option, index);
}

void TreeView::drawBranches(QPainter* painter, const QRect& rect, const QModelIndex& index) const {
    if (!model()->hasChildren(index)) return;
    const QRect place(rect.right() - 12, rect.center().y() - 5, 12, 12);
    themes_.icon(isExpanded(index) ? "chevron-down" : "chevron-right", themes_.current().text2).paint(painter, place);
}

void TreeView::mousePressEvent(QMouseEvent* event) {
    const QModelIndex index = indexAt(event->pos());
    if (index.isValid() && event->button() == Qt::LeftButton) {
        const TreeNode& node = model_.nodeAt(index);
        const QRect row(0, visualRect(index).top(), viewport()->width(), visualRect(index).height());
        if (node.canHide && TreeRows::eyeOf(row).adjusted(-2, -4, 2, 4).contains(event->pos()))
            return Q_EMIT eyeClicked(node.id);
        if (canLock(node) && TreeRows::lockOf(row).adjusted(-2, -4, 2, 4).contains(event->pos()))
            return Q_EMIT lockClicked(node.id);
    }
    QTreeView::mousePressEvent(event);
}

}  // namespace keyblock
