// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/key_sheet.h"

#include "ui/look/commands.h"
#include "ui/look/theme.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>
#include <QVariant>

#include <algorithm>

namespace keyblock {

namespace {

constexpr int groupRole = Qt::UserRole + 1;

QString commandName(const QAction* action) { return action->text().remove(QStringLiteral("…")).remove('&'); }

QString keysOf(const QAction* action) {
    QStringList all;
    for (const QKeySequence& keys : action->shortcuts())
        if (!keys.isEmpty()) all << keys.toString(QKeySequence::NativeText);
    return all.join(", ");
}

}  // namespace

QAction* commandWithKeys(const Commands& commands, const QKeySequence& keys, const QAction* but) {
    if (keys.isEmpty()) return nullptr;
    for (QAction* action : commands.all())
        if (action != but && action->shortcuts().contains(keys)) return action;
    return nullptr;
}

KeySheet::KeySheet(Commands& commands, const Themes& themes, QWidget* parent)
    : QWidget(parent), commands_(commands), themes_(themes), filter_(new QLineEdit(this)),
      sheet_(new QTreeWidget(this)) {
    setObjectName("keySheet");
    filter_->setObjectName("keySheet.filter");
    filter_->setAccessibleName(tr("Filter commands and shortcuts"));
    filter_->setPlaceholderText(filter_->accessibleName());
    filter_->setClearButtonEnabled(true);
    sheet_->setObjectName("keySheet.list");
    sheet_->setAccessibleName(tr("Commands and their keyboard shortcuts"));
    sheet_->setHeaderLabels({tr("Command"), tr("Shortcut"), tr("Description")});
    sheet_->setRootIsDecorated(false);
    sheet_->setIndentation(12);
    sheet_->header()->setStretchLastSection(true);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 12, 12, 12);
    column->setSpacing(8);
    column->addWidget(filter_);
    column->addWidget(sheet_, 1);
    column->addWidget(makeEditor());
    connect(filter_, &QLineEdit::textChanged, this, &KeySheet::filter);
    connect(sheet_, &QTreeWidget::currentItemChanged, this, &KeySheet::showChosen);
    connect(&commands, &Commands::keysChanged, this, &KeySheet::list);
    list();
}

QWidget* KeySheet::makeEditor() {
    auto* editor = new QWidget(this);
    name_ = new QLabel(editor);
    conflict_ = new QLabel(editor);
    conflict_->setObjectName("keyConflict");
    conflict_->setWordWrap(true);
    keys_ = new QKeySequenceEdit(editor);
    keys_->setObjectName("keySheet.keys");
    keys_->setAccessibleName(tr("New shortcut"));
    if (auto* line = keys_->findChild<QLineEdit*>()) line->setAccessibleName(tr("New shortcut"));
    set_ = new QPushButton(tr("Set"), editor);
    original_ = new QPushButton(tr("Restore default"), editor);
    for (QPushButton* button : {set_, original_}) {
        button->setAccessibleName(button->text());
        button->setObjectName("keySheet." + button->text());
    }
    auto* row = new QHBoxLayout;
    row->addWidget(name_, 1);
    row->addWidget(keys_);
    row->addWidget(set_);
    row->addWidget(original_);
    auto* column = new QVBoxLayout(editor);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    column->addLayout(row);
    column->addWidget(conflict_);
    connect(keys_, &QKeySequenceEdit::keySequenceChanged, this, &KeySheet::showConflict);
    connect(set_, &QPushButton::clicked, this, &KeySheet::change);
    connect(original_, &QPushButton::clicked, this, &KeySheet::restore);
    showChosen();
    return editor;
}

QTreeWidgetItem* KeySheet::groupOf(const QString& menu) const {
    const int groups = sheet_->topLevelItemCount();
    for (int i = 0; i < groups; ++i)
        if (sheet_->topLevelItem(i)->data(0, groupRole).toString() == menu) return sheet_->topLevelItem(i);
    return sheet_->topLevelItem(groups - 1);
}

void KeySheet::list() {
    const QString kept = chosen() ? chosen()->objectName() : QString();
    sheet_->clear();
    QTreeWidgetItem* again = nullptr;
    QFont bold = font();
    bold.setWeight(QFont::DemiBold);
    for (const char* menu : {"File", "Edit", "View", "Insert", "Run", "Results", "Tools", "Help", ""}) {
        auto* group = new QTreeWidgetItem(sheet_, {*menu ? QString(menu) : tr("Other")});
        group->setData(0, groupRole, QString(menu));
        group->setFont(0, bold);
        group->setFlags(Qt::ItemIsEnabled);
    }
    for (const QAction* action : commands_.all()) {
        QTreeWidgetItem* group = groupOf(commands_.menuOf(action));
        auto* item = new QTreeWidgetItem(group, {commandName(action), keysOf(action), action->statusTip()});
        item->setData(0, Qt::UserRole, action->objectName());
        if (action->objectName() == kept) again = item;
    }
    sheet_->expandAll();
    for (const int column : {0, 1}) sheet_->resizeColumnToContents(column);
    filter();
    sheet_->setCurrentItem(again);
}

void KeySheet::filter() {
    const QString typed = filter_->text();
    for (int i = 0; i < sheet_->topLevelItemCount(); ++i) {
        QTreeWidgetItem* group = sheet_->topLevelItem(i);
        bool any = false;
        for (int j = 0; j < group->childCount(); ++j) {
            QTreeWidgetItem* item = group->child(j);
            const bool fits = typed.isEmpty() || (item->text(0) + ' ' + item->text(1)).contains(typed, Qt::CaseInsensitive);
            item->setHidden(!fits);
            any = any || fits;
        }
        group->setHidden(!any);
    }
}

QAction* KeySheet::chosen() const {
    const QTreeWidgetItem* item = sheet_->currentItem();
    const QString id = item ? item->data(0, Qt::UserRole).toString() : QString();
    return id.isEmpty() ? nullptr : commands_.action(id);
}

void KeySheet::showChosen() {
    const QAction* action = chosen();
    name_->setText(action ? tr("Shortcut for “%1”").arg(commandName(action)) : tr("Select a command to change its shortcut"));
    keys_->setKeySequence(action ? action->shortcut() : QKeySequence());
    for (QWidget* widget : {static_cast<QWidget*>(keys_), static_cast<QWidget*>(set_), static_cast<QWidget*>(original_)})
        widget->setEnabled(action);
    showConflict();
}

void KeySheet::showConflict() {
    const QAction* other = chosen() ? commandWithKeys(commands_, keys_->keySequence(), chosen()) : nullptr;
    conflict_->setText(other ? tr("“%1” uses this shortcut and would lose it.").arg(commandName(other)) : QString());
}

void KeySheet::change() {
    QAction* action = chosen();
    if (!action) return;
    const QKeySequence keys = keys_->keySequence();
    takeFromOthers(keys, action);
    commands_.setKeys(action->objectName(), {keys});
}

void KeySheet::restore() {
    QAction* action = chosen();
    if (!action) return;
    commands_.setKeys(action->objectName(), {});
    for (const QKeySequence& keys : action->shortcuts()) takeFromOthers(keys, action);
}

/// Removes the keys from any other command: a shortcut of two commands would be ambiguous and do nothing.
void KeySheet::takeFromOthers(const QKeySequence& keys, const QAction* owner) {
    QAction* other = commandWithKeys(commands_, keys, owner);
    if (!other) return;
    QList<QKeySequence> left = other->shortcuts();
    left.removeAll(keys);
    commands_.setKeys(other->objectName(), left.isEmpty() ? QList<QKeySequence>{QKeySequence()} : left);
}

}  // namespace keyblock
