// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Docks with a header of 30 px. Docks in a tab group have their tabs as header, without
// a second one below.
#pragma once

#include <QString>

class QDockWidget;
class QMainWindow;
class QWidget;

namespace keyblock {

class Themes;

constexpr int treeWidth = 236, propertyWidth = 300;  // [px] initial width of the docks at the sides

/// Makes a dock around the widget; `id` is saved in layouts. The header shows `title` and buttons to float and close.
QDockWidget* makeDock(QMainWindow& window, const Themes& themes, const QString& id, const QString& title,
                      QWidget* widget);

/// A dock without header that cannot be moved.
QDockWidget* makeBand(QMainWindow& window, const QString& id, const QString& title, QWidget* widget);

}  // namespace keyblock
