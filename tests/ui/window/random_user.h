// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A user who clicks, drags, draws, types, drops files and calls commands at random,
// wherever possible, and answers dialogs at random. Counts what was reached, so that a
// test can check that all parts were used.
#pragma once

#include <QPoint>
#include <QStringList>
#include <QTimer>

#include <map>
#include <random>
#include <string>

class QAction;
class QMenu;
class QObject;
class QWidget;

namespace keyblock {

class Commands;
class MainWindow;

class RandomUser {
public:
    /// `files` are dropped on the window.
    RandomUser(MainWindow& window, unsigned seed, QStringList files);

    void act();

    const std::string& last() const { return last_; }
    /// Number of times each thing was done or reached, as `tool tool.bolt`, `dialog QFileDialog`, `undo`.
    const std::map<std::string, int>& counts() const { return counts_; }
    int countOf(const std::string& beginning) const;  // sum over all names that begin so

private:
    int below(int count) { return std::uniform_int_distribution(0, count - 1)(random_); }
    QWidget* anyWidget();
    QPoint anyPlace(const QWidget& widget);
    QWidget* focused();
    void tell(const std::string& what, const QObject& object);
    void noteWhere();

    void click();
    void drag();
    void draw();
    void wheel();
    void key();
    void type();
    void command();
    void undoOrRedo();
    void run();
    void askMenu();
    void closeWindows();
    void drop();
    void answer();
    void answer(QMenu& menu);
    void answer(QWidget& dialog);
    bool mayDo(const QAction& action) const;

    MainWindow& window_;
    const Commands& commands_;
    QStringList files_;
    std::mt19937 random_;
    QTimer answering_;
    std::string last_;
    std::map<std::string, int> counts_;
};

}  // namespace keyblock
