// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The cases of a sweep as rows of a table: number, outcome, verdict, values that vary and
// results.
#pragma once

#include "ui/study/sweep_session.h"

#include <QAbstractTableModel>

#include <memory>

namespace keyblock {

class CaseTableModel : public QAbstractTableModel {
    Q_OBJECT

public:
    static constexpr int sortRole = Qt::UserRole;

    using QAbstractTableModel::QAbstractTableModel;

    void show(std::shared_ptr<const OpenedSweep> sweep);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    /// Columns of the results that are shown after those of the case itself: all but the verdict.
    const std::vector<const SweepColumn*>& columns() const { return columns_; }
    QVariant ownCell(std::size_t row, int column, int role) const;
    QString reasonOf(std::size_t row) const;

    std::shared_ptr<const OpenedSweep> sweep_;
    std::vector<const SweepColumn*> columns_;
};

}  // namespace keyblock
