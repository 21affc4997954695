// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/stress_panel.h"

#include "solver/trade/change_text.h"
#include "ui/runs/stress_runs.h"

#include <QCoreApplication>
#include <QHeaderView>
#include <QTreeWidget>

#include <cmath>

namespace keyblock {

namespace {

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

QString movedText(const StressPoint& point) {
    if (point.quantity.empty()) return {};
    return std::isfinite(point.moved) ? QString::fromStdString(changeText(point.moved)) : StressTexts::tr("no value");
}

QString reasonText(const StressPoint& point) {
    QStringList lines{QString::fromStdString(point.reason.empty() ? point.quantity : point.reason)};
    for (const std::string& warning : point.warnings)
        lines << StressTexts::tr("Warning: %1").arg(QString::fromStdString(warning));
    return lines.join("; ");
}

}  // namespace

StressPanel::StressPanel(StressRuns& runs, QWidget* parent)
    : TrialPanel("stress", tr("Stress test"), tr("Start stress test"), parent), runs_(runs),
      pushes_(new QTreeWidget(this)) {
    pushes_->setObjectName("stressPushes");
    pushes_->setAccessibleName(tr("Changed settings and loads"));
    pushes_->setRootIsDecorated(false);
    pushes_->setHeaderLabels({tr("Changed"), tr("Result"), tr("Change"), tr("Quantity or reason")});
    setContent(pushes_);
    connect(this, &TrialPanel::startAsked, &runs, &StressRuns::start);
    connect(this, &TrialPanel::stopAsked, &runs, &StressRuns::stop);
    connect(&runs, &StressRuns::changed, this, &StressPanel::fill);
    fill();
}

void StressPanel::fill() {
    present(runs_.isBusy(), runs_.fraction(), answer(), detail());
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
                                                   endingText(point.ending), movedText(point), reason});
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
