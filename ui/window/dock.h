// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Docks with a header of 30 px. Where several share a place, their tabs are the
// header and no second one stands below.
#pragma once

#include <QString>

class QDockWidget;
class QMainWindow;
class QWidget;

namespace keyblock {

class Themes;

constexpr int treeWidth = 236, propertyWidth = 300;  // [px] of the docks at the sides, at first

/// Makes a dock around the widget; `id` is kept in layouts. The header shows `title` and buttons to float and close.
QDockWidget* makeDock(QMainWindow& window, const Themes& themes, const QString& id, const QString& title,
                      QWidget* widget);

/// A dock without header that stays where it is.
QDockWidget* makeBand(QMainWindow& window, const QString& id, const QString& title, QWidget* widget);

}  // namespace keyblock
