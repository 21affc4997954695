// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The Problems dock: each problem with its location and a link that fixes or shows it.
#pragma once

#include "ui/panels/problems/problem_rows.h"

#include <QAbstractListModel>
#include <QStyledItemDelegate>
#include <QWidget>

class QLabel;
class QListView;
class QTimer;

namespace keyblock {

class Selection;
class Themes;

class ProblemList : public QAbstractListModel {
    Q_OBJECT

public:
    using QAbstractListModel::QAbstractListModel;
    void show(std::vector<ProblemRow> rows);
    const ProblemRow& rowAt(int row) const { return rows_[row]; }
    const std::vector<ProblemRow>& rows() const { return rows_; }
    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;

private:
    std::vector<ProblemRow> rows_;
};

class ProblemRowPaint : public QStyledItemDelegate {
    Q_OBJECT

public:
    ProblemRowPaint(const Themes& themes, QObject* parent) : QStyledItemDelegate(parent), themes_(themes) {}
    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;

    /// Rectangle of the link in a row. \param row rectangle of the row. \param link text of the link.
    static QRect linkOf(const QRect& row, const QString& link, const QFont& font);

private:
    const Themes& themes_;
};

class ProblemsPanel : public QWidget {
    Q_OBJECT

public:
    ProblemsPanel(Document& document, Selection& selection, const Display& display, const Themes& themes,
                  QWidget* parent = nullptr);

    /// Number of errors and warnings, for the badge of the dock.
    int urgent() const { return urgentCount(list_->rows()); }

    /// Performs the action of the link in this row.
    void follow(int row);

    /// Selects the object to which the problem in this row refers, and requests that the object be shown.
    void showRow(int row);

    const ProblemList& list() const { return *list_; }

    /// Updates the list immediately to show the latest check, without waiting for the event loop.
    void refresh();

Q_SIGNALS:
    void placeAsked(const keyblock::Box& box);
    void fieldAsked(const QString& pointer);  // pointer to a field of the object just selected
    void countChanged(int urgent);

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    Document& document_;
    Selection& selection_;
    const Display& display_;
    const Themes& themes_;
    bool reportIsOpen_ = false;
    ProblemList* list_;
    QListView* view_;
    QLabel* none_;
    QTimer* later_;
};

}  // namespace keyblock
