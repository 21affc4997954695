// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/run_list.h"

#include "solver/results/run_source.h"
#include "ui/look/commands.h"
#include "ui/look/plain_text.h"
#include "ui/look/question.h"
#include "ui/look/theme.h"
#include "ui/runs/comparison.h"
#include "ui/runs/runs.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QToolButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace keyblock {

RunList::RunList(const Themes& themes, const Commands& commands, Runs& runs, Comparison& comparison, QWidget* parent)
    : QWidget(parent), themes_(themes), commands_(commands), runs_(runs), comparison_(comparison),
      stale_(new QLabel(this)), compare_(new QToolButton(this)), list_(new QTreeWidget(this)) {
    setObjectName("runList");
    setAttribute(Qt::WA_StyledBackground);
    setAccessibleName(tr("Runs"));
    stale_->setObjectName("staleRun");
    stale_->setContentsMargins(12, 5, 12, 5);
    stale_->setWordWrap(true);
    list_->setObjectName("runs");
    list_->setAccessibleName(tr("Runs of the scene"));
    list_->setRootIsDecorated(false);
    list_->setContextMenuPolicy(Qt::CustomContextMenu);
    list_->setHeaderLabels({tr("Run"), tr("Ended"), tr("Outcome"), tr("Frames"), tr("Events")});
    list_->header()->setStretchLastSection(false);
    list_->header()->setSectionResizeMode(2, QHeaderView::Stretch);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(stale_);
    column->addWidget(list_, 1);
    compare_->setObjectName("compareRuns");
    compare_->setText(tr("Compare"));
    compare_->setAccessibleName(tr("Compare with another run"));
    compare_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    compare_->setPopupMode(QToolButton::InstantPopup);
    compare_->setProperty("framed", true);
    compare_->setMenu(new QMenu(compare_));
    connect(compare_->menu(), &QMenu::aboutToShow, this, [this] { fillCompareMenu(*compare_->menu()); });
    auto* foot = new QHBoxLayout;
    foot->setContentsMargins(12, 4, 12, 6);
    foot->addWidget(compare_);
    foot->addStretch(1);
    column->addLayout(foot);
    connect(&comparison, &Comparison::changed, this, &RunList::fill);
    connect(&runs, &Runs::listChanged, this, &RunList::fill);
    connect(&runs, &Runs::shownChanged, this, &RunList::fill);
    connect(&runs, &Runs::stalenessChanged, this, &RunList::fill);
    connect(&themes, &Themes::changed, this, &RunList::fill);
    connect(&commands, &Commands::keysChanged, this, &RunList::fill);
    connect(list_, &QTreeWidget::itemActivated, this,
            [this](QTreeWidgetItem* item) { runs_.open(item->data(0, Qt::UserRole).toString()); });
    connect(list_, &QWidget::customContextMenuRequested, this, &RunList::showMenu);
    fill();
}

void RunList::fill() {
    const Theme& theme = themes_.current();
    const QString stale = runs_.staleness();
    stale_->setVisible(!stale.isEmpty());
    stale_->setText(stale + tr(". Press %1 to run the current scene.").arg(commands_.callOf("run.start")));
    stale_->setStyleSheet(QStringLiteral("background: %1; color: %2;").arg(theme.warningSoft.name(), theme.text.name()));
    compare_->setIcon(themes_.icon("compare"));
    compare_->setEnabled(!runs_.shown().isEmpty());
    list_->clear();
    for (const RunEntry& entry : runs_.entries()) {
        QString outcome = entry.outcomeText();
        if (!comparison_.store().isEmpty() && entry.path == comparison_.store()) outcome += tr(" · compared");
        if (entry.ofEarlierScene) outcome += tr(" · earlier version of the scene");
        const auto count = [&](long RunSummary::* what) {
            return entry.summary ? QLocale::c().toString(qlonglong((*entry.summary).*what)) : QString();
        };
        auto* item = new QTreeWidgetItem(
            list_, {entry.name(), entry.goesOn ? QString() : QLocale().toString(entry.time, QLocale::ShortFormat), outcome,
                    count(&RunSummary::frames), count(&RunSummary::events)});
        item->setData(0, Qt::UserRole, entry.path);
        item->setToolTip(0, asTip(entry.problem.isEmpty() ? entry.path : entry.problem));
        item->setTextAlignment(3, Qt::AlignRight);
        item->setTextAlignment(4, Qt::AlignRight);
        QFont font = item->font(0);
        font.setWeight(entry.path == runs_.shown() ? QFont::DemiBold : QFont::Normal);
        item->setFont(0, font);
        const bool good = entry.summary && entry.summary->outcome && endedAsPlanned(*entry.summary->outcome);
        if (entry.goesOn) item->setIcon(0, themes_.icon("running", theme.accent));
        else if (!entry.summary) item->setIcon(0, themes_.icon("error", theme.error));
        else item->setIcon(0, good ? themes_.icon("ok", theme.ok) : themes_.icon("warning", theme.warning));
    }
    for (const int column : {0, 1, 3, 4}) list_->resizeColumnToContents(column);
}

/// Runs that can be compared with the one shown.
void RunList::fillCompareMenu(QMenu& menu) {
    menu.clear();
    for (const RunEntry& entry : runs_.entries()) {
        if (!entry.summary || entry.goesOn || entry.path == runs_.shown()) continue;
        menu.addAction(tr("Compare with %1").arg(entry.name()), this,
                       [this, path = entry.path] { comparison_.begin(path); });
    }
    menu.addAction(tr("Compare with a run of another scene…"), this, [this] {
        const QString path = QFileDialog::getOpenFileName(this, tr("Choose a run to compare"),
                                                          QFileInfo(runs_.shown()).absolutePath(), tr("Runs (*.kbrun)"));
        if (!path.isEmpty()) comparison_.begin(path);
    });
    if (!comparison_.isOn()) return;
    menu.addSeparator();
    menu.addAction(tr("Close comparison"), &comparison_, &Comparison::end);
}

void RunList::showMenu(const QPoint& at) {
    const QTreeWidgetItem* item = list_->itemAt(at);
    if (!item) return;
    const QString store = item->data(0, Qt::UserRole).toString();
    const QString name = item->text(0);
    bool resumable = false, goesOn = false, readable = false;
    for (const RunEntry& entry : runs_.entries())
        if (entry.path == store) {
            resumable = entry.summary && entry.summary->resumable && !entry.ofEarlierScene;
            goesOn = entry.goesOn;
            readable = entry.summary.has_value();
        }
    QMenu menu(this);
    menu.addAction(tr("Show %1").arg(name), this, [this, store] { runs_.open(store); });
    QAction* on = menu.addAction(tr("Resume %1").arg(name), this, [this, store] { runs_.resume(store); });
    on->setEnabled(resumable && !runs_.isRunning());
    if (comparison_.store() == store) {
        menu.addAction(tr("Close comparison"), &comparison_, &Comparison::end);
    } else {
        QAction* beside = menu.addAction(tr("Compare with %1").arg(name), this, [this, store] { comparison_.begin(store); });
        beside->setEnabled(readable && !goesOn && !runs_.shown().isEmpty() && store != runs_.shown());
    }
    menu.addSeparator();
    QAction* away = menu.addAction(tr("Remove %1…").arg(name), this, [this, store, name] {
        const auto answer = ask(*this, tr("Remove run"), tr("Remove %1 and its file?").arg(name),
                                tr("%1\nThis cannot be undone.").arg(store),
                                {{QMessageBox::Cancel, {}}, {QMessageBox::Yes, tr("Remove")}});
        if (answer == QMessageBox::Yes) runs_.remove(store);
    });
    away->setEnabled(!goesOn);
    menu.exec(list_->viewport()->mapToGlobal(at));
}

}  // namespace keyblock
