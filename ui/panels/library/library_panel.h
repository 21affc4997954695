// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The bolt library dock: each bolt type with its values, their sources and its strength
// curves. A built-in type has to be copied into the scene before it can be edited.
#pragma once

#include "ui/panels/editors/value_editor.h"
#include "ui/panels/library/library_rows.h"

#include <QWidget>

class QLabel;
class QPushButton;
class QScrollArea;
class QTimer;
class QTreeWidget;
class QVBoxLayout;

namespace keyblock {

class FilterLine;
class Selection;
class TableChart;

class LibraryPanel : public QWidget {
    Q_OBJECT

public:
    LibraryPanel(const FormContext& context, Selection& selection, QWidget* parent = nullptr);

    /// Shows the bolt type with this name.
    void choose(const QString& name);
    QString chosen() const { return chosen_; }

    /// Adds a copy of the bolt type shown to the scene under an unused name, and selects the copy.
    void copyIntoScene();

    /// Assigns the bolt type shown to all selected bolts and patterns.
    void assign();

    void refresh();

private:
    QWidget* makeList();
    QWidget* makeHead();
    void fillList(const std::vector<LibraryEntry>& entries);
    void showType(const LibraryEntry& entry);
    void showCurves(const BoltType& type);
    void showButtons();
    QStringList assignable() const;

    FormContext context_;
    Selection& selection_;
    QString chosen_;
    FilterLine* filter_;
    QTreeWidget *list_, *numbers_;
    QLabel *title_, *source_;
    QPushButton *copy_, *assign_;
    QWidget* curves_;
    QVBoxLayout* curveColumn_;
    QTimer* later_;
    bool filling_ = false;
};

}  // namespace keyblock
