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

QString text(const char* said) { return QCoreApplication::translate("tools", said); }

struct Row {
    const char* id;
    const char* text;
    const char* help;
    const char* key;  // empty: none
    bool begins;  // a group of the palette
};

constexpr Row rows[] = {
    {"select", "Select", "Chooses, drags and changes things.", "S", false},
    {"outline", "Outline", "Draws the outline of the rock, or of a region.", "", false},
    {"block", "Block", "Draws a block beside the rock that is cut.", "B", false},
    {"joint", "Joint", "Draws a joint along a line.", "J", false},
    {"joint-set", "Joint set", "Fills the rock with parallel joints.", "", false},
    {"tunnel", "Tunnel", "Places an opening.", "T", false},
    {"bolt", "Bolt", "Places a bolt, square to a wall where one is near.", "K", true},
    {"pattern", "Bolt pattern", "Places bolts along the wall of a tunnel.", "P", false},
    {"support", "Support", "Holds a side, a point or a block.", "", true},
    {"load", "Load", "Places a force or a pressure in a stage.", "", false},
    {"motion", "Motion", "Moves a block over a stage.", "", false},
    {"monitor", "Monitor", "Watches a point, an opening or a bolt.", "", false},
    {"measure", "Measure", "Tells lengths and angles.", "M", true},
};

struct ModeRow {
    const char* id;
    const char* text;
    const char* help;
    const char* key;
    bool PointingModes::*mode;
};

constexpr ModeRow modeRows[] = {
    {"draw.objectSnap", "Object snap", "Takes ends, crossings and middles near the mouse.", "F3", &PointingModes::objectSnap},
    {"draw.ortho", "Ortho", "Draws level and upright; Shift does the other for once.", "F8", &PointingModes::ortho},
    {"draw.grid", "Grid", "Shows a grid of round distances.", "G", &PointingModes::gridShown},
    {"draw.gridSnap", "Grid snap", "Takes places of the grid where nothing else is near.", "F9", &PointingModes::gridSnap},
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
        const QString id(row.id), name = text(row.text);
        QList<QKeySequence> keys;
        if (*row.key) keys << QKeySequence(row.key);
        const bool draws = id != "select" && id != "measure";
        QAction* action = commands.add({"tool." + id, name, draws ? "Insert" : "Tools", id, text(row.help), keys, true,
                                        row.begins ? QString(row.id) : QString()},
                                       [&desk, id] { desk.choose(id); });
        if (row.begins) palette.addLine();
        palette.add(action, name);
        actions.push_back(action);
    }
}

void addModeCommands(Commands& commands, Workbench& bench) {
    for (const ModeRow& row : modeRows) {
        QAction* action = commands.add({row.id, text(row.text), "Tools", {}, text(row.help), {QKeySequence(row.key)}, true,
                                        "modes"},
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
