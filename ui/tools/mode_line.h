// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Switches in the status bar for object snap, ortho and grid snap, each with its key.
#pragma once

#include <QWidget>

namespace keyblock {

class Commands;
class Themes;

class ModeLine : public QWidget {
    Q_OBJECT

public:
    ModeLine(const Commands& commands, const Themes& themes, QWidget* parent = nullptr);
};

}  // namespace keyblock
