// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A search field, and the dimmed hint in empty line edits.
#pragma once

#include <QLineEdit>

namespace keyblock {

class Themes;

/// Dims the placeholder text of a line edit. The style sheet would otherwise give it the colour of typed text.
void dimHint(QLineEdit& line);

class FilterLine : public QLineEdit {
    Q_OBJECT

public:
    FilterLine(const Themes& themes, const QString& hint, QWidget* parent);
};

}  // namespace keyblock
