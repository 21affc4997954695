// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Docks with a header 30 px high. In a tab group the tabs serve as the header, and no
// second header is shown below them.
#pragma once

#include <QString>

class QDockWidget;
class QMainWindow;
class QWidget;

namespace keyblock {

class Themes;

constexpr int treeWidth = 236, propertyWidth = 300;  // initial width of the docks at the sides [px]

/// Makes a dock around the widget. Saved layouts refer to the dock by `id`. The header shows `title` and buttons to
/// float and close the dock.
QDockWidget* makeDock(QMainWindow& window, const Themes& themes, const QString& id, const QString& title,
                      QWidget* widget);

/// Makes a dock without a header that cannot be moved.
QDockWidget* makeBand(QMainWindow& window, const QString& id, const QString& title, QWidget* widget);

}  // namespace keyblock
