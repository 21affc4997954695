// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The layouts of the docks: one arrangement for drawing, one for viewing results and one
// for studies. Each remembers which docks were moved, closed or floated. All can be saved
// together under a name, and the defaults can be restored at any time.
#pragma once

#include <QByteArray>
#include <QObject>
#include <QString>

#include <array>

class QDockWidget;
class QMainWindow;
class QMenu;
class QToolButton;

namespace keyblock {

class Commands;

enum class Arrangement { Drawing, Results, Studies };

class Layouts : public QObject {
    Q_OBJECT

public:
    /// Adds the commands for layouts, and one for each dock. \pre the window has all of its docks.
    Layouts(QMainWindow& window, Commands& commands);

    /// Restores the layout that the window had when it was last closed, or the default layout if none was saved.
    void begin();
    /// Switches to this arrangement, and restores the docks as they were when it was last used.
    void show(Arrangement arrangement);
    /// Saves all arrangements for the next start.
    void keep();
    void reset();
    /// Shows a dock in front. One that belongs to another arrangement becomes a tab, so that the others keep their room.
    void reveal(QDockWidget& dock);

    QStringList names() const;
    void save(const QString& name);  // replaces an existing layout with this name
    void load(const QString& name);
    void remove(const QString& name);
    const QString& current() const { return current_; }  // name of the saved layout in use; empty: none

    /// A button with a menu of saved layouts, for the corner of the menu bar.
    QToolButton* makeButton(QWidget* parent);

private:
    QByteArray& now() { return states_[static_cast<std::size_t>(arrangement_)]; }
    void apply();
    void addDockCommands(Commands& commands);
    void fillMenu(QMenu& menu);
    void setCurrent(const QString& name);

    QMainWindow& window_;
    Arrangement arrangement_ = Arrangement::Drawing;
    std::array<QByteArray, 3> states_;
    bool hasGuests_ = false;  // a dock was moved into a group of another arrangement
    QString current_;
    QToolButton* button_ = nullptr;
};

}  // namespace keyblock
