// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/place_panels.h"

#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/document/visibility.h"
#include "ui/look/commands.h"
#include "ui/look/display.h"
#include "ui/look/theme.h"
#include "ui/panels/property_panel.h"
#include "ui/panels/scene_tree.h"
#include "ui/window/dock.h"

#include <QDockWidget>
#include <QMainWindow>

namespace keyblock {

namespace {

constexpr int treeWidth = 236, propertyWidth = 300;

/// A dock whose header is the panel's own.
QDockWidget* dockWithHeader(QMainWindow& window, const QString& id, const QString& title, QWidget* widget,
                            QWidget* header) {
    auto* dock = new QDockWidget(title, &window);
    dock->setObjectName(id);
    dock->setWidget(widget);
    dock->setTitleBarWidget(header);
    return dock;
}

}  // namespace

Panels placePanels(QMainWindow& window, const PanelNeeds& needs) {
    Panels panels;
    const FormContext context{needs.document, needs.display, needs.themes};
    panels.tree = new SceneTree(needs.document, needs.selection, needs.visibility, needs.display, needs.commands,
                                needs.themes, &window);
    panels.properties = new PropertyPanel(context, needs.selection, &window);
    panels.tree->setMinimumWidth(180);
    panels.properties->setMinimumWidth(280);
    QDockWidget* left = dockWithHeader(window, "sceneDock", QMainWindow::tr("Scene"), panels.tree, panels.tree->header());
    QDockWidget* right = dockWithHeader(window, "propertyDock", QMainWindow::tr("Properties"), panels.properties,
                                        new QWidget(&window));
    window.addDockWidget(Qt::LeftDockWidgetArea, left);
    window.addDockWidget(Qt::RightDockWidgetArea, right);
    window.resizeDocks({left, right}, {treeWidth, propertyWidth}, Qt::Horizontal);
    return panels;
}

}  // namespace keyblock
