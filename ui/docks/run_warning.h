// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A line above the results that explains why the results of the stage shown are
// unreliable; hidden if they are reliable.
#pragma once

#include "ui/look/elided_label.h"

#include <string>

namespace keyblock {

class Themes;
class TimeCursor;

class RunWarning : public ElidedLabel {
    Q_OBJECT

public:
    RunWarning(const Themes& themes, const TimeCursor& cursor, QWidget* parent = nullptr);

    /// Turns the warning line on or off; it is off while the window shows the drawing.
    void setOn(bool on);

    /// Says what of the frame shown is not drawn because it is not finite; empty: everything is drawn.
    void setNotFinite(const std::string& text);

private:
    void refresh();
    void showTheme();

    const Themes& themes_;
    const TimeCursor& cursor_;
    bool on_ = true;
    QString notFinite_;
};

}  // namespace keyblock
