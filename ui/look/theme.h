// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// All colours of the window by their role, for the light and the dark theme. Painting
// code takes its colours from here and repaints when the theme changes; widgets get
// theirs from a style sheet in which roles are written as `@role`.
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
    QColor text, text2, text3;  // text2: units and details; text3: hints and disabled items
    QColor accent, accentSoft, accentRow, onAccent;  // accent: only for what is selected, active or current
    QColor ok, warning, warningFill, warningSoft, error, errorSoft;
    QColor canvas, opening, rock, wall, jointLine, jointDrawing, chartGrid;
    QColor markInk, markCasing, slipping, yielded;
};

const Theme& lightTheme();
const Theme& darkTheme();

/// Holds the current theme, applies its palette and style sheet to the application, and saves the user's choice.
class Themes : public QObject {
    Q_OBJECT

public:
    explicit Themes(QObject* parent = nullptr);

    const Theme& current() const;
    bool isDark() const { return dark_; }
    void choose(bool dark);

    /// The icon `resources/icons/NAME.svg` in the colours of the theme: `accent` if it is checked, `text3` if it is
    /// disabled, otherwise `text2`.
    QIcon icon(const QString& name) const;
    /// The icon `resources/icons/NAME.svg` in a single colour.
    QIcon icon(const QString& name, const QColor& colour) const;

Q_SIGNALS:
    void changed();

private:
    void apply() const;

    bool dark_ = false;
    mutable QHash<QString, QIcon> inked_;  // cache by name and colour or theme, since trees need icons for every paint
};

}  // namespace keyblock
