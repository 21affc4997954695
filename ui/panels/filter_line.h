// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lines whose hint is dimmed while they are empty, and one to search with.
#pragma once

#include <QLineEdit>

namespace keyblock {

class Themes;

/// Dims the hint of an empty line; a style sheet would give it the colour of typed text.
void dimHint(QLineEdit& line);

class FilterLine : public QLineEdit {
    Q_OBJECT

public:
    FilterLine(const Themes& themes, const QString& hint, QWidget* parent);
};

}  // namespace keyblock
