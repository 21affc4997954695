// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One option of a tool in the tool bar: label, value and unit in one frame.
#pragma once

#include "ui/tools/tool_field.h"

#include <QFrame>

class QComboBox;
class QLineEdit;

namespace keyblock {

class Display;
class Themes;

class ToolChip : public QFrame {
    Q_OBJECT

public:
    ToolChip(ToolField field, const Display& display, const Themes& themes, QWidget* parent);

    const QString& id() const { return field_.id; }
    /// Updates the value shown, unless the user is editing it.
    void refresh(ToolField field);
    /// Gives the option the keyboard focus and selects its text.
    void enter();

Q_SIGNALS:
    void done();  // Enter or Esc: the keyboard focus returns to the canvas
    void passed(bool forwards);  // Tab or Shift+Tab: the input is accepted and the focus moves to another option

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void makeChoice();
    void makeEdit();
    void showValue();
    void showTheme();
    bool isPassing(QEvent& event);
    void take(bool finally);
    void setWrong(const QString& problem);
    QString shownUnit() const;

    ToolField field_;
    const Display& display_;
    const Themes& themes_;
    QComboBox* choice_ = nullptr;
    QLineEdit* edit_ = nullptr;
};

}  // namespace keyblock
