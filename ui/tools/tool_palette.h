// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tools as a column of buttons at the left of the canvas, each labelled with its
// key. A second column is added if the window is too low for one.
#pragma once

#include <QWidget>

#include <vector>

class QAction;

namespace keyblock {

class Themes;

class ToolPalette : public QWidget {
    Q_OBJECT

public:
    explicit ToolPalette(const Themes& themes, QWidget* parent = nullptr);

    void add(QAction* action, const QString& name);
    void addLine();

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void layOut();

    const Themes& themes_;
    std::vector<QWidget*> items_, lines_;  // items_ includes the separators
};

}  // namespace keyblock
