// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/probe_binding.h"

#include "solver/scene/solved_blocks.h"
#include "ui/canvas/canvas.h"
#include "ui/canvas/probe_tool.h"
#include "ui/document/document.h"
#include "ui/edit/edits.h"
#include "ui/look/commands.h"
#include "ui/picture/section/deformed.h"
#include "ui/runs/live_run.h"
#include "ui/runs/pinned_values.h"
#include "ui/runs/section_feed.h"
#include "ui/runs/time_cursor.h"
#include "ui/runs/view_settings.h"

#include <QAction>

#include <algorithm>

namespace keyblock {

namespace {

/// Quantity of a new pin: the one shown, else the most common one.
const FrameQuantity<BlockState>* ofBlocks(const ViewChoice& choice) {
    return choice.blocks ? choice.blocks : findQuantity(blockQuantities(), "displacement");
}
const FrameQuantity<BoltNodeFrame>* ofBolts(const ViewChoice& choice) {
    return choice.bolts ? choice.bolts : findQuantity(BoltQuantity::AxialForce);
}

Monitor monitorOf(const Pin& pin, const Scene& solved) {
    Monitor monitor;
    if (pin.block >= 0) {
        monitor.point = placeBefore(pin, cornersBefore(solvedBlocks(solved)));
        return monitor;
    }
    monitor.bolt = solved.bolts[pin.bolt].name;
    monitor.quantity = rowOf(*pin.ofBolt).quantity;
    monitor.at = pin.s;
    return monitor;
}

}  // namespace

ProbeBinding::ProbeBinding(const ProbeNeeds& needs, std::function<void(const QString&)> tell, QObject* parent)
    : QObject(parent), needs_(needs), tell_(std::move(tell)) {
    probe_ = new Probe(
        needs.canvas, needs.themes,
        [feed = &needs.feed, settings = &needs.settings, canvas = &needs.canvas](
            const Pick& pick) -> std::optional<ProbeReading> {
            if (!feed->frame() || feed->picture() != canvas->picture()) return std::nullopt;
            return probed(*feed->picture(), *feed->frame(), pick, settings->choice().blocks, settings->choice().bolts);
        },
        this);
    QAction* action = needs.commands.add(
        {"view.probe", tr("Probe"), "Results", "probe",
         tr("Shows values at the cursor; click to pin a point and plot its values over time under Curves."),
         {QKeySequence(Qt::Key_V)}, true},
        [this, &needs = needs_] { probe_->setOn(needs.commands.action("view.probe")->isChecked()); });
    connect(probe_, &Probe::switched, action, &QAction::setChecked);
    connect(probe_, &Probe::pinned, this, &ProbeBinding::pin);
    connect(probe_, &Probe::unpinAsked, &needs.pins, &Pins::remove);
    connect(probe_, &Probe::unpinAllAsked, &needs.pins, &Pins::clear);
    connect(probe_, &Probe::keepAsked, this, &ProbeBinding::keep);
    connect(&needs.pins, &Pins::changed, this, [this] { probe_->setPins(needs_.pins.pins()); });
    connect(&needs.pins, &Pins::failed, this, [this](const QString& why) { tell_(why); });
    const auto enable = [this, action] {
        const bool results = needs_.feed.showsResults();
        action->setEnabled(results);
        if (!results) end();
        probe_->setPins(results ? needs_.pins.pins() : std::vector<Pin>());
    };
    connect(&needs.feed, &SectionFeed::modeChanged, this, enable);
    enable();
}

void ProbeBinding::pin(const Pick& pick, const Point& place) {
    const ViewChoice& choice = needs_.settings.choice();
    needs_.pins.add(pinAt(*needs_.canvas.picture(), pick, place, ofBlocks(choice), ofBolts(choice)));
}

void ProbeBinding::end() { probe_->setOn(false); }

void ProbeBinding::keep(int number) {
    const std::vector<Pin> pins = needs_.pins.pins();
    const auto pin = std::find_if(pins.begin(), pins.end(), [&](const Pin& p) { return p.number == number; });
    if (pin == pins.end() || !needs_.cursor.run()) return;
    const Edit edit = withMonitor(*needs_.document.committed(), monitorOf(*pin, needs_.cursor.run()->scene()));
    if (!edit.done()) return tell_(QString::fromStdString(edit.refusal));
    const QString title = QString::fromStdString(titleAt(edit.scene, edit.made));
    needs_.document.apply(tr("Add %1").arg(title), edit.scene);
    tell_(tr("Added %1; the next run records its history.").arg(title));
}

}  // namespace keyblock
