// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stage plan: a bar for each object over the stages in which it is present, with a
// mark at the stage in which it is excavated, installed or removed. A click on a cell,
// or Enter, changes it.
#pragma once

#include "ui/panels/stages/stage_plan.h"

#include <QAbstractTableModel>
#include <QStyledItemDelegate>
#include <QTableView>

namespace keyblock {

class Themes;

class PlanModel : public QAbstractTableModel {
    Q_OBJECT

public:
    using QAbstractTableModel::QAbstractTableModel;
    void show(std::vector<PlanRow> rows, QStringList stages);
    const PlanRow& planRow(int row) const { return rows_[row]; }
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    std::vector<PlanRow> rows_;
    QStringList stages_;
};

class PlanCells : public QStyledItemDelegate {
    Q_OBJECT

public:
    PlanCells(const Themes& themes, QObject* parent) : QStyledItemDelegate(parent), themes_(themes) {}
    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override;

private:
    const Themes& themes_;
};

class PlanView : public QTableView {
    Q_OBJECT

public:
    PlanView(const Themes& themes, QWidget* parent);

    PlanModel& plan() const { return *plan_; }

Q_SIGNALS:
    void cellChosen(int row, int stage);

protected:
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    PlanModel* plan_;
};

}  // namespace keyblock
