// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/workflow_bar.h"

#include "ui/look/theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QPainter>
#include <QToolButton>
#include <QVariant>

namespace keyblock {

namespace {

constexpr int rim = 12, besideText = 32;  // [px]
constexpr int barHeight = 40;

QIcon iconOf(const Themes& themes, WorkState state) {
    const Theme& t = themes.current();
    switch (state) {
        case WorkState::Done: return themes.icon("ok", t.ok);
        case WorkState::Warning: return themes.icon("warning", t.warningFill);
        case WorkState::Error: return themes.icon("error", t.error);
        case WorkState::Running: return themes.icon("running", t.accent);
        case WorkState::NotYet: return themes.icon("not-yet", t.text3);
        case WorkState::Nothing: break;
    }
    return {};
}

QString wordOf(WorkState state) {
    switch (state) {
        case WorkState::Done: return WorkflowBar::tr("done");
        case WorkState::Warning: return WorkflowBar::tr("has warnings");
        case WorkState::Error: return WorkflowBar::tr("has errors");
        case WorkState::Running: return WorkflowBar::tr("running");
        case WorkState::NotYet: return WorkflowBar::tr("not started");
        case WorkState::Nothing: break;
    }
    return {};
}

}  // namespace

WorkflowBar::WorkflowBar(const Themes& themes, QWidget* parent)
    : QWidget(parent), themes_(themes), row_(new QHBoxLayout(this)) {
    setObjectName("workflow");
    setFixedHeight(barHeight);
    row_->setContentsMargins(rim, 0, rim, 0);
    row_->setSpacing(0);
    const std::array names{
        tr("Geometry"), tr("Materials && joints"), tr("Support"), tr("Stages"), tr("Run"), tr("Results"),
        tr("Studies")};
    for (std::size_t i = 0; i < workSteps; ++i) {
        auto* tab = new QToolButton(this);
        tab->setText(names[i]);
        tab->setObjectName(QString("workflow.%1").arg(i));
        tab->setProperty("workflow", true);
        tab->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        tab->setCheckable(true);
        tab->setAutoExclusive(true);
        tab->setFixedHeight(barHeight);
        connect(tab, &QToolButton::clicked, this, [this, i] {
            choose(static_cast<WorkStep>(i));
            Q_EMIT asked(static_cast<WorkStep>(i));
        });
        row_->addWidget(tab);
        tabs_[i] = tab;
    }
    row_->addStretch();
    tabs_.front()->setChecked(true);
    showIcons();
    connect(&themes, &Themes::changed, this, &WorkflowBar::showIcons);
}

void WorkflowBar::choose(WorkStep step) {
    tabs_[static_cast<std::size_t>(step)]->setChecked(true);
    fit();
    if (step == current_) return;
    current_ = step;
    Q_EMIT chosen(step);
}

void WorkflowBar::setStates(const WorkStates& states) {
    if (states == states_) return;
    states_ = states;
    showIcons();
}

void WorkflowBar::addRight(QWidget* widget) {
    right_ = widget;
    row_->addWidget(widget);
}

QSize WorkflowBar::minimumSizeHint() const { return {300, barHeight}; }

/// If the names do not fit, only the current step shows its name; the other steps show only an icon of their state.
void WorkflowBar::fit() {
    int wanted = 2 * rim + (right_ && right_->isVisible() ? right_->minimumSizeHint().width() : 0);
    for (const QToolButton* tab : tabs_)
        wanted += tab->fontMetrics().horizontalAdvance(tab->text()) + tab->iconSize().width() + besideText;
    const bool isShort = wanted > width();
    for (QToolButton* tab : tabs_) {
        const bool alone = isShort && !tab->isChecked() && !tab->icon().isNull();
        const auto style = alone ? Qt::ToolButtonIconOnly : Qt::ToolButtonTextBesideIcon;
        if (tab->toolButtonStyle() != style) tab->setToolButtonStyle(style);
    }
}

bool WorkflowBar::event(QEvent* event) {
    if (event->type() == QEvent::Resize || event->type() == QEvent::LayoutRequest) fit();
    return QWidget::event(event);
}

void WorkflowBar::showIcons() {
    for (std::size_t i = 0; i < workSteps; ++i) {
        tabs_[i]->setIcon(iconOf(themes_, states_[i]));
        QString name = tabs_[i]->text();
        tabs_[i]->setAccessibleName(name.replace("&&", "&"));
        tabs_[i]->setAccessibleDescription(wordOf(states_[i]));
        tabs_[i]->setToolTip(states_[i] == WorkState::Nothing ? name : name + ": " + wordOf(states_[i]));
    }
    fit();
}

void WorkflowBar::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.fillRect(rect(), themes_.current().panel);
    painter.fillRect(0, height() - 1, width(), 1, themes_.current().separator);
}

}  // namespace keyblock
