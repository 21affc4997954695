// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/editors/cell_table.h"

#include <QApplication>
#include <QClipboard>
#include <QHeaderView>
#include <QKeyEvent>
#include <QScopedValueRollback>

#include <algorithm>
#include <set>

namespace keyblock {

namespace {

constexpr int cellLine = 22, cellHeadingHeight = 22, mostRowsInSight = 7;

}  // namespace

CellTable::CellTable(const QStringList& headings, bool numbers, QWidget* parent)
    : QTableWidget(0, headings.size(), parent), numbers_(numbers) {
    setObjectName("cellTable");
    setHeadings(headings);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    horizontalHeader()->setFixedHeight(cellHeadingHeight);
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setDefaultAlignment((numbers ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    verticalHeader()->setDefaultSectionSize(cellLine);
    verticalHeader()->setMinimumSectionSize(cellLine);
    verticalHeader()->hide();
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setEditTriggers(QAbstractItemView::AllEditTriggers);
    setTabKeyNavigation(true);
    connect(this, &QTableWidget::itemChanged, this, [this] {
        if (filling_) return;
        keepEmptyRow();
        fitHeight();
        Q_EMIT edited();
    });
    connect(this, &QTableWidget::currentCellChanged, this, [this] { Q_EMIT focused(); });
    fitHeight();
}

void CellTable::setHeadings(const QStringList& headings) { setHorizontalHeaderLabels(headings); }

void CellTable::put(int row, int column, const QString& text) {
    auto* cell = new QTableWidgetItem(text);
    cell->setTextAlignment((numbers_ ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    setItem(row, column, cell);
}

void CellTable::setRows(const std::vector<QStringList>& rows) {
    const QScopedValueRollback<bool> filling(filling_, true);
    setRowCount(static_cast<int>(rows.size()) + (growing_ ? 1 : 0));
    for (int row = 0; row < rowCount(); ++row)
        for (int column = 0; column < columnCount(); ++column) {
            const bool inside = row < static_cast<int>(rows.size());
            put(row, column, inside ? rows[row].value(column) : QString());
        }
    fitHeight();
}

std::vector<QStringList> CellTable::rows() const {
    std::vector<QStringList> rows;
    for (int row = 0; row < rowCount(); ++row) {
        QStringList texts;
        for (int column = 0; column < columnCount(); ++column)
            texts << (item(row, column) ? item(row, column)->text().trimmed() : QString());
        if (std::any_of(texts.begin(), texts.end(), [](const QString& text) { return !text.isEmpty(); }))
            rows.push_back(texts);
    }
    return rows;
}

void CellTable::keepEmptyRow() {
    const QScopedValueRollback<bool> filling(filling_, true);
    const int last = rowCount() - 1;
    bool empty = last >= 0;
    for (int column = 0; column < columnCount() && empty; ++column)
        empty = !item(last, column) || item(last, column)->text().isEmpty();
    if (empty || !growing_) return;
    insertRow(last + 1);
    for (int column = 0; column < columnCount(); ++column) put(last + 1, column, {});
}

void CellTable::fitHeight() {
    const int shown = std::clamp(rowCount(), 1, mostRowsInSight);
    setFixedHeight(cellHeadingHeight + shown * cellLine + 2);
    setVerticalScrollBarPolicy(rowCount() > mostRowsInSight ? Qt::ScrollBarAlwaysOn : Qt::ScrollBarAlwaysOff);
}

void CellTable::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Delete || event->key() == Qt::Key_Backspace)
        removeSelected();
    else if (event->matches(QKeySequence::Paste))
        paste();
    else if (event->matches(QKeySequence::Copy))
        copy();
    else
        QTableWidget::keyPressEvent(event);
}

void CellTable::focusInEvent(QFocusEvent* event) {
    QTableWidget::focusInEvent(event);
    Q_EMIT focused();
}

void CellTable::removeSelected() {
    if (!growing_) return;
    std::set<int> chosen;
    for (const QModelIndex& index : selectedIndexes()) chosen.insert(index.row());
    for (auto row = chosen.rbegin(); row != chosen.rend(); ++row) removeRow(*row);
    keepEmptyRow();
    fitHeight();
    Q_EMIT edited();
}

void CellTable::copy() const {
    QStringList lines;
    for (const QTableWidgetSelectionRange& range : selectedRanges())
        for (int row = range.topRow(); row <= range.bottomRow(); ++row) {
            QStringList cells;
            for (int column = range.leftColumn(); column <= range.rightColumn(); ++column)
                cells << (item(row, column) ? item(row, column)->text() : QString());
            lines << cells.join('\t');
        }
    QApplication::clipboard()->setText(lines.join('\n'));
}

/// Cells are separated by tabs if they were copied from a spreadsheet, otherwise by semicolons.
void CellTable::paste() {
    const QString text = QApplication::clipboard()->text();
    const QChar between = text.contains('\t') ? '\t' : ';';
    const int left = std::max(0, currentColumn());
    int row = std::max(0, currentRow());
    {
        const QScopedValueRollback<bool> filling(filling_, true);
        for (const QString& line : text.split('\n', Qt::SkipEmptyParts)) {
            if (row >= rowCount() && !growing_) break;
            if (row >= rowCount()) insertRow(row);
            const QStringList cells = line.split(between);
            for (int i = 0; i < cells.size() && left + i < columnCount(); ++i) put(row, left + i, cells[i].trimmed());
            ++row;
        }
    }
    keepEmptyRow();
    fitHeight();
    Q_EMIT edited();
}

}  // namespace keyblock
