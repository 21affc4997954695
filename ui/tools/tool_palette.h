// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tools as a column of buttons at the left of the canvas, each with the letter
// of its key.
#pragma once

#include <QWidget>

#include <vector>

class QAction;
class QVBoxLayout;

namespace keyblock {

class Themes;

class ToolPalette : public QWidget {
    Q_OBJECT

public:
    explicit ToolPalette(const Themes& themes, QWidget* parent = nullptr);

    void add(QAction* action, const QString& name);
    void addLine();

    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    const Themes& themes_;
    QVBoxLayout* column_;
    std::vector<QWidget*> lines_;
};

}  // namespace keyblock
