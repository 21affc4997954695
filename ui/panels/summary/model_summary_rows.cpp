// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/summary/model_summary_rows.h"

#include "solver/scene/units.h"
#include "ui/look/display.h"

#include <QCoreApplication>
#include <QStringList>

#include <cmath>

namespace keyblock {

namespace {

struct SummaryTexts {
    Q_DECLARE_TR_FUNCTIONS(ModelSummary)
};

constexpr double mostCounted = 1e15;
constexpr double century = 100.0 * 365.25 * 86400.0;  // [s]

QString number(double value) { return Display::number(value, 12); }

/// Rounds to two digits: an estimate is no more accurate than that.
QString rough(double value) {
    if (!(value < mostCounted)) return SummaryTexts::tr("more than 1e15");
    const double size = value > 0.0 ? std::pow(10.0, std::floor(std::log10(value)) - 1.0) : 1.0;
    return Display::number(std::round(value / size) * size, 12);
}

QString whyBlocks(const ModelCounts& counts) {
    const QString strains = counts.cells == 0             ? SummaryTexts::tr("constant strain in each block; no cells")
                            : counts.cells < counts.blocks ? SummaryTexts::tr("%1 of them are cells").arg(number(counts.cells))
                                                           : SummaryTexts::tr("cells, each with its own strain");
    return counts.fixed > 0 ? SummaryTexts::tr("%1; %2 fixed").arg(strains, number(counts.fixed)) : strains;
}

QString boltCount(const ModelCounts& counts) {
    const bool even = counts.bolts > 0 && counts.nodes % counts.bolts == 0;
    if (even) return SummaryTexts::tr("%1 × %2 nodes").arg(number(counts.bolts)).arg(number(counts.nodes / counts.bolts));
    return SummaryTexts::tr("%1 (%2 nodes)").arg(number(counts.bolts), number(counts.nodes));
}

}  // namespace

std::vector<ModelSummaryRow> modelSummaryRows(const ModelSummary& summary) {
    const ModelCounts& counts = summary.counts;
    std::vector<ModelSummaryRow> rows{
        {counts.cells == counts.blocks && counts.cells > 0 ? SummaryTexts::tr("Cells") : SummaryTexts::tr("Blocks"),
         number(counts.blocks),
         number(counts.blockUnknowns), whyBlocks(counts)}};
    if (counts.bolts > 0)
        rows.push_back({SummaryTexts::tr("Bolts"), boltCount(counts), number(counts.boltUnknowns),
                        SummaryTexts::tr("%1 bonded nodes; the other nodes transfer transverse force only")
                            .arg(number(counts.realAnchors))});
    if (counts.plates > 0)
        rows.push_back({SummaryTexts::tr("Plates"), number(counts.plates), number(counts.plateUnknowns),
            SummaryTexts::tr("each is a separate block")});
    rows.push_back({SummaryTexts::tr("Contacts"), QString::fromUtf8("≈ ") + number(counts.contacts), "0",
        SummaryTexts::tr("at the start; contact springs add no unknowns")});
    if (counts.gluedEdges > 0)
        rows.push_back({SummaryTexts::tr("Glued edges"), number(counts.gluedEdges), "0",
                        SummaryTexts::tr("between cells")});
    if (counts.heldPoints > 0)
        rows.push_back({SummaryTexts::tr("Points with supports"), number(counts.heldPoints), "0",
                        SummaryTexts::tr("defined by the supports of the scene")});
    const std::size_t stages = summary.estimate.stages.size();
    rows.push_back({SummaryTexts::tr("Total"), {}, number(counts.unknowns()),
                    stages == 0   ? SummaryTexts::tr("no stages to run")
                    : stages == 1 ? SummaryTexts::tr("1 stage")
                                  : SummaryTexts::tr("%1 stages").arg(stages),
                    false, true});
    for (const LeftOut& part : summary.leftOut)
        rows.push_back({QString::fromStdString(part.what), {}, {},
                        SummaryTexts::tr("%1; saves %2").arg(QString::fromStdString(part.why),
                                                  QString::fromStdString(part.saves)), true});
    for (const NextLeftOut& next : summary.next)
        rows.push_back({QString::fromStdString(next.what),
                        {},
                        {},
                        (next.measured ? SummaryTexts::tr("%1; saves %2") : SummaryTexts::tr("cost %1; saves %2"))
                            .arg(QString::fromStdString(next.costs), QString::fromStdString(next.saves)),
                        false,
                        false,
                        true});
    return rows;
}

QString costText(double seconds) {
    if (seconds < 1.0) return SummaryTexts::tr("< 1 s");
    if (seconds < 60.0) return SummaryTexts::tr("%1 s").arg(rough(seconds));
    if (seconds < 3600.0) {
        const int rest = static_cast<int>(std::round(std::fmod(seconds, 60.0) / 10.0)) * 10;
        const int minutes = static_cast<int>(seconds / 60.0) + rest / 60;
        return rest % 60 == 0 || minutes >= 10 ? SummaryTexts::tr("%1 min").arg(minutes)
            : SummaryTexts::tr("%1 min %2 s").arg(minutes).arg(rest);
    }
    if (!(seconds < century)) return SummaryTexts::tr("> 100 years");
    return SummaryTexts::tr("%1 h").arg(rough(seconds / 3600.0));
}

QString memoryText(double bytes) {
    return bytes < 1e9 ? SummaryTexts::tr("%1 MB").arg(rough(bytes / 1e6))
                       : SummaryTexts::tr("%1 GB").arg(rough(bytes / 1e9));
}

QString estimateDetails(const CostEstimate& estimate) {
    QStringList lines;
    for (const StageCost& stage : estimate.stages)
        lines << SummaryTexts::tr("%1: %2 steps, %3 iterations (%4 to %5)")
                     .arg(QString::fromStdString(stage.name), rough(stage.steps), rough(stage.passes),
                          rough(stage.least),
                          rough(stage.most));
    lines << SummaryTexts::tr("Each iteration takes %1 ms; the rest of a step takes %2 ms.")
                 .arg(rough(fromSi(estimate.passSeconds, namedUnit("ms"))),
                      rough(fromSi(estimate.stepSeconds, namedUnit("ms"))));
    for (const std::string& sentence : estimate.assumes) lines << QString::fromStdString(sentence);
    return lines.join('\n');
}

}  // namespace keyblock
