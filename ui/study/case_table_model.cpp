// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/study/case_table_model.h"

#include "ui/look/display.h"
#include "ui/look/plain_text.h"
#include "ui/look/qt_text.h"

#include <array>
#include <cmath>
#include <limits>

namespace keyblock {

namespace {

constexpr int ownColumns = 2;  // number and outcome

/// The outcome of a case and whether it fails, in a word or two.
QString outcomeText(const std::optional<SweepCaseResult>& one) {
    static constexpr std::array words{QT_TRANSLATE_NOOP("keyblock::CaseTableModel", "done"),
                                      QT_TRANSLATE_NOOP("keyblock::CaseTableModel", "invalid"),
                                      QT_TRANSLATE_NOOP("keyblock::CaseTableModel", "numerical failure"),
                                      QT_TRANSLATE_NOOP("keyblock::CaseTableModel", "limit reached"),
                                      QT_TRANSLATE_NOOP("keyblock::CaseTableModel", "undecided"),
                                      QT_TRANSLATE_NOOP("keyblock::CaseTableModel", "error")};
    if (!one) return {};
    if (one->outcome != CaseOutcome::Done) return CaseTableModel::tr(words.at(static_cast<std::size_t>(one->outcome)));
    if (!one->fails) return CaseTableModel::tr("done");
    return *one->fails ? CaseTableModel::tr("fails") : CaseTableModel::tr("does not fail");
}

}  // namespace

void CaseTableModel::show(std::shared_ptr<const OpenedSweep> sweep) {
    const bool isSame = sweep && sweep_ && sweep->sweep.folder == sweep_->sweep.folder &&
                        sweep->results.columns.size() == sweep_->results.columns.size();
    if (!isSame) beginResetModel();
    sweep_ = std::move(sweep);
    columns_.clear();
    if (sweep_)
        for (const SweepColumn& column : sweep_->results.columns)
            if (column.role != ColumnRole::Verdict) columns_.push_back(&column);
    if (!isSame) return endResetModel();
    if (rowCount() > 0) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
}

int CaseTableModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() || !sweep_ ? 0 : static_cast<int>(sweep_->results.cases.size());
}

int CaseTableModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() || !sweep_ ? 0 : ownColumns + static_cast<int>(columns_.size());
}

QString CaseTableModel::reasonOf(std::size_t row) const {
    const auto& one = sweep_->results.cases[row];
    return one ? qt(one->reason) : tr("not run yet");
}

QVariant CaseTableModel::ownCell(std::size_t row, int column, int role) const {
    if (column == 0) {
        if (role == sortRole) return qlonglong(row);
        return role == Qt::DisplayRole ? QVariant(QString::number(row + 1)) : QVariant();
    }
    const QString text = outcomeText(sweep_->results.cases[row]);
    return role == Qt::DisplayRole || role == sortRole ? QVariant(text) : QVariant();
}

QVariant CaseTableModel::data(const QModelIndex& index, int role) const {
    const auto row = static_cast<std::size_t>(index.row());
    if (role == Qt::ToolTipRole) return asTip(reasonOf(row));
    if (role == Qt::TextAlignmentRole)
        return int(index.column() == 1 ? Qt::AlignLeft | Qt::AlignVCenter : Qt::AlignRight | Qt::AlignVCenter);
    if (role != Qt::DisplayRole && role != sortRole) return {};
    if (index.column() < ownColumns) return ownCell(row, index.column(), role);
    const auto number = static_cast<std::size_t>(index.column() - ownColumns);
    const double value = columns_[number]->values[row];
    const bool isText = !std::isfinite(value) && number < sweep_->results.parameters.size();
    if (isText) return qt(sweep_->results.cells[row][number]);
    if (role == sortRole) return std::isfinite(value) ? value : -std::numeric_limits<double>::infinity();
    return std::isfinite(value) ? Display::number(value) : QString();
}

QVariant CaseTableModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || !sweep_) return {};
    const QString name = section == 0   ? tr("Case")
                         : section == 1 ? tr("Outcome")
                                        : qt(columns_[static_cast<std::size_t>(section - ownColumns)]->name);
    if (role == Qt::TextAlignmentRole)
        return int(section == 1 ? Qt::AlignLeft | Qt::AlignVCenter : Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::DisplayRole) return name;
    return role == Qt::ToolTipRole ? QVariant(asTip(name)) : QVariant();
}

}  // namespace keyblock
