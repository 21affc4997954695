// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/result_rows.h"

#include "solver/results/frame_quantities.h"
#include "solver/results/run_source.h"
#include "solver/results/result_names.h"
#include "solver/scene/units.h"
#include "ui/look/display.h"
#include "ui/look/qt_text.h"
#include "ui/picture/event_list.h"

#include <QCoreApplication>

#include <algorithm>
#include <array>
#include <cassert>

namespace keyblock {

namespace {

constexpr std::size_t mostEvents = 8;
// relative to the axial force and to a strength; smaller values are round-off
constexpr double noForce = 1e-9, leastUse = 1e-6;

struct ResultTexts {
    Q_DECLARE_TR_FUNCTIONS(ResultRows)
};

QString percent(double share) {
    const double shown = share < leastUse ? 0.0 : 100.0 * share;
    return Display::number(shown, shown < 9.95 ? 2 : 3) + QStringLiteral(" %");
}

QString whenText(const Scene& scene, int stage, double time) {
    const QString name = QString::fromStdString(stageName(scene, stage));
    const bool moves = scene.stages[stage].kind == StageKind::Dynamic;
    return moves ? ResultTexts::tr("%1, %2 s").arg(name, Display::number(time, 4)) : name + ' ' + Display::number(time, 4);
}

/// Creates rows in the units and signs shown.
struct RowMaker {
    const RunSource& run;
    const ShownNumbers& numbers;
    std::vector<ResultRow>& rows;

    QString shown(double value, std::string_view unit, double factor, std::string_view convention = {}) const {
        const ShownAs as = shownAs(unit, convention, numbers);
        const QString symbol = QString::fromStdString(as.unit);
        return Display::number(as.factor * withoutRoundOff(factor * value, unit), 4) + (symbol.isEmpty() ? QString() : ' ' + symbol);
    }

    QString inUnit(double value, std::string_view unit) const { return shown(value, unit, perSi(findUnit(unit)->unit)); }

    void add(const QString& name, const QString& value) { rows.push_back({name, value}); }

    void peak(const BoltQuantityRow& quantity, const BoltPeak& peak, double axial) {
        const QString name = ResultTexts::tr("Largest %1").arg(qt(quantity.brief));
        if (peak.stage < 0 || std::abs(peak.value) < noForce * std::abs(axial)) return add(name, QStringLiteral("0"));
        rows.push_back({name, shown(peak.value, quantity.unit, quantity.factor),
                        ResultTexts::tr("at %1 m, %2")
                            .arg(Display::number(peak.at, 3), whenText(run.scene(), peak.stage, peak.time))});
    }

    void use(const BoltStrengthRow& strength, const BoltPeak& peak) {
        if (peak.value < 0.0) return;  // no such strength
        ResultRow row{ResultTexts::tr("%1 utilisation").arg(qt(strength.title)), percent(peak.value)};
        QStringList details;
        if (strength.strength == BoltStrength::Steel) details += ResultTexts::tr("of ultimate strength");
        if (peak.stage >= 0 && peak.value >= leastUse) details += whenText(run.scene(), peak.stage, peak.time);
        row.detail = details.join(", ");
        row.use = peak.value;
        rows.push_back(std::move(row));
    }

    void quantity(std::string_view name, const BlockState& block) {
        const auto* found = findQuantity(blockQuantities(), name);
        if (!found) return;
        QString title = qt(found->display.title);
        if (title.startsWith("Block stress ")) title = title.mid(13);
        add(title, shown(found->value(block), found->display.unit, found->display.factor, found->display.convention));
    }

    void blockPeak(const QString& name, std::string_view quantity, const BlockExtremes& extremes) {
        const auto* found = findQuantity(blockQuantities(), quantity);
        const BlockPeak* peak = peakOf(extremes, quantity);
        if (!found || !peak) return;
        const QuantityDisplay& display = found->display;
        rows.push_back({name, shown(peak->value, display.unit, display.factor, display.convention),
                        whenText(run.scene(), peak->stage, peak->time)});
    }

    void energy(const BoltFrame& bolt) {
        const double all = bolt.elasticEnergy + bolt.plasticEnergy + bolt.bondEnergy;
        const auto part = [&](double joules) { return inUnit(joules, "kJ"); };
        rows.push_back({ResultTexts::tr("Energy absorbed so far"), part(all),
                        ResultTexts::tr("elastic %1, plastic %2, bond %3")
                            .arg(part(bolt.elasticEnergy), part(bolt.plasticEnergy), part(bolt.bondEnergy))});
    }
};

std::vector<ResultEvent> eventsOf(const RunSource& run, const std::vector<Event>& events) {
    std::vector<ResultEvent> list;
    for (const EventEntry& entry : eventList(run, events, mostEvents).entries) {
        ResultEvent shown{whenText(run.scene(), entry.stage, entry.time), QString::fromStdString(entry.what), {}};
        const auto first = std::ranges::find_if(events, [&](const Event& event) {
            return event.kind == entry.kind && event.stage == entry.stage && event.time == entry.time;
        });
        if (first != events.end()) shown.event = *first;
        list.push_back(std::move(shown));
    }
    return list;
}

template <typename Belongs>
std::vector<Event> some(const std::vector<Event>& events, Belongs belongs) {
    std::vector<Event> found;
    std::ranges::copy_if(events, std::back_inserter(found), belongs);
    return found;
}

void addPlate(const BoltReport& report, RowMaker& make) {
    if (!report.hasPlate) return;
    make.add(ResultTexts::tr("Current plate load"),
             report.plateHolds ? make.inUnit(report.plateForce, "kN") : ResultTexts::tr("plate lost"));
}

void addBond(const BoltReport& report, RowMaker& make) {
    const int nodes = report.bonded + report.slipping + report.failed;
    if (nodes == 0) return;
    make.add(ResultTexts::tr("Debonded length"), make.inUnit(report.debonded, "m"));
    make.add(ResultTexts::tr("Bond state of nodes"), ResultTexts::tr("%1 bonded, %2 slipping, %3 failed")
                                                .arg(report.bonded)
                                                .arg(report.slipping)
                                                .arg(report.failed));
}

}  // namespace

ResultReport boltResults(const RunSource& run, const Frame& frame, int bolt, const std::vector<Event>& events,
                         const ShownNumbers& numbers) {
    assert(0 <= bolt && bolt < static_cast<int>(frame.bolts.size()));
    const Scene& scene = run.scene();
    const Bolt& shown = scene.bolts[bolt];
    const BoltReport report = boltReport(scene, frame, bolt, events);
    ResultReport result{ResultTexts::tr("%1 · bolt").arg(qt(shown.name)), qt(shown.type), {}, {}};
    RowMaker make{run, numbers, result.rows};
    make.add(ResultTexts::tr("State"), qt(wordOf(report.condition)));
    const BoltExtremes& peaks = report.use.extremes;
    const double axial = peaks.axialForce.value;
    for (const BoltPeakRow& row : boltPeakRows) make.peak(rowOf(row.quantity), peaks.*row.peak, axial);
    for (const BoltStrengthRow& row : boltStrengths) make.use(row, peaks.*row.use);
    if (report.isInstalled()) {
        addPlate(report, make);
        addBond(report, make);
        make.energy(frame.bolts[bolt]);
    }
    result.events = eventsOf(run, some(events, [&](const Event& event) { return event.bolt == bolt; }));
    return result;
}

ResultReport blockResults(const RunSource& run, const Frame& frame, int block, const std::vector<Event>& events,
                          const ShownNumbers& numbers) {
    assert(0 <= block && block < static_cast<int>(frame.blocks.size()));
    static constexpr std::array quantities{"displacement", "ux", "uy",  "rotation", "velocity", "sigma1",
                                           "sigma3",       "sxx", "syy", "sxy",      "weight",   "area"};
    const BlockState& state = frame.blocks[block];
    ResultReport result{ResultTexts::tr("Block %1").arg(QString::fromStdString(blockName(run.blockNames(), block))),
                        ResultTexts::tr("block in the run shown"), {}, {}};
    RowMaker make{run, numbers, result.rows};
    if (state.area <= 0.0) {
        make.add(ResultTexts::tr("State"), ResultTexts::tr("excavated"));
    } else {
        for (const char* name : quantities) make.quantity(name, state);
    }
    if (const std::size_t row = block; row < frame.blockExtremes.size()) {
        const BlockExtremes& extremes = frame.blockExtremes[row];
        make.blockPeak(ResultTexts::tr("Largest displacement"), "displacement", extremes);
        make.blockPeak(ResultTexts::tr("Largest velocity"), "velocity", extremes);
        make.blockPeak(ResultTexts::tr("Largest σ₁"), "sigma1", extremes);
        make.blockPeak(ResultTexts::tr("Smallest σ₃"), "sigma3", extremes);
    }
    result.events = eventsOf(run, some(events, [&](const Event& event) {
                                 return event.bolt < 0 && (event.block == block || event.otherBlock == block);
                             }));
    return result;
}

}  // namespace keyblock
