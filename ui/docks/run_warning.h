// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A line above the results that says why the numbers of the stage shown are
// doubtful; without such a reason it is hidden.
#pragma once

#include "ui/look/elided_label.h"

namespace keyblock {

class Themes;
class TimeCursor;

class RunWarning : public ElidedLabel {
    Q_OBJECT

public:
    RunWarning(const Themes& themes, const TimeCursor& cursor, QWidget* parent = nullptr);

    /// Hidden where the drawing is shown instead of results.
    void setOn(bool on);

private:
    void refresh();
    void showTheme();

    const Themes& themes_;
    const TimeCursor& cursor_;
    bool on_ = true;
};

}  // namespace keyblock
