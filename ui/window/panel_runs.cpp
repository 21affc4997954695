// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/panel_runs.h"

#include "ui/docks/result_card.h"
#include "ui/panels/properties/property_panel.h"
#include "ui/panels/summary/model_summary_panel.h"
#include "ui/panels/tree/scene_tree.h"
#include "ui/runs/runs.h"
#include "ui/runs/trade_runs.h"
#include "ui/window/place_panels.h"

namespace keyblock {

namespace {

std::vector<RunRow> rowsOf(const Runs& runs) {
    std::vector<RunRow> rows;
    for (const RunEntry& entry : runs.entries()) {
        RunRow row{entry.path, entry.name(), entry.outcomeText(), entry.goesOn ? "running" : "result",
                   entry.path == runs.shown()};
        if (entry.ofEarlierScene) row.detail += Runs::tr(" (earlier version of the scene)");
        rows.push_back(std::move(row));
    }
    return rows;
}

}  // namespace

void showRunsIn(const Panels& panels, Runs& runs) {
    const auto list = [tree = panels.tree, &runs] { tree->setRuns(rowsOf(runs)); };
    for (const auto signal : {&Runs::listChanged, &Runs::shownChanged, &Runs::sessionChanged})
        QObject::connect(&runs, signal, panels.tree, list);
    QObject::connect(&runs, &Runs::sessionChanged, panels.summary,
                     [summary = panels.summary, &runs] { summary->setBusy(runs.isRunning()); });
    QObject::connect(panels.tree, &SceneTree::runChosen, &runs, &Runs::open);
    list();
}

void quoteTradeIn(const Panels& panels, const TradeRuns& trade) {
    QObject::connect(&trade, &TradeRuns::ended, panels.summary, [summary = panels.summary, &trade] {
        if (trade.problem().isEmpty())
            summary->setTrade({trade.scene(), trade.trade().quantities, trade.trade().points});
    });
}

void showResultsIn(const Panels& panels, ResultCard& results) {
    panels.properties->addAbove(&results);
    QObject::connect(&results, &ResultCard::subjectChanged, panels.properties, &PropertyPanel::setSubject);
}

}  // namespace keyblock
