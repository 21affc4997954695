// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The Stages dock: the list of stages and the stage plan. The Properties panel shows
// the loads and tables of the stage selected here.
#pragma once

#include "ui/panels/editors/value_editor.h"

#include <QWidget>

class QTimer;
class QToolButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace keyblock {

class PlanView;
class Selection;
struct Edit;
enum class StageKind;

class StagesPanel : public QWidget {
    Q_OBJECT

public:
    StagesPanel(const FormContext& context, Selection& selection, QWidget* parent = nullptr);

    PlanView& plan() const { return *plan_; }

    /// Updates the panel immediately to show the current scene, without waiting for the event loop.
    void refresh();

private:
    QWidget* makeButtons();
    QToolButton* button(QWidget* parent, const char* icon, const QString& name, void (StagesPanel::*act)());
    void fillRow(QTreeWidgetItem& item, std::size_t stage);
    void showSelection();
    void takeSelection();
    void rename(QTreeWidgetItem* item);
    void togglePlan(int row, int stage);
    void addStatic();
    void addDynamic();
    void add(StageKind kind);
    void duplicate();
    void remove();
    void moveUp() { move(-1); }
    void moveDown() { move(1); }
    void move(int by);
    void setKind(int stage, StageKind kind);
    int chosen() const;
    void apply(const QString& step, Edit edit, const QString& select);

    FormContext context_;
    Selection& selection_;
    bool filling_ = false;
    QTreeWidget* list_;
    PlanView* plan_;
    QList<QToolButton*> buttons_;
    QTimer* later_;
};

}  // namespace keyblock
