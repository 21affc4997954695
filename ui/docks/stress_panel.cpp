// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/stress_panel.h"

#include "ui/look/display.h"
#include "ui/runs/stress_runs.h"

#include <QCoreApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTreeWidget>
#include <QVariant>
#include <QVBoxLayout>

#include <cmath>

namespace keyblock {

namespace {

constexpr int leastForStressButton = 340;  // [px] next to the text

struct StressTexts {
    Q_DECLARE_TR_FUNCTIONS(StressPanel)
};

QString endingText(StressEnding ending) {
    switch (ending) {
        case StressEnding::Same: return StressTexts::tr("same");
        case StressEnding::Moved: return StressTexts::tr("changed");
        case StressEnding::Refused: return StressTexts::tr("refused");
        case StressEnding::Stopped: return StressTexts::tr("stopped");
        case StressEnding::Verdict: return StressTexts::tr("verdict changed");
    }
    return {};
}

QString changeText(const StressPoint& point) {
    if (point.quantity.empty()) return {};
    return std::isfinite(point.moved) ? StressTexts::tr("%1 %").arg(Display::number(100.0 * point.moved, 2))
                                      : StressTexts::tr("no value");
}

QString reasonText(const StressPoint& point) {
    QStringList lines{QString::fromStdString(point.reason.empty() ? point.quantity : point.reason)};
    for (const std::string& warning : point.warnings)
        lines << StressTexts::tr("Warning: %1").arg(QString::fromStdString(warning));
    return lines.join("; ");
}

}  // namespace

StressPanel::StressPanel(StressRuns& runs, QWidget* parent)
    : QWidget(parent), runs_(runs), answer_(new QLabel(this)), detail_(new QLabel(this)),
      progress_(new QProgressBar(this)), start_(new QPushButton(tr("Start stress test"), this)),
      stop_(new QPushButton(tr("Stop"), this)), pushes_(new QTreeWidget(this)) {
    setObjectName("stressPanel");
    setAttribute(Qt::WA_StyledBackground);
    setAccessibleName(tr("Stress test"));
    answer_->setObjectName("stressAnswer");
    answer_->setProperty("role", "title");
    detail_->setObjectName("stressDetail");
    detail_->setProperty("role", "detail");
    for (QLabel* label : {answer_, detail_}) {
        label->setWordWrap(true);
        label->setTextFormat(Qt::PlainText);
    }
    progress_->setTextVisible(false);
    progress_->setFixedHeight(6);
    start_->setObjectName("stress.start");
    stop_->setObjectName("stress.stop");
    for (QPushButton* button : {start_, stop_}) button->setAccessibleName(button->text());
    pushes_->setObjectName("stressPushes");
    pushes_->setAccessibleName(tr("Changed settings and loads"));
    pushes_->setRootIsDecorated(false);
    pushes_->setHeaderLabels({tr("Changed"), tr("Result"), tr("Change"), tr("Quantity or reason")});
    row_ = new QHBoxLayout;
    row_->addWidget(answer_, 1);
    row_->addWidget(stop_, 0, Qt::AlignTop);
    row_->addWidget(start_, 0, Qt::AlignTop);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 6, 12, 6);
    column->setSpacing(4);
    column->addLayout(row_);
    column->addWidget(progress_);
    column->addWidget(detail_);
    column->addWidget(pushes_, 1);
    connect(start_, &QPushButton::clicked, &runs, &StressRuns::start);
    connect(stop_, &QPushButton::clicked, &runs, &StressRuns::stop);
    connect(&runs, &StressRuns::changed, this, &StressPanel::fill);
    fill();
}

void StressPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    row_->setDirection(width() < leastForStressButton ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

void StressPanel::fill() {
    const bool busy = runs_.isBusy();
    start_->setVisible(!busy);
    stop_->setVisible(busy);
    progress_->setVisible(busy);
    progress_->setValue(static_cast<int>(100.0 * runs_.fraction()));
    answer_->setText(answer());
    detail_->setText(detail());
    detail_->setVisible(!detail_->text().isEmpty());
    if (pushes_->topLevelItemCount() != static_cast<int>(runs_.test().points.size())) fillPushes();
}

QString StressPanel::answer() const {
    if (!runs_.problem().isEmpty()) return runs_.problem();
    if (runs_.isBusy()) return runs_.label().isEmpty() ? tr("Starting") : runs_.label();
    if (!runs_.hasEnded())
        return tr("Runs the scene with larger and smaller settings and loads until something breaks.");
    const StressTest& test = runs_.test();
    if (test.own.values.empty()) return tr("Stopped before the first run ended");
    if (!test.own.failure.empty())
        return tr("The scene has no result to compare with: %1").arg(QString::fromStdString(test.own.failure));
    return QString::fromStdString(stressAnswer(test)).trimmed();
}

QString StressPanel::detail() const {
    if (runs_.isBusy() || !runs_.hasEnded()) return {};
    QStringList lines;
    if (runs_.test().interrupted) lines << tr("Stopped; these are the runs made so far.");
    if (!runs_.isCurrent()) lines << tr("The scene has changed since this test.");
    return lines.join(' ');
}

void StressPanel::fillPushes() {
    pushes_->clear();
    const int first = firstToBreak(runs_.test());
    QTreeWidgetItem* broken = nullptr;
    for (std::size_t i = 0; i < runs_.test().points.size(); ++i) {
        const StressPoint& point = runs_.test().points[i];
        const QString reason = reasonText(point);
        auto* item = new QTreeWidgetItem(pushes_, {QString::fromStdString(point.push.axis + " " + point.push.text),
                                                   endingText(point.ending), changeText(point), reason});
        item->setTextAlignment(2, Qt::AlignRight | Qt::AlignVCenter);
        item->setToolTip(3, reason);
        if (static_cast<int>(i) == first) broken = item;
    }
    if (broken) {
        QFont font = pushes_->font();
        font.setWeight(QFont::DemiBold);
        for (int column = 0; column < pushes_->columnCount(); ++column) broken->setFont(column, font);
    }
    for (int column = 0; column < 3; ++column) pushes_->resizeColumnToContents(column);
    if (broken && !runs_.isBusy()) pushes_->scrollToItem(broken);
    else pushes_->scrollToBottom();
}

}  // namespace keyblock
