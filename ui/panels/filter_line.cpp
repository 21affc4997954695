// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/filter_line.h"

#include "ui/look/theme.h"

#include <QAction>
#include <QStyle>

namespace keyblock {

void dimHint(QLineEdit& line) {
    const auto dim = [&line] {
        if (line.property("empty").toBool() == line.text().isEmpty()) return;
        line.setProperty("empty", line.text().isEmpty());
        line.style()->unpolish(&line);
        line.style()->polish(&line);
    };
    dim();
    QObject::connect(&line, &QLineEdit::textChanged, &line, dim);
}

FilterLine::FilterLine(const Themes& themes, const QString& hint, QWidget* parent) : QLineEdit(parent) {
    setPlaceholderText(hint);
    setAccessibleName(hint);
    setClearButtonEnabled(true);
    setFixedHeight(26);
    QAction* search = addAction(themes.icon("search"), LeadingPosition);
    connect(&themes, &Themes::changed, this, [search, &themes] { search->setIcon(themes.icon("search")); });
    dimHint(*this);
}

}  // namespace keyblock
