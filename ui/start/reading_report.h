// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lists the parts of a scene file that could not be read, each with its line, next to
// the text of the file.
#pragma once

#include <QWidget>

class QLabel;
class QPlainTextEdit;
class QTreeWidget;

namespace keyblock {

class Themes;
struct PartReading;

class ReadingReport : public QWidget {
    Q_OBJECT

public:
    explicit ReadingReport(const Themes& themes, QWidget* parent = nullptr);

    void show(const PartReading& reading);

private:
    void goTo(int line);

    const Themes& themes_;
    QLabel* title_;
    QTreeWidget* problems_;
    QPlainTextEdit* text_;
};

}  // namespace keyblock
