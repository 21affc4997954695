// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/run_area.h"

#include "solver/results/result_names.h"
#include "ui/canvas/canvas.h"
#include "ui/docks/bolt_strip.h"
#include "ui/docks/curves.h"
#include "ui/docks/events_list.h"
#include "ui/docks/health_strip.h"
#include "ui/docks/quantity_table.h"
#include "ui/docks/result_card.h"
#include "ui/docks/run_list.h"
#include "ui/docks/run_log.h"
#include "ui/docks/run_status.h"
#include "ui/docks/run_warning.h"
#include "ui/docks/accuracy_panel.h"
#include "ui/docks/safety_panel.h"
#include "ui/docks/stress_panel.h"
#include "ui/docks/scale_panel.h"
#include "ui/docks/stability_panel.h"
#include "ui/docks/time_line.h"
#include "ui/docks/view_bar.h"
#include "ui/document/document.h"
#include "ui/look/commands.h"
#include "ui/look/display.h"
#include "ui/look/theme.h"
#include "ui/runs/block_choice.h"
#include "ui/runs/bolt_choice.h"
#include "ui/runs/comparison.h"
#include "ui/runs/live_run.h"
#include "ui/runs/pinned_values.h"
#include "ui/runs/run_commands.h"
#include "ui/runs/run_session.h"
#include "ui/runs/runs.h"
#include "ui/runs/safety_search.h"
#include "ui/runs/stress_runs.h"
#include "ui/runs/trade_runs.h"
#include "ui/runs/section_feed.h"
#include "ui/runs/time_cursor.h"
#include "ui/runs/view_settings.h"
#include "ui/window/compare_area.h"
#include "ui/window/dock.h"
#include "ui/window/drawing_feed.h"
#include "ui/window/probe_binding.h"
#include "ui/window/result_selection.h"
#include "ui/window/workflow_bar.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QStatusBar>
#include <QVBoxLayout>

namespace keyblock {

namespace {

constexpr int messageTime = 8000;  // [ms]

}  // namespace

RunArea::RunArea(const RunAreaParts& parts)
    : QObject(&parts.window), parts_(parts), cursor_(new TimeCursor(this)),
      choice_(new BoltChoice(parts.document, parts.selection, *cursor_, this)),
      blocks_(new BlockChoice(*cursor_, *choice_, this)), runs_(new Runs(parts.document, *cursor_, this)),
      settings_(new ViewSettings(this)), feed_(new SectionFeed(*choice_, *cursor_, *settings_, parts.display, this)),
      pins_(new Pins(*cursor_, this)),
      results_(new ResultCard(parts.themes, parts.display, *cursor_, *choice_, *blocks_, &parts.window)),
      comparison_(new Comparison(*cursor_, this)), safety_(new SafetySearch(parts.document, this)),
      accuracy_(new TradeRuns(parts.document, this)), stress_(new StressRuns(parts.document, this)) {
    addRunCommands(parts.commands, *runs_);
    addTimeCommands(parts.commands, *cursor_);
    // Created before the probe, whose pins have a context menu of their own.
    picking_ = new ResultSelection({parts.canvas, parts.themes, parts.commands, *feed_, *choice_, *blocks_,
                                    [this](const Pick& pick, const Point& place) { probe_->pin(pick, place); }},
                                   this);
    probe_ = new ProbeBinding({parts.canvas, parts.commands, parts.document, parts.themes, *cursor_, *feed_, *settings_,
                               *pins_},
                              [this](const QString& message) { tell(message, false); }, this);
    compare_ = new CompareArea({parts.window, parts.themes, parts.display, parts.commands, parts.document, parts.selection,
                                parts.canvas, *runs_, *comparison_, *feed_, *settings_},
                               this);
    connect(feed_, &SectionFeed::modeChanged, this, &RunArea::showMode);
    connect(feed_, &SectionFeed::pictureChanged, this, &RunArea::showPicture);
    connect(choice_, &BoltChoice::changed, this, &RunArea::showSelection);
    connect(&parts.workflow, &WorkflowBar::chosen, this, &RunArea::followTabs);
    connect(&parts.workflow, &WorkflowBar::asked, this, [this](WorkStep step) {
        if (step == WorkStep::Results && !cursor_->run()) runs_->openNewest();
    });
    connect(runs_, &Runs::sessionChanged, this, &RunArea::statesChanged);
    connect(cursor_, &TimeCursor::runChanged, this, [this] {
        askBlock(-1, {});
        if (cursor_->run()) parts_.workflow.choose(WorkStep::Results);
        Q_EMIT statesChanged();
    });
    connect(&parts.canvas, &Canvas::legendClicked, this, &RunArea::openScale);
    connect(&parts.document, &Document::replaced, this, [this] {
        if (!cursor_->run()) parts_.workflow.choose(WorkStep::Geometry);
    });
    connect(&parts.canvas, &Canvas::spaceTapped, parts.commands.action("time.play"), &QAction::trigger);
}

RunArea::~RunArea() = default;

void RunArea::place(QVBoxLayout& aboveCanvas, QBoxLayout& besideCanvas) {
    bar_ = new ViewBar(parts_.themes, parts_.commands, *settings_, &parts_.window);
    aboveCanvas.insertWidget(0, bar_);
    bar_->setVisible(feed_->showsResults());
    warning_ = new RunWarning(parts_.themes, *cursor_, &parts_.window);
    aboveCanvas.insertWidget(1, warning_);
    parts_.workflow.addRight(new RunStatus(parts_.themes, parts_.commands, *runs_, &parts_.workflow));
    placeDocks(besideCanvas);
    connect(runs_, &Runs::reported, this, &RunArea::tell);
    connect(comparison_, &Comparison::failed, this, [this](const QString& message) { tell(message, true); });
    connect(feed_, &SectionFeed::failed, this, [this](const QString& message) { log_->tell(message, true); });
    showMode();
}

bool RunArea::showsResults() const { return feed_->showsResults(); }

void RunArea::tell(const QString& message, bool isError) {
    log_->tell(message, isError);
    parts_.window.statusBar()->showMessage(message, messageTime);
}

void RunArea::placeDocks(QBoxLayout& besideCanvas) {
    QMainWindow& window = parts_.window;
    const Themes& themes = parts_.themes;
    auto* line = new TimeLine(themes, parts_.display, parts_.commands, *cursor_, *choice_, &window);
    QDockWidget* time = makeBand(window, "timeDock", tr("Timeline"), line);
    health_ = new HealthStrip(themes, *cursor_, &window);
    events_ = new EventsList(themes, parts_.display, *cursor_, *choice_, &window);
    log_ = new RunLog(themes, &window);
    auto* bolt = new BoltStrip(themes, parts_.display, *cursor_, *choice_, &window);
    QDockWidget* strip = makeDock(window, themes, "stripDock", tr("Bolt diagram"), bolt);
    connect(bolt, &BoltStrip::titleChanged, strip, [strip, bolt] {
        const QString shown = bolt->title();
        strip->setWindowTitle(shown.isEmpty() ? tr("Bolt diagram") : tr("Bolt diagram   %1").arg(shown));
    });
    auto* allCurves = new Curves(themes, parts_.display, *cursor_, CurveKind::All, pins_, &window);
    auto* energies = new Curves(themes, parts_.display, *cursor_, CurveKind::Energies, nullptr, &window);
    QDockWidget* curves = makeDock(window, themes, "curvesDock", tr("Curves"), allCurves);
    auto* stability = new StabilityPanel(themes, parts_.display, *cursor_, *choice_, &window);
    QDockWidget* verdict = makeDock(window, themes, "stabilityDock", tr("Stability"), stability);
    QDockWidget* health = makeDock(window, themes, "healthDock", tr("Solver"), health_);
    eventsDock_ = makeDock(window, themes, "eventsDock", tr("Events"), events_);
    QDockWidget* energy = makeDock(window, themes, "energyDock", tr("Energy"), energies);
    auto* quantities = new QuantityTable(themes, *cursor_, &window);
    QDockWidget* asked = makeDock(window, themes, "quantitiesDock", tr("Quantities"), quantities);
    QDockWidget* safety = makeDock(window, themes, "safetyDock", tr("Safety"), new SafetyPanel(*safety_, &window));
    parts_.commands.add({"run.safety",
                         tr("Find factor of safety"),
                         "Run",
                         {},
                         tr("Runs the scene repeatedly with reduced strengths until it fails."),
                         {},
                         false,
                         "safety"},
                        [this, safety] {
                            Q_EMIT panelAsked(safety);
                            safety_->start();
                        });
    QDockWidget* accuracy = makeDock(window, themes, "accuracyDock", tr("Accuracy"),
                                     new AccuracyPanel(themes, parts_.document, *accuracy_, &window));
    parts_.commands.add({"run.accuracy",
                         tr("Measure accuracy and time"),
                         "Run",
                         {},
                         tr("Runs the scene with coarser and finer numerical settings and compares the results."),
                         {},
                         false,
                         "safety"},
                        [this, accuracy] {
                            Q_EMIT panelAsked(accuracy);
                            accuracy_->start();
                        });
    QDockWidget* stress = makeDock(window, themes, "stressDock", tr("Stress test"), new StressPanel(*stress_, &window));
    parts_.commands.add({"run.stress",
                         tr("Stress test"),
                         "Run",
                         {},
                         tr("Runs the scene with larger and smaller settings and loads and shows what breaks first."),
                         {},
                         false,
                         "safety"},
                        [this, stress] {
                            Q_EMIT panelAsked(stress);
                            stress_->start();
                        });
    parts_.commands.add({"view.activity",
                         tr("Show modelled blocks"),
                         "Results",
                         {},
                         tr("Colours the blocks that are active, asleep and fixed, or shows their quantity again."),
                         {},
                         false,
                         "block"},
                        [this] {
                            ViewChoice choice = settings_->choice();
                            choice.activity = !choice.activity;
                            settings_->choose(choice);
                        });
    compare_->place(besideCanvas, *allCurves, *energies);
    QDockWidget* list = makeDock(window, themes, "runsDock", tr("Runs"),
                                 new RunList(themes, parts_.commands, *runs_, *comparison_, &window));
    QDockWidget* log = makeDock(window, themes, "logDock", tr("Log"), log_);
    for (QDockWidget* dock :
         {time, strip, curves, verdict, health, eventsDock_, asked, safety, accuracy, stress, energy, list, log})
        window.addDockWidget(Qt::BottomDockWidgetArea, dock);  // until the layouts arrange it
    connect(health_, &HealthStrip::blockAsked, this, &RunArea::askBlock);
    const auto outline = [this](int block, const QString& what) {
        asked_ = -1;
        askBlock(block, what);
    };
    connect(events_, &EventsList::blockAsked, this, outline);
    connect(stability, &StabilityPanel::blockAsked, this, outline);
    connect(events_, &EventsList::countChanged, this, &RunArea::nameTabs);
}

/// Shows the number of events in the title of their tab.
void RunArea::nameTabs() {
    const std::size_t count = events_->count();
    const QString title = count > 0 ? tr("Events  %1").arg(count) : tr("Events");
    if (eventsDock_->windowTitle() != title) eventsDock_->setWindowTitle(title);
}

void RunArea::showMode() {
    const bool results = feed_->showsResults();
    if (bar_) bar_->setVisible(results);
    if (warning_) warning_->setOn(results);
    parts_.drawing.setOn(!results);
    results_->setOn(results);
    Q_EMIT modeChanged(results);
    if (!results) return askBlock(-1, {});  // the blocks of a run are not those of the drawing
    parts_.canvas.setDrawing(false);
    showPicture();
    showSelection();
}

void RunArea::showPicture() {
    if (!feed_->showsResults() || !feed_->picture()) return;
    parts_.canvas.show(feed_->picture());
    if (warning_) warning_->setNotFinite(feed_->picture()->notFinite);
}

void RunArea::showSelection() {
    if (!feed_->showsResults()) return;
    parts_.canvas.setSelectedBolts(choice_->bolt() >= 0 ? std::vector<int>{choice_->bolt()} : std::vector<int>{});
}

/// Opens the scale settings of a quantity whose bar in the legend was clicked.
void RunArea::openScale(LegendPart part, const QPoint& at) {
    if (!feed_->picture()) return;
    const bool ofBlocks = part == LegendPart::Blocks;
    const auto& bar = ofBlocks ? feed_->picture()->blockLegend : feed_->picture()->boltLegend;
    if (bar) (new ScalePanel(*bar, parts_.display.numbers(), ofBlocks, *settings_, &parts_.window))->openAt(at);
}

/// The steps Run and Results show the results; the other steps show the drawing.
void RunArea::followTabs(WorkStep step) { feed_->showResults(step == WorkStep::Run || step == WorkStep::Results); }

/// Outlines a block, with a note that gives the reason. Removes the outline if the block already has it or there is no
/// block.
void RunArea::askBlock(int block, const QString& why) {
    asked_ = block == asked_ ? -1 : block;
    if (asked_ < 0 || !cursor_->run()) return parts_.canvas.setHighlighted(std::nullopt);
    const QString name = QString::fromStdString(blockName(cursor_->run()->blockNames(), asked_));
    parts_.canvas.setHighlighted(HighlightedBlock{asked_, tr("Block %1").arg(name), why});
}

void RunArea::addTo(WorkStates& states) const {
    const auto state = [&](WorkStep step) -> WorkState& { return states[static_cast<std::size_t>(step)]; };
    if (runs_->isRunning()) {
        state(WorkStep::Run) = WorkState::Running;
    } else if (const RunSession* session = runs_->session(); session && session->failed()) {
        state(WorkStep::Run) = WorkState::Error;
    } else if (const LiveRun* run = cursor_->run().get()) {
        const bool whole = isFinished(*run) && endedAsPlanned(run->stageList().back().result.outcome);
        state(WorkStep::Run) = whole ? WorkState::Done : WorkState::Warning;
    } else {
        state(WorkStep::Run) = WorkState::NotYet;
    }
}

}  // namespace keyblock
