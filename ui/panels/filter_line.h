// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Line edits with a dimmed hint while they are empty, and one for searching.
#pragma once

#include <QLineEdit>

namespace keyblock {

class Themes;

/// Dims the hint of an empty line; with a style sheet it would have the colour of typed text.
void dimHint(QLineEdit& line);

class FilterLine : public QLineEdit {
    Q_OBJECT

public:
    FilterLine(const Themes& themes, const QString& hint, QWidget* parent);
};

}  // namespace keyblock
