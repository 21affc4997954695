// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/place_tools.h"

#include "ui/canvas/canvas.h"
#include "ui/look/commands.h"
#include "ui/look/theme.h"
#include "ui/tools/mode_line.h"
#include "ui/tools/tool_bar.h"
#include "ui/tools/tool_desk.h"
#include "ui/tools/tool_palette.h"
#include "ui/window/drawing_feed.h"
#include "ui/window/workflow_bar.h"

#include <QHBoxLayout>
#include <QMainWindow>
#include <QStatusBar>
#include <QVBoxLayout>

namespace keyblock {

CanvasPlaces placeTools(const ToolNeeds& needs) {
    auto* middle = new QWidget(&needs.window);
    middle->setObjectName("drawing");
    auto* row = new QHBoxLayout(middle);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    row->addWidget(&needs.desk.palette());
    auto* column = new QVBoxLayout;
    column->setSpacing(0);
    row->addLayout(column, 1);
    column->addWidget(&needs.desk.bar());
    auto* beside = new QHBoxLayout;
    beside->setSpacing(1);
    column->addLayout(beside, 1);
    beside->addWidget(&needs.canvas, 1);
    needs.window.setCentralWidget(middle);
    needs.window.statusBar()->addWidget(new ModeLine(needs.commands, needs.themes, &needs.window));
    ToolDesk& desk = needs.desk;
    QObject::connect(&needs.drawing, &DrawingFeed::switched, &desk, &ToolDesk::setDrawing);
    // Choosing a drawing tool while results are shown switches to the drawing.
    QObject::connect(&desk, &ToolDesk::drawingAsked, &needs.workflow,
                     [&workflow = needs.workflow] { workflow.choose(WorkStep::Geometry); });
    return {*column, *beside};
}

}  // namespace keyblock
