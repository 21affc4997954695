// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The bar above the canvas that selects which results are shown and how.
#pragma once

#include <QWidget>

#include <array>
#include <vector>

class QComboBox;
class QHBoxLayout;
class QToolButton;

namespace keyblock {

class Commands;
class Themes;
class ViewSettings;

class ViewBar : public QWidget {
    Q_OBJECT

public:
    ViewBar(const Themes& themes, Commands& commands, ViewSettings& settings, QWidget* parent = nullptr);

    QSize minimumSizeHint() const override { return {220, 36}; }

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    QComboBox* addChoice(const char* name, const QString& title);
    QToolButton* addToggle(const char* name, const QString& text, const QString& tip, const char* icon);
    void fill();
    void addCommands();
    void take();
    void showChoice();
    void showIcons();
    void makeMore();
    std::vector<QWidget*> dispensable() const;
    void fit();

    const Themes& themes_;
    Commands& commands_;
    ViewSettings& settings_;
    QHBoxLayout* row_;
    QComboBox *blocks_, *bolts_, *ribbon_, *factor_, *arrows_;
    QToolButton *callOuts_, *contacts_, *activity_;
    std::vector<QToolButton*> toggles_;
    QToolButton* more_ = nullptr;  // menu for controls that do not fit
    std::vector<QWidget*> hidden_;  // controls that do not fit, from left to right
    bool hasCommands_ = false;
};

}  // namespace keyblock
