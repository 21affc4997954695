// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every colour of the window by its role, light and dark. Painting code takes its
// colours here and repaints when the theme changes; widgets get theirs from a style
// sheet in which roles are written as `@role`.
#pragma once

#include <QColor>
#include <QHash>
#include <QIcon>
#include <QObject>
#include <QString>

namespace keyblock {

struct Theme {
    bool dark = false;
    QColor window, panel, header, field, separator, border;
    QColor text, text2, text3;  // text2: units, details; text3: hints, hidden
    QColor accent, accentSoft, accentRow, onAccent;  // accent: selected, active, now, and nothing else
    QColor ok, warning, warningFill, warningSoft, error, errorSoft;
    QColor canvas, opening, rock, wall, jointLine, jointDrawing, chartGrid;
    QColor markInk, markCasing, slipping, yielded;
};

const Theme& lightTheme();
const Theme& darkTheme();

/// The current theme. Applies palette and style sheet to the application, and saves the choice.
class Themes : public QObject {
    Q_OBJECT

public:
    explicit Themes(QObject* parent = nullptr);

    const Theme& current() const;
    bool isDark() const { return dark_; }
    void choose(bool dark);

    /// Icon `resources/icons/NAME.svg` in the colours of the theme: text2, accent when on, text3 when disabled.
    QIcon icon(const QString& name) const;
    /// The same in one colour.
    QIcon icon(const QString& name, const QColor& colour) const;

Q_SIGNALS:
    void changed();

private:
    void apply() const;

    bool dark_ = false;
    mutable QHash<QString, QIcon> inked_;  // by name and colour or theme: trees need it at every paint
};

}  // namespace keyblock
