// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The bar above the canvas: the active tool, its options, Cancel, and the primary
// button that commits the input.
#pragma once

#include <QWidget>

#include <vector>

class QLabel;
class QPushButton;
class QToolButton;

namespace keyblock {

class Display;
class Themes;
class Tool;
class ToolChip;

class ToolBar : public QWidget {
    Q_OBJECT

public:
    ToolBar(const Display& display, const Themes& themes, QWidget* parent = nullptr);

    /// Shows this tool, or updates it if it is shown already; null: no tool. The bar does not own the tool.
    void show(Tool* tool);
    using QWidget::show;

Q_SIGNALS:
    void cancelled();
    void committed();
    void leftField();  // the keyboard focus returns to the canvas

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void layOut();
    void showMore();
    void rebuild(Tool& tool);
    void showIcon();

    const Display& display_;
    const Themes& themes_;
    QLabel* icon_;
    QLabel* title_;
    QWidget* options_;
    QToolButton* more_;
    QPushButton* cancel_;
    QPushButton* commit_;
    std::vector<ToolChip*> chips_;
    Tool* tool_ = nullptr;
};

}  // namespace keyblock
