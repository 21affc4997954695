// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Switches for object snap, ortho and grid snap with their keys in the status bar.
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
