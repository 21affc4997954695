// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/tools.h"

#include "solver/scene/lookup.h"
#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/look/commands.h"
#include "ui/tools/block_tool.h"
#include "ui/tools/bolt_tool.h"
#include "ui/tools/joint_set_tool.h"
#include "ui/tools/joint_tool.h"
#include "ui/tools/load_tool.h"
#include "ui/tools/measure_tool.h"
#include "ui/tools/monitor_tool.h"
#include "ui/tools/motion_tool.h"
#include "ui/tools/outline_tool.h"
#include "ui/tools/pattern_tool.h"
#include "ui/tools/select_tool.h"
#include "ui/tools/support_tool.h"
#include "ui/tools/tool_desk.h"
#include "ui/tools/tool_palette.h"
#include "ui/tools/tunnel_tool.h"

#include <QCoreApplication>

namespace keyblock {
namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(tools)
};

struct Row {
    const char* id;
    const char* text;
    const char* help;
    const char* key;  // empty: none
    bool begins;  // starts a group in the palette
};

constexpr Row rows[] = {
    {"select", QT_TRANSLATE_NOOP("tools", "Select"),
     QT_TRANSLATE_NOOP("tools", "Selects, moves and edits objects."), "S", false},
    {"outline", QT_TRANSLATE_NOOP("tools", "Outline"),
     QT_TRANSLATE_NOOP("tools", "Draws the outline of the rock, or of a region."), "", false},
    {"block", QT_TRANSLATE_NOOP("tools", "Block"),
     QT_TRANSLATE_NOOP("tools", "Draws a single block, separate from the rock that is cut."), "B", false},
    {"joint", QT_TRANSLATE_NOOP("tools", "Joint"),
     QT_TRANSLATE_NOOP("tools", "Draws a joint along a line."), "J", false},
    {"joint-set", QT_TRANSLATE_NOOP("tools", "Joint set"),
     QT_TRANSLATE_NOOP("tools", "Fills the rock with parallel joints."), "", false},
    {"tunnel", QT_TRANSLATE_NOOP("tools", "Tunnel"),
     QT_TRANSLATE_NOOP("tools", "Places a tunnel."), "T", false},
    {"bolt", QT_TRANSLATE_NOOP("tools", "Bolt"),
     QT_TRANSLATE_NOOP("tools", "Places a bolt, perpendicular to a wall if one is near."), "K", true},
    {"pattern", QT_TRANSLATE_NOOP("tools", "Bolt pattern"),
     QT_TRANSLATE_NOOP("tools", "Places bolts along the wall of a tunnel."), "P", false},
    {"support", QT_TRANSLATE_NOOP("tools", "Support"),
     QT_TRANSLATE_NOOP("tools", "Supports a side, a point or a block."), "", true},
    {"load", QT_TRANSLATE_NOOP("tools", "Load"),
     QT_TRANSLATE_NOOP("tools", "Adds a force or a pressure to a stage."), "", false},
    {"motion", QT_TRANSLATE_NOOP("tools", "Motion"),
     QT_TRANSLATE_NOOP("tools", "Prescribes the displacement of a block in a stage."), "", false},
    {"monitor", QT_TRANSLATE_NOOP("tools", "Monitor"),
     QT_TRANSLATE_NOOP("tools", "Monitors a point, an opening or a bolt during a run."), "", false},
    {"measure", QT_TRANSLATE_NOOP("tools", "Measure"),
     QT_TRANSLATE_NOOP("tools", "Measures lengths and angles."), "M", true},
};

struct ModeRow {
    const char* id;
    const char* text;
    const char* help;
    const char* key;
    bool PointingModes::*mode;
};

constexpr ModeRow modeRows[] = {
    {"draw.objectSnap", QT_TRANSLATE_NOOP("tools", "Object snap"),
     QT_TRANSLATE_NOOP("tools", "Snaps to end points, intersections and midpoints near the mouse."), "F3",
     &PointingModes::objectSnap},
    {"draw.ortho", QT_TRANSLATE_NOOP("tools", "Ortho"),
     QT_TRANSLATE_NOOP("tools", "Restricts drawing to horizontal and vertical; hold Shift to invert."), "F8",
     &PointingModes::ortho},
    {"draw.grid", QT_TRANSLATE_NOOP("tools", "Grid"),
     QT_TRANSLATE_NOOP("tools", "Shows a grid with round spacing."), "G", &PointingModes::gridShown},
    {"draw.gridSnap", QT_TRANSLATE_NOOP("tools", "Grid snap"),
     QT_TRANSLATE_NOOP("tools", "Snaps to grid points where no object is near."), "F9", &PointingModes::gridSnap},
};

}  // namespace

std::vector<std::unique_ptr<Tool>> makeAllTools(Workbench& bench) {
    std::vector<std::unique_ptr<Tool>> tools;
    tools.push_back(std::make_unique<SelectTool>(bench));
    tools.push_back(std::make_unique<OutlineTool>(bench));
    tools.push_back(std::make_unique<BlockTool>(bench));
    tools.push_back(std::make_unique<JointTool>(bench));
    tools.push_back(std::make_unique<JointSetTool>(bench));
    tools.push_back(std::make_unique<TunnelTool>(bench));
    tools.push_back(std::make_unique<BoltTool>(bench));
    tools.push_back(std::make_unique<PatternTool>(bench));
    tools.push_back(std::make_unique<SupportTool>(bench));
    tools.push_back(std::make_unique<LoadTool>(bench));
    tools.push_back(std::make_unique<MotionTool>(bench));
    tools.push_back(std::make_unique<MonitorTool>(bench));
    tools.push_back(std::make_unique<MeasureTool>(bench));
    return tools;
}

void addToolCommands(Commands& commands, ToolDesk& desk, ToolPalette& palette, std::vector<QAction*>& actions) {
    for (const Row& row : rows) {
        const QString id(row.id), name = Texts::tr(row.text);
        QList<QKeySequence> keys;
        if (*row.key) keys << QKeySequence(row.key);
        const bool draws = id != "select" && id != "measure";
        QAction* action = commands.add({"tool." + id, name, draws ? "Insert" : "Tools", id, Texts::tr(row.help), keys, true,
                                        row.begins ? QString(row.id) : QString()},
                                       [&desk, id] { desk.choose(id); });
        if (row.begins) palette.addLine();
        palette.add(action, name);
        actions.push_back(action);
    }
}

void addModeCommands(Commands& commands, Workbench& bench) {
    for (const ModeRow& row : modeRows) {
        QAction* action = commands.add({row.id, Texts::tr(row.text), "Tools", {}, Texts::tr(row.help),
                                        {QKeySequence(row.key)}, true, "modes"},
                                       [&bench, mode = row.mode] {
                                           PointingModes modes = bench.modes();
                                           modes.*mode = !(modes.*mode);
                                           bench.setModes(modes);
                                       });
        const auto show = [action, &bench, mode = row.mode] { action->setChecked(bench.modes().*mode); };
        QObject::connect(&bench, &Workbench::modesChanged, action, show);
        show();
    }
}

std::vector<int> selectedBolts(const Workbench& bench) {
    const Checked& checked = bench.document().checked();
    const Scene& scene = checked.cut ? checked.cut->scene : *checked.scene;
    std::vector<int> chosen;
    for (std::size_t i = 0; i < scene.bolts.size(); ++i)
        if (bench.selection().contains(QString::fromStdString(boltPointer(scene, i)))) chosen.push_back(static_cast<int>(i));
    return chosen;
}

}  // namespace keyblock
