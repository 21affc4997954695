// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/main_window.h"

#include "solver/study/study_file.h"
#include "ui/canvas/canvas.h"
#include "ui/document/document.h"
#include "ui/document/journal.h"
#include "ui/document/recent_files.h"
#include "ui/document/selection.h"
#include "ui/document/visibility.h"
#include "ui/look/commands.h"
#include "ui/look/display.h"
#include "ui/look/plain_labels.h"
#include "ui/look/theme.h"
#include "ui/panels/properties/property_panel.h"
#include "ui/runs/runs.h"
#include "ui/study/study_page.h"
#include "ui/tools/tool_desk.h"
#include "ui/window/drawing_feed.h"
#include "ui/window/export_binding.h"
#include "ui/window/file_commands.h"
#include "ui/window/file_drops.h"
#include "ui/window/file_menu.h"
#include "ui/window/file_notices.h"
#include "ui/window/help_binding.h"
#include "ui/window/import_binding.h"
#include "ui/window/layouts.h"
#include "ui/window/menus.h"
#include "ui/window/open_run.h"
#include "ui/window/panel_runs.h"
#include "ui/window/place_panels.h"
#include "ui/window/place_tools.h"
#include "ui/window/probe_binding.h"
#include "ui/window/report_binding.h"
#include "ui/window/run_area.h"
#include "ui/window/start_binding.h"
#include "ui/window/status_line.h"
#include "ui/window/study_room.h"
#include "ui/window/workflow_bar.h"

#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QHBoxLayout>
#include <QMenuBar>
#include <QScreen>
#include <QStackedWidget>
#include <QStringList>
#include <QStatusBar>
#include <QTabWidget>
#include <QToolBar>
#include <QToolButton>

#include <algorithm>

namespace keyblock {

namespace {

/// Commands whose results the start page would cover: tools, results and panels.
bool showsBelowStartPage(const QAction& action) {
    static const QStringList rooms{"tool.", "scene.", "run.", "time.", "panel.", "study."};
    static const QStringList others{"help.contents", "help.scene", "help.theory", "help.verification",
                                    "help.security", "view.probe", "view.fit",    "view.zoomBox"};
    const QString id = action.objectName();
    return others.contains(id) || std::any_of(rooms.begin(), rooms.end(), [&](const QString& room) { return id.startsWith(room); });
}

constexpr QSize roomOfFrame(8, 40);  // [px] frame added by the window manager; unknown before the window is shown

}  // namespace

MainWindow::MainWindow(Themes& themes)
    : themes_(themes), display_(new Display(this)), commands_(new Commands(themes, this)),
      document_(new Document(this)), journal_(new Journal(*document_, journalFolder(), this)),
      selection_(new Selection(this)), visibility_(new Visibility(*document_, this)),
      workflow_(new WorkflowBar(themes, this)),
      canvas_(new Canvas(themes, this)), drawing_(new DrawingFeed(*document_, *visibility_, *canvas_, this)),
      runs_(new RunArea({*this, themes, *display_, *commands_, *document_, *selection_, *canvas_, *drawing_,
                         *workflow_})) {
    setObjectName("studio");
    qApp->installEventFilter(new PlainLabels(this));
    resize(QSize(1600, 1000).boundedTo(screen()->availableSize() - roomOfFrame));
    selection_->follow(*document_);
    addFileCommands(*commands_, *document_, *this,
                    [this](const QString& path) { openPath(path, UnsavedEdits::Settled); });
    addImportCommands(*this, *commands_, *document_, themes_);
    addEditCommands(*commands_, *document_);
    addViewCommands(*commands_, themes_, *display_);
    addCanvasCommands(*commands_, *canvas_);
    addExportCommands(*this, *commands_, themes_, runs_->cursor(), runs_->choice(), runs_->settings(),
                      *canvas_);
    placeBars();
    placeCanvas();
    placeStudies();
    const Panels panels =
        placePanels(*this, {*document_, *selection_, *visibility_, *display_, *commands_, themes_, *canvas_});
    showRunsIn(panels, runs_->runs());
    quoteTradeIn(panels, runs_->accuracy());
    showResultsIn(panels, runs_->results());
    raiseAskedPanels(*workflow_, panels);
    connect(panels.properties, &PropertyPanel::varyAsked, studies_, &StudyRoom::vary);
    placeFileRooms();
    fillMenus(*menuBar(), *commands_);
    addToMenus(*this, *recent_, [this](const QString& path) { openPath(path); });
    layouts_->begin();
    connect(runs_, &RunArea::modeChanged, this, &MainWindow::arrange);
    connect(runs_, &RunArea::panelAsked, this, [this](QDockWidget* panel) { layouts_->reveal(*panel); });
    connect(workflow_, &WorkflowBar::chosen, this, &MainWindow::arrange);
    connect(document_, &Document::fileChanged, this, &MainWindow::showTitle);
    connect(document_, &Document::checkedChanged, this, &MainWindow::showStates);
    connect(runs_, &RunArea::statesChanged, this, &MainWindow::showStates);
    connect(journal_, &Journal::failed, this, [this](const QString& why) {
        statusBar()->showMessage(tr("Edits are no longer saved for recovery: %1").arg(why));
    });
    connect(journal_, &Journal::mended, this, [this] { statusBar()->showMessage(tr("Edits are saved for recovery again.")); });
    showTitle();
    showStates();
}

MainWindow::~MainWindow() = default;

void MainWindow::openPath(const QString& path) { openPath(path, UnsavedEdits::Ask); }

void MainWindow::openPath(const QString& path, UnsavedEdits edits) {
    if (path.endsWith(".kbrun", Qt::CaseInsensitive)) {
        start_->hide();
        openRun(*document_, runs_->runs(), path, *this, edits);
    } else if (path.endsWith(".json", Qt::CaseInsensitive) && isStudyFile(path.toStdString())) {
        start_->hide();
        studies_->open(path);
    } else if (isDrawing(path)) {
        openImport(*this, *document_, themes_, path);
    } else {
        openDocument(*document_, path, *this, edits);
    }
}

void MainWindow::begin(const QString& path) {
    if (path.isEmpty()) return beginWithStartPage(*start_);
    openPath(path);
    tellAbandoned(*start_, themes_, centralWidget());
}

void MainWindow::closeEvent(QCloseEvent* event) {
    event->setAccepted(mayDiscard(*document_, *this) && studies_->mayClose());
    if (!event->isAccepted()) return;
    layouts_->keep();
    runs_->runs().stopForClosing();
    journal_->close();
}

/// Places help, the start page and notices about files; then the layouts, which arrange all docks that exist by then.
void MainWindow::placeFileRooms() {
    addFileNotices(*this, *document_, themes_);
    QWidget* search = addHelp(*this, *commands_, themes_);
    new FileDrops(*this, [this](const QString& path) { openPath(path); });
    recent_ = new RecentFiles(*document_, this);
    start_ = addStartPage(*this, {themes_, *commands_, *document_, *journal_, *recent_});
    for (QAction* action : commands_->all())
        if (showsBelowStartPage(*action)) connect(action, &QAction::triggered, start_, &QWidget::hide);
    layouts_ = new Layouts(*this, *commands_);
    placeAtRight(*menuBar(), {layouts_->makeButton(menuBar()), search});
}

void MainWindow::placeBars() {
    auto* bar = new QToolBar(tr("Workflow"), this);
    bar->setObjectName("workflowBar");
    bar->setMovable(false);
    bar->toggleViewAction()->setEnabled(false);
    bar->addWidget(workflow_);
    bar->layout()->setContentsMargins({});  // the style sheet is applied before the bar has its object name
    addToolBar(Qt::TopToolBarArea, bar);
    for (const auto corner : {Qt::BottomLeftCorner, Qt::BottomRightCorner}) setCorner(corner, Qt::BottomDockWidgetArea);
    setTabPosition(Qt::AllDockWidgetAreas, QTabWidget::North);
    setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
}

void MainWindow::placeCanvas() {
    auto* desk = new ToolDesk(*canvas_, *document_, *selection_, *visibility_, *display_, themes_, *commands_, this);
    const CanvasPlaces places = placeTools({*this, *desk, *canvas_, *drawing_, *workflow_, *commands_, themes_});
    runs_->place(places.column, places.row);
    connect(desk, &ToolDesk::chosen, &runs_->probe(), &ProbeBinding::end);
    new StatusLine(*statusBar(), *document_, *canvas_, *display_);
}

/// Places the page of studies, which takes the place of the canvas.
void MainWindow::placeStudies() {
    ReportWindow* report = addReportCommand(*this, *commands_, runs_->cursor());
    studies_ = new StudyRoom({*this, *commands_, *document_, runs_->runs(), themes_, *workflow_, *report});
    auto* pages = new QStackedWidget(this);
    pages->addWidget(takeCentralWidget());
    pages->addWidget(studies_->page());
    setCentralWidget(pages);
    connect(studies_, &StudyRoom::statesChanged, this, &MainWindow::showStates);
}

/// Arranges the docks for drawing, results or studies, as the workflow and the canvas say.
void MainWindow::arrange() {
    const bool studies = workflow_->current() == WorkStep::Studies;
    static_cast<QStackedWidget*>(centralWidget())->setCurrentIndex(studies ? 1 : 0);
    layouts_->show(studies                 ? Arrangement::Studies
                   : runs_->showsResults() ? Arrangement::Results
                                           : Arrangement::Drawing);
}

void MainWindow::showStates() {
    WorkStates states = workStates(*document_->checked().scene, document_->checked().problems);
    runs_->addTo(states);
    studies_->addTo(states);
    workflow_->setStates(states);
}

void MainWindow::showTitle() {
    setWindowTitle(document_->title() + QStringLiteral("[*] – Keyblock Studio"));
    setWindowModified(document_->isModified());
}

}  // namespace keyblock
