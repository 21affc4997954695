// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Dock layout: one arrangement for drawing, one for viewing results. Each remembers
// which docks were moved, closed or floated; both together can be saved under a name,
// and the defaults can always be restored.
#pragma once

#include <QByteArray>
#include <QObject>
#include <QString>

#include <array>

class QMainWindow;
class QMenu;
class QToolButton;

namespace keyblock {

class Commands;

enum class Arrangement { Drawing, Results };

class Layouts : public QObject {
    Q_OBJECT

public:
    /// Adds its commands, among them one for each dock. \pre the window has all of its docks.
    Layouts(QMainWindow& window, Commands& commands);

    /// Restores the docks as they were when the window was last closed, or the defaults.
    void begin();
    /// Shows the docks of an arrangement as they were last used in it.
    void show(Arrangement arrangement);
    /// Saves both arrangements for the next start.
    void keep();
    void reset();

    QStringList names() const;
    void save(const QString& name);  // replaces a layout of that name
    void load(const QString& name);
    void remove(const QString& name);
    const QString& current() const { return current_; }  // empty: none of the saved ones

    /// A button with the names of layouts, for the corner of the menu bar.
    QToolButton* makeButton(QWidget* parent);

private:
    QByteArray& now() { return states_[static_cast<std::size_t>(arrangement_)]; }
    void apply();
    void addDockCommands(Commands& commands);
    void fillMenu(QMenu& menu);
    void setCurrent(const QString& name);

    QMainWindow& window_;
    Arrangement arrangement_ = Arrangement::Drawing;
    std::array<QByteArray, 2> states_;
    QString current_;
    QToolButton* button_ = nullptr;
};

}  // namespace keyblock
