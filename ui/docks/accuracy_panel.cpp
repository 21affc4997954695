// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/accuracy_panel.h"

#include "solver/trade/change_text.h"
#include "solver/trade/trade_errors.h"
#include "solver/trade/trade_page.h"
#include "ui/docks/trade_view.h"
#include "ui/document/document.h"
#include "ui/edit/settle.h"
#include "ui/runs/trade_runs.h"

namespace keyblock {

namespace {

bool hasResult(const Trade& trade) { return !trade.points.empty() && trade.points.front().failure.empty(); }

}  // namespace

AccuracyPanel::AccuracyPanel(const Themes& themes, Document& document, TradeRuns& runs, QWidget* parent)
    : TrialPanel("accuracy", tr("Accuracy"), tr("Measure accuracy"), parent), document_(document), runs_(runs),
      chart_(new TradeView(themes, this)) {
    keepDetailLine();
    setContent(chart_);
    connect(this, &TrialPanel::startAsked, this, [this] {
        used_.clear();
        runs_.start();
    });
    connect(this, &TrialPanel::stopAsked, &runs, &TradeRuns::stop);
    connect(&runs, &TradeRuns::changed, this, &AccuracyPanel::fill);
    connect(&document, &Document::changed, this, &AccuracyPanel::fill);
    connect(chart_, &TradeView::picked, this, &AccuracyPanel::use);
    fill();
}

void AccuracyPanel::fill() {
    const bool busy = runs_.isBusy();
    present(busy, runs_.fraction(), answer(), detail());
    if (hasResult(runs_.trade())) chart_->show(tradeChartOf(runs_.trade()));
    else chart_->clear(busy ? tr("The first run has not ended yet.")
                            : tr("Runs the scene with coarser and finer numerical settings, and shows what each costs "
                                 "and changes."));
}

QString AccuracyPanel::answer() const {
    if (!runs_.problem().isEmpty()) return runs_.problem();
    const Trade& trade = runs_.trade();
    if (runs_.isBusy()) return runs_.label().isEmpty() ? tr("Starting") : runs_.label();
    if (trade.points.empty()) return tr("Not measured");
    if (!hasResult(trade))
        return tr("The scene has no result to compare with: %1")
            .arg(QString::fromStdString(trade.points.front().failure));
    const int best = recommendedPreset(trade, recommendedError);
    if (best < 0)
        return tr("No preset is recommended: %1.")
            .arg(QString::fromStdString(withoutRecommendation(trade, recommendedError)));
    return tr("Recommended, within %1 of the finest run: %2")
        .arg(QString::fromStdString(changeText(recommendedError)),
             QString::fromStdString(sentenceOn(trade, static_cast<std::size_t>(best))));
}

QString AccuracyPanel::detail() const {
    QStringList lines;
    if (!used_.isEmpty()) lines << used_;
    const Trade& trade = runs_.trade();
    if (!runs_.isBusy() && trade.interrupted && hasResult(trade))
        lines << tr("Stopped; these are the runs made so far.");
    if (!runs_.isBusy() && hasResult(trade) && used_.isEmpty() && !runs_.isCurrent())
        lines << tr("The scene has changed since these runs.");
    return lines.join('\n');
}

void AccuracyPanel::use(int point) {
    const auto index = static_cast<std::size_t>(point);
    const TradePoint& chosen = runs_.trade().points[index];
    const QString name = QString::fromStdString(nameOf(chosen));
    if (chosen.axis == bondAxisName) {
        used_ = tr("%1 is another bolt, not another way to compute it; it is not used.").arg(name);
        return fill();
    }
    Scene scene = *document_.committed();
    runs_.trade().settings[index].apply(scene);
    settle(scene);
    used_ = scene == *document_.committed() ? tr("The scene already uses: %1").arg(name)
                                            : tr("The scene now uses: %1. Undo goes back.").arg(name);
    document_.apply(tr("use %1").arg(name), std::move(scene));
    fill();
}

}  // namespace keyblock
