// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One option of a tool in the bar: label, value and unit in one frame.
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
    /// Shows the value again, of the field as the tool gives it now; not what a person is typing.
    void refresh(ToolField field);
    /// Puts the cursor into it, with all of its text selected.
    void enter();

Q_SIGNALS:
    void done();  // Enter or Esc: the keys belong to the canvas again
    void passed(bool forwards);  // Tab, or Shift+Tab: what was typed is taken, the next field has the keys

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
