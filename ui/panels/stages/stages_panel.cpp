// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/stages/stages_panel.h"

#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/edit/edits.h"
#include "ui/look/display.h"
#include "ui/look/plain_text.h"
#include "ui/look/theme.h"
#include "ui/panels/calm_box.h"
#include "ui/panels/stages/plan_view.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QScopedValueRollback>
#include <QSplitter>
#include <QTimer>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace keyblock {

namespace {

enum Column { NameColumn, KindColumn, EndColumn, DeedsColumn };

QString pointerOf(int stage) { return QString("/stages/%1").arg(stage); }

}  // namespace

StagesPanel::StagesPanel(const FormContext& context, Selection& selection, QWidget* parent)
    : QWidget(parent), context_(context), selection_(selection), list_(new QTreeWidget(this)),
      plan_(new PlanView(context.themes, this)), later_(new QTimer(this)) {
    setObjectName("stagesPanel");
    setAttribute(Qt::WA_StyledBackground);
    list_->setObjectName("stageList");
    list_->setAccessibleName(tr("Stages"));
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->setHeaderLabels({tr("Stage"), tr("Type"), tr("Ends"), tr("Actions")});
    list_->header()->setStretchLastSection(true);
    list_->setColumnWidth(NameColumn, 150);
    list_->setColumnWidth(KindColumn, 96);
    list_->setColumnWidth(EndColumn, 96);
    list_->setEditTriggers(QAbstractItemView::EditKeyPressed | QAbstractItemView::DoubleClicked);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    row->addWidget(makeButtons());
    auto* split = new QSplitter(this);
    split->setHandleWidth(1);
    split->addWidget(list_);
    split->addWidget(plan_);
    split->setSizes({560, 480});
    row->addWidget(split, 1);
    later_->setSingleShot(true);
    later_->setInterval(0);
    const auto schedule = [this] {
        if (!context_.document.isPreviewing()) later_->start();
    };
    connect(later_, &QTimer::timeout, this, &StagesPanel::refresh);
    connect(&context.document, &Document::changed, this, schedule);
    connect(&context.display, &Display::changed, this, schedule);
    connect(&selection, &Selection::changed, this, &StagesPanel::showSelection);
    connect(list_, &QTreeWidget::itemSelectionChanged, this, &StagesPanel::takeSelection);
    connect(list_, &QTreeWidget::itemChanged, this, &StagesPanel::rename);
    connect(plan_, &PlanView::cellChosen, this, &StagesPanel::togglePlan);
    connect(&context.themes, &Themes::changed, this, [this] {
        for (QToolButton* one : buttons_) one->setIcon(context_.themes.icon(one->property("icon").toString()));
    });
    refresh();
}

QToolButton* StagesPanel::button(QWidget* parent, const char* icon, const QString& name, void (StagesPanel::*act)()) {
    auto* made = new QToolButton(parent);
    made->setProperty("icon", icon);
    made->setIcon(context_.themes.icon(icon));
    made->setFixedSize(28, 28);
    made->setToolTip(name);
    made->setAccessibleName(name);
    connect(made, &QToolButton::clicked, this, act);
    buttons_ << made;
    return made;
}

QWidget* StagesPanel::makeButtons() {
    auto* bar = new QWidget(this);
    bar->setObjectName("stageButtons");
    bar->setAttribute(Qt::WA_StyledBackground);
    auto* column = new QVBoxLayout(bar);
    column->setContentsMargins(4, 4, 4, 4);
    column->setSpacing(2);
    column->addWidget(button(bar, "plus", tr("Add a static stage"), &StagesPanel::addStatic));
    column->addWidget(button(bar, "shake", tr("Add a dynamic stage"), &StagesPanel::addDynamic));
    column->addWidget(button(bar, "copy", tr("Duplicate the stage"), &StagesPanel::duplicate));
    column->addWidget(button(bar, "up", tr("Move the stage earlier"), &StagesPanel::moveUp));
    column->addWidget(button(bar, "down", tr("Move the stage later"), &StagesPanel::moveDown));
    column->addWidget(button(bar, "delete", tr("Remove the stage"), &StagesPanel::remove));
    column->addStretch(1);
    return bar;
}

void StagesPanel::fillRow(QTreeWidgetItem& item, std::size_t stage) {
    const Scene& scene = *context_.document.scene();
    const Stage& held = scene.stages[stage];
    const QString deeds = stageDeeds(held, context_.display).join(QString::fromUtf8(" · "));
    item.setFlags(item.flags() | Qt::ItemIsEditable);
    item.setText(NameColumn, QString::fromStdString(held.name));
    item.setText(EndColumn, stageEnd(held, context_.display));
    item.setToolTip(EndColumn, asTip(item.text(EndColumn)));
    item.setText(DeedsColumn, deeds.isEmpty() ? tr("settles") : deeds);
    item.setToolTip(DeedsColumn, asTip(item.text(DeedsColumn)));
    auto* box = static_cast<QComboBox*>(list_->itemWidget(&item, KindColumn));
    if (!box) {
        box = new CalmBox(list_);
        box->addItems({"static", "dynamic"});
        box->setFrame(false);
        box->setFixedHeight(22);
        connect(box, QOverload<int>::of(&QComboBox::activated), this,
                [this, stage](int kind) {
                    setKind(static_cast<int>(stage), kind == 0 ? StageKind::Static : StageKind::Dynamic);
                });
        list_->setItemWidget(&item, KindColumn, box);
    }
    box->setAccessibleName(tr("Type of %1").arg(item.text(NameColumn)));
    box->setCurrentIndex(held.kind == StageKind::Static ? 0 : 1);
}

void StagesPanel::refresh() {
    later_->stop();
    const Scene& scene = *context_.document.scene();
    {
        const QScopedValueRollback<bool> filling(filling_, true);
        while (list_->topLevelItemCount() > static_cast<int>(scene.stages.size()))
            delete list_->takeTopLevelItem(list_->topLevelItemCount() - 1);
        while (list_->topLevelItemCount() < static_cast<int>(scene.stages.size()))
            list_->addTopLevelItem(new QTreeWidgetItem);
        QStringList names;
        for (std::size_t i = 0; i < scene.stages.size(); ++i) {
            fillRow(*list_->topLevelItem(static_cast<int>(i)), i);
            names << QString::fromStdString(scene.stages[i].name);
        }
        plan_->plan().show(stagePlan(scene), names);
    }
    showSelection();
}

int StagesPanel::chosen() const {
    const auto items = list_->selectedItems();
    return items.isEmpty() ? -1 : list_->indexOfTopLevelItem(items.front());
}

void StagesPanel::showSelection() {
    const QScopedValueRollback<bool> filling(filling_, true);
    for (int i = 0; i < list_->topLevelItemCount(); ++i)
        list_->topLevelItem(i)->setSelected(selection_.contains(pointerOf(i)));
}

void StagesPanel::takeSelection() {
    if (filling_ || chosen() < 0) return;
    selection_.set({pointerOf(chosen())});
}

void StagesPanel::apply(const QString& step, Edit edit, const QString& select) {
    const bool done = context_.document.apply(step, std::move(edit));
    refresh();
    if (done && !select.isEmpty()) selection_.set({select});
}

void StagesPanel::rename(QTreeWidgetItem* item) {
    if (filling_) return;
    const int stage = list_->indexOfTopLevelItem(item);
    const Scene& scene = *context_.document.scene();
    if (stage >= static_cast<int>(scene.stages.size())) return;  // just gone
    const QString before = QString::fromStdString(scene.stages[stage].name);
    if (item->text(NameColumn) == before) return;
    apply(tr("Rename %1").arg(QString::fromStdString(titleAt(scene, pointerOf(stage).toStdString()))),
          renameAt(scene, pointerOf(stage).toStdString(), item->text(NameColumn).trimmed().toStdString()), {});
}

void StagesPanel::setKind(int stage, StageKind kind) {
    const Scene& scene = *context_.document.scene();
    const QString name = QString::fromStdString(nameAt(scene, pointerOf(stage).toStdString()));
    apply((kind == StageKind::Dynamic ? tr("Make %1 dynamic") : tr("Make %1 static")).arg(name),
          withStageKind(scene, static_cast<std::size_t>(stage), kind), {});
}

void StagesPanel::togglePlan(int row, int stage) {
    const Scene& scene = *context_.document.scene();
    const PlanRow thing = plan_->plan().planRow(row);
    const std::size_t at = stage;
    if (at >= scene.stages.size()) return;  // just gone
    apply(toggledName(scene, thing, at), toggled(scene, thing, at), {});
}

void StagesPanel::addStatic() { add(StageKind::Static); }

void StagesPanel::addDynamic() { add(StageKind::Dynamic); }

void StagesPanel::add(StageKind kind) {
    Edit edit = appendAt(*context_.document.scene(), "/stages");
    const QString made = QString::fromStdString(edit.made);
    edit = withStageKind(edit.scene, edit.scene.stages.size() - 1, kind);
    const QString title = QString::fromStdString(titleAt(edit.scene, made.toStdString()));
    apply(tr("Add %1").arg(title), std::move(edit), made);
}

void StagesPanel::duplicate() {
    if (chosen() < 0) return;
    const Scene& scene = *context_.document.scene();
    const std::string pointer = pointerOf(chosen()).toStdString();
    std::vector<std::string> made;
    Edit edit = copyAll(scene, scene, {pointer}, Point(0.0, 0.0), made);
    if (!edit.done()) return apply({}, std::move(edit), {});
    const int to = chosen() + 1;
    const QString step = tr("Duplicate %1").arg(QString::fromStdString(titleAt(scene, pointer)));
    apply(step, moveAt(edit.scene, made.front(), static_cast<std::size_t>(to)), pointerOf(to));
}

void StagesPanel::remove() {
    if (chosen() < 0) return;
    const Scene& scene = *context_.document.scene();
    const std::string pointer = pointerOf(chosen()).toStdString();
    const int left = static_cast<int>(scene.stages.size()) - 1;
    const QString next = left > 0 ? pointerOf(std::min(chosen(), left - 1)) : QString();
    if (next.isEmpty()) selection_.clear();
    apply(tr("Remove %1").arg(QString::fromStdString(titleAt(scene, pointer))), removeAt(scene, pointer), next);
}

void StagesPanel::move(int by) {
    const int to = chosen() + by;
    if (chosen() < 0 || to < 0 || to >= list_->topLevelItemCount()) return;
    const Scene& scene = *context_.document.scene();
    const std::string pointer = pointerOf(chosen()).toStdString();
    apply(tr("Move %1").arg(QString::fromStdString(titleAt(scene, pointer))),
          moveAt(scene, pointer, static_cast<std::size_t>(to)), pointerOf(to));
}

}  // namespace keyblock
