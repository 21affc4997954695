// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A small table with text cells that the user can edit. The last row is always empty,
// for a new entry; Delete removes rows, and rows can be pasted from a spreadsheet.
#pragma once

#include <QStringList>
#include <QTableWidget>

#include <vector>

namespace keyblock {

class CellTable : public QTableWidget {
    Q_OBJECT

public:
    CellTable(const QStringList& headings, bool numbers, QWidget* parent);

    /// Sets whether rows can be added and removed. False: the number of rows is fixed.
    void setGrowing(bool growing) { growing_ = growing; }

    void setRows(const std::vector<QStringList>& rows);

    /// All rows that are not empty.
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
