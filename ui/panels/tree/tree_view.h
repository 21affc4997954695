// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Painting and mouse input of the scene tree: rows 24 px high with icon, name and
// detail, and at the right the badge, the lock and the eye.
#pragma once

#include <QStyledItemDelegate>
#include <QTreeView>

namespace keyblock {

class Themes;
class TreeModel;
class Visibility;
struct TreeNode;

class TreeRows : public QStyledItemDelegate {
    Q_OBJECT

public:
    TreeRows(const Themes& themes, const Visibility& visibility, QObject* parent);
    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    void updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                              const QModelIndex& index) const override;

    /// Rectangles of the eye and the lock in a row.
    static QRect eyeOf(const QRect& row);
    static QRect lockOf(const QRect& row);

private:
    int paintRight(QPainter& painter, const QRect& row, const TreeNode& node, bool selected) const;

    const Themes& themes_;
    const Visibility& visibility_;
};

class TreeView : public QTreeView {
    Q_OBJECT

public:
    TreeView(const Themes& themes, const Visibility& visibility, TreeModel& model, QWidget* parent);

    /// True while a name is being edited.
    bool isEditing() const { return state() == EditingState; }

Q_SIGNALS:
    void eyeClicked(const QString& id);
    void lockClicked(const QString& id);

protected:
    void drawRow(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    void drawBranches(QPainter* painter, const QRect& rect, const QModelIndex& index) const override;
    void mousePressEvent(QMouseEvent* event) override;

private:
    const Themes& themes_;
    const TreeModel& model_;
};

}  // namespace keyblock
