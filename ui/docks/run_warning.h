// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A line above the results that says why the results of the stage shown are unreliable;
// hidden if they are not.
#pragma once

#include "ui/look/elided_label.h"

namespace keyblock {

class Themes;
class TimeCursor;

class RunWarning : public ElidedLabel {
    Q_OBJECT

public:
    RunWarning(const Themes& themes, const TimeCursor& cursor, QWidget* parent = nullptr);

    /// Hidden while the drawing is shown instead of results.
    void setOn(bool on);

private:
    void refresh();
    void showTheme();

    const Themes& themes_;
    const TimeCursor& cursor_;
    bool on_ = true;
};

}  // namespace keyblock
