// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A small table in which a person edits rows of texts: the last row is empty and
// waits for more, Delete takes rows out, rows are pasted from a spreadsheet.
#pragma once

#include <QStringList>
#include <QTableWidget>

#include <vector>

namespace keyblock {

class CellTable : public QTableWidget {
    Q_OBJECT

public:
    CellTable(const QStringList& headings, bool numbers, QWidget* parent);

    /// False where the number of rows is fixed: none are added or taken out.
    void setGrowing(bool growing) { growing_ = growing; }

    void setRows(const std::vector<QStringList>& rows);

    /// Rows that hold something.
    std::vector<QStringList> rows() const;

    void setHeadings(const QStringList& headings);

Q_SIGNALS:
    void edited();
    void focused();

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;

private:
    void removeSelected();
    void paste();
    void copy() const;
    void put(int row, int column, const QString& text);
    void fitHeight();
    void keepEmptyRow();

    bool numbers_;
    bool growing_ = true;
    bool filling_ = false;
};

}  // namespace keyblock
