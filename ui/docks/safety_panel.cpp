// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/safety_panel.h"

#include "solver/results/result_names.h"
#include "ui/look/display.h"
#include "ui/look/qt_text.h"
#include "ui/runs/safety_search.h"

#include <QHeaderView>
#include <QTreeWidget>

#include <algorithm>

namespace keyblock {

namespace {

constexpr std::size_t mostNamed = 6;  // blocks

}  // namespace

SafetyPanel::SafetyPanel(SafetySearch& search, QWidget* parent)
    : TrialPanel("safety", tr("Factor of safety"), tr("Find factor of safety"), parent), search_(search),
      runs_(new QTreeWidget(this)) {
    runs_->setObjectName("safetyRuns");
    runs_->setAccessibleName(tr("Runs with reduced strengths"));
    runs_->setRootIsDecorated(false);
    runs_->setHeaderLabels({tr("Factor"), tr("Result"), tr("Stage"), tr("Steps")});
    setContent(runs_);
    connect(this, &TrialPanel::startAsked, &search, &SafetySearch::start);
    connect(this, &TrialPanel::stopAsked, &search, &SafetySearch::stop);
    connect(&search, &SafetySearch::changed, this, &SafetyPanel::fill);
    fill();
}

void SafetyPanel::fill() {
    present(search_.isBusy(), search_.fractionNow(), answer(), failure());
    if (runs_->topLevelItemCount() != static_cast<int>(search_.runs().size())) fillRuns();
}

QString SafetyPanel::answer() const {
    const auto number = [](double factor) { return Display::number(factor, 4); };
    if (!search_.problem().isEmpty()) return search_.problem();
    if (search_.isBusy()) return tr("Running with strengths divided by %1").arg(number(search_.factorNow()));
    if (!search_.found()) return tr("The scene is run repeatedly with reduced strengths until it fails.");
    const SafetyFactor& found = *search_.found();
    if (found.nothingToFreeze) return tr("The scene fails at full strength, so there are no bolt forces to freeze.");
    if (found.lower && found.upper)
        return tr("Factor of safety between %1 (stable) and %2 (fails)").arg(number(*found.lower), number(*found.upper));
    if (found.lower) return tr("Factor of safety above %1 (stable)").arg(number(*found.lower));
    if (found.upper) return tr("Factor of safety below %1 (fails)").arg(number(*found.upper));
    return found.cutShort == Outcome::Stopped ? tr("Stopped before the first run ended")
                                              : tr("No factor of safety found");
}

/// How the scene fails at the upper end of the bracket.
QString SafetyPanel::failure() const {
    if (!search_.found()) return {};
    const SafetyFactor& found = *search_.found();
    QStringList lines;
    if (found.cutShort == Outcome::Stopped) lines << tr("Stopped; this is the bracket found so far.");
    if (found.cutShort == Outcome::Limit) lines << tr("The last run reached a limit set in the scene.");
    if (found.cutShort == Outcome::Undecided) lines << tr("The last run left stability undecided.");
    if (!found.mode || found.mode->blocks.empty()) return lines.join('\n');
    QStringList blocks;
    for (const MovingBlock& block : found.mode->blocks) {
        if (static_cast<std::size_t>(blocks.size()) == mostNamed) break;
        blocks << tr("%1 (%2)").arg(QString::fromStdString(blockName(search_.blockNames(), block.block)),
                                    qt(wordOf(block.movement)));
    }
    if (const std::size_t all = found.mode->blocks.size(); all > mostNamed) blocks << tr("%1 more").arg(all - mostNamed);
    lines << tr("Blocks that fail: %1").arg(blocks.join(", "));
    return lines.join('\n');
}

void SafetyPanel::fillRuns() {
    runs_->clear();
    for (const SafetyRun& run : search_.runs()) {
        const QString result = run.end.outcome == Outcome::Undecided ? tr("undecided") : run.stands ? tr("stable") : tr("fails");
        new QTreeWidgetItem(runs_, {Display::number(run.factor, 4), result,
                                    QString::fromStdString(stageName(search_.scene(), run.end.stage)),
                                    QString::number(run.end.steps)});
    }
    runs_->scrollToBottom();
}

}  // namespace keyblock
