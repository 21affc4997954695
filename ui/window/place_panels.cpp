// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/place_panels.h"

#include "ui/canvas/canvas.h"
#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/document/visibility.h"
#include "ui/edit/scene_objects.h"
#include "ui/look/commands.h"
#include "ui/look/display.h"
#include "ui/look/theme.h"
#include "ui/panels/library/library_panel.h"
#include "ui/panels/problems/problems_panel.h"
#include "ui/panels/properties/property_panel.h"
#include "ui/panels/stages/stages_panel.h"
#include "ui/panels/summary/model_summary_panel.h"
#include "ui/panels/tree/scene_tree.h"
#include "ui/window/dock.h"
#include "ui/window/workflow_bar.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QTimer>

#include <algorithm>
#include <optional>

namespace keyblock {

namespace {

/// Makes a dock with the panel's own header.
QDockWidget* dockWithHeader(QMainWindow& window, const QString& id, const QString& title, QWidget* widget,
                            QWidget* header) {
    auto* dock = new QDockWidget(title, &window);
    dock->setObjectName(id);
    dock->setWidget(widget);
    dock->setTitleBarWidget(header);
    return dock;
}

/// Box around the shapes of the objects; none if no object has a position.
std::optional<Box> boxRound(const Scene& scene, const QStringList& pointers) {
    std::vector<Point> corners;
    for (const SceneObject& object : objectsOf(scene)) {
        if (!pointers.contains(QString::fromStdString(object.pointer))) continue;
        if (const auto box = boxOf(object)) corners.insert(corners.end(), {box->min, box->max});
    }
    return corners.empty() ? std::nullopt : std::optional(boxOf(corners));
}

void zoomTo(Canvas& canvas, const Box& box) {
    const double size = (box.max - box.min).maxCoeff();
    canvas.zoomTo(grown(box, std::max(1.0, 0.25 * size)));
}

void placeBelow(QMainWindow& window, const PanelNeeds& needs, Panels& panels) {
    const FormContext context{needs.document, needs.display, needs.themes};
    panels.problems = new ProblemsPanel(needs.document, needs.selection, needs.display, needs.themes, &window);
    panels.summary = new ModelSummaryPanel(needs.document, needs.commands, needs.themes, &window);
    panels.stages = new StagesPanel(context, needs.selection, &window);
    panels.library = new LibraryPanel(context, needs.selection, &window);
    panels.problemsDock = makeDock(window, needs.themes, "problemsDock", QMainWindow::tr("Problems"), panels.problems);
    // Saved layouts refer to the dock by this name.
    panels.summaryDock = makeDock(window, needs.themes, "censusDock", QMainWindow::tr("Model summary"), panels.summary);
    panels.stagesDock = makeDock(window, needs.themes, "stagesDock", QMainWindow::tr("Stages"), panels.stages);
    panels.libraryDock =
        makeDock(window, needs.themes, "libraryDock", QMainWindow::tr("Bolt library"), panels.library);
    for (QDockWidget* dock : {panels.problemsDock, panels.summaryDock, panels.stagesDock, panels.libraryDock})
        window.addDockWidget(Qt::BottomDockWidgetArea, dock);  // until the layouts arrange it
    needs.commands.add({"panel.library", QMainWindow::tr("Open bolt library"), "Tools", "bolt",
                        QMainWindow::tr("Shows the bolt types, their parameters and the source of each value."),
                        {}, false, "library"},
                       [dock = panels.libraryDock] {
                           dock->show();
                           dock->raise();
                       });
    QObject::connect(panels.properties, &PropertyPanel::libraryAsked, panels.libraryDock,
                     [dock = panels.libraryDock, library = panels.library](const QString& type) {
                         dock->show();
                         dock->raise();
                         library->choose(type);
                     });
    const auto badge = [dock = panels.problemsDock](int urgent) {
        dock->setWindowTitle(urgent > 0 ? QMainWindow::tr("Problems  %1").arg(urgent) : QMainWindow::tr("Problems"));
    };
    QObject::connect(panels.problems, &ProblemsPanel::countChanged, panels.problemsDock, badge);
    QObject::connect(panels.problems, &ProblemsPanel::fieldAsked, panels.properties, &PropertyPanel::focusPointer);
    QObject::connect(panels.problems, &ProblemsPanel::placeAsked, &needs.canvas,
                     [canvas = &needs.canvas](const Box& box) { zoomTo(*canvas, box); });
    QObject::connect(panels.tree, &SceneTree::zoomAsked, &needs.canvas,
                     [canvas = &needs.canvas, document = &needs.document](const QStringList& pointers) {
                         if (const auto box = boxRound(*document->scene(), pointers)) zoomTo(*canvas, *box);
                     });
}

}  // namespace

Panels placePanels(QMainWindow& window, const PanelNeeds& needs) {
    Panels panels;
    const FormContext context{needs.document, needs.display, needs.themes};
    panels.tree = new SceneTree(needs.document, needs.selection, needs.visibility, needs.display, needs.commands,
                                needs.themes, &window);
    needs.commands.add({"scene.inSituStress", QMainWindow::tr("In-situ stress"), "Insert", "stress-cross",
                        QMainWindow::tr("Adds the stress in the rock before excavation, constant or increasing with "
                                        "depth."),
                        {}, false, "stress"},
                       [tree = panels.tree] { tree->addInSituStress(); });
    panels.properties = new PropertyPanel(context, needs.selection, &window);
    panels.tree->setMinimumWidth(140);
    panels.properties->setMinimumWidth(240);
    QDockWidget* left =
        dockWithHeader(window, "sceneDock", QMainWindow::tr("Scene"), panels.tree, panels.tree->header());
    QDockWidget* right = dockWithHeader(window, "propertyDock", QMainWindow::tr("Properties"), panels.properties,
                                        new QWidget(&window));
    window.addDockWidget(Qt::LeftDockWidgetArea, left);
    window.addDockWidget(Qt::RightDockWidgetArea, right);
    window.resizeDocks({left, right}, {treeWidth, propertyWidth}, Qt::Horizontal);
    placeBelow(window, needs, panels);
    return panels;
}

void raiseAskedPanels(WorkflowBar& bar, const Panels& panels) {
    const auto raise = [support = panels.libraryDock, stages = panels.stagesDock](WorkStep step) {
        QDockWidget* dock = step == WorkStep::Support ? support : step == WorkStep::Stages ? stages : nullptr;
        if (!dock) return;
        QTimer::singleShot(0, dock, [dock] {  // deferred, because the step may change the arrangement first
            dock->show();
            dock->raise();
        });
    };
    QObject::connect(&bar, &WorkflowBar::asked, panels.stagesDock, raise);
}

}  // namespace keyblock
