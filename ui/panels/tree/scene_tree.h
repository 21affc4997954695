// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tree at the left of the window: all objects of the scene by kind. It shares its
// selection with the other panels.
#pragma once

#include "ui/panels/tree/tree_nodes.h"

#include <QSet>
#include <QWidget>

class QMenu;
class QModelIndex;
class QTimer;
class QToolButton;

namespace keyblock {

class Commands;
class Display;
class Document;
class FilterLine;
class Selection;
class Themes;
class TreeModel;
class TreeView;
class Visibility;

class SceneTree : public QWidget {
    Q_OBJECT

public:
    SceneTree(Document& document, Selection& selection, Visibility& visibility, const Display& display,
              const Commands& commands, const Themes& themes, QWidget* parent = nullptr);

    /// Sets the runs of the scene, in the order in which they are listed under Results.
    void setRuns(std::vector<RunRow> runs);

    /// The header of the dock: title, filter and Add button.
    QWidget* header() const { return header_; }

    TreeView& view() const { return *view_; }

    /// Selects the in-situ stress. If the scene has none, it is added first.
    void addInSituStress();

    /// Updates the tree immediately to show the current scene, without waiting for the event loop.
    void refresh();

Q_SIGNALS:
    void runChosen(const QString& id);
    void zoomAsked(const QStringList& pointers);

protected:
    bool eventFilter(QObject* object, QEvent* event) override;

private:
    void makeHeader();
    void fillAddMenu();
    void addItem(const QString& list);
    void showSelection();
    void takeSelection();
    void openMenu(const QPoint& place);
    void activate(const QModelIndex& index);
    void rename(const QString& pointer, const QString& name);
    void moveStage(const QString& pointer, int to);
    void duplicate();
    void remove();
    bool isKeyOf(const char* command, const QKeyEvent& key) const;
    QString withKeys(const QString& text, const char* command) const;
    TreeSource source() const;
    QModelIndex openTo(const QString& pointer);
    QString chosenTitle() const;

    Document& document_;
    Selection& selection_;
    Visibility& visibility_;
    const Display& display_;
    const Commands& commands_;
    const Themes& themes_;
    std::vector<RunRow> runs_;
    QString filter_;
    QSet<QString> open_, seen_;  // ids of headings
    bool follows_ = false;  // the tree is being updated from the selection
    bool sought_ = false;  // the selection is new and the tree has not scrolled to it yet
    QWidget* header_;
    FilterLine* line_;
    QToolButton *filterButton_, *addButton_;
    QMenu* addMenu_;
    TreeModel* model_;
    TreeView* view_;
    QTimer* later_;
};

}  // namespace keyblock
