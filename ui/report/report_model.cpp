// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The model: its geometry, materials and bolt types with their units, and the stages.
#include "geometry/polygon.h"
#include "solver/results/result_names.h"
#include "solver/scene/bolt_steel.h"
#include "solver/scene/enum_names.h"
#include "solver/scene/lookup.h"
#include "solver/scene/number_text.h"
#include "solver/scene/units.h"
#include "ui/report/report_facts.h"

#include <algorithm>
#include <cmath>

namespace keyblock::report {

namespace {

const std::string none = "–";

std::string optionalIn(const std::optional<double>& value, std::string_view unit, const std::string& otherwise = none) {
    return value ? inUnit(*value, unit) : otherwise;
}

template <typename Enumeration>
std::string labelOf(Enumeration value) {
    const Words labels = labelsOf(value).empty() ? wordsOf(value) : labelsOf(value);
    return std::string(labels[static_cast<std::size_t>(value)]);
}

std::string pointText(const Point& point) { return coordinateText(point.x()) + ", " + coordinateText(point.y()); }

std::string sizeText(const std::vector<Point>& points) {
    const Box box = boxOf(points);
    return numeral(box.max.x() - box.min.x()) + " m × " + numeral(box.max.y() - box.min.y()) + " m";
}

std::string inSituText(const InSituStress& stress) {
    const auto term = [&](const char* name, double value, double gradient) {
        std::string text = std::string(name) + " " + inUnit(-value, "MPa") + " MPa";
        if (gradient != 0.0) text += " and " + inUnit(gradient, "kPa") + " kPa more per metre of depth";
        return text;
    };
    return "compression positive, at elevation " + coordinateText(stress.referenceY) +
           " m: " + term("σxx", stress.sxx, stress.gradientY.sxx) + "; " +
           term("σyy", stress.syy, stress.gradientY.syy) + "; " + term("σxy", -stress.sxy, -stress.gradientY.sxy);
}

std::string fixText(Fix fix) {
    switch (fix) {
        case Fix::All: return "fixed";
        case Fix::X: return "fixed in x";
        case Fix::Y: return "fixed in y";
        case Fix::XY: break;
    }
    return "fixed in x and y";
}

/// Domain, joints and cells from which the blocks were cut.
void addCutRows(const Scene& given, ReportTable& table) {
    const auto add = [&table](const char* item, const std::string& value) { table.rows.push_back({item, value}); };
    if (given.domain) add("Domain", sizeText(given.domain->boundary) + ", cut into blocks");
    if (!given.joints.empty()) add("Joints", std::to_string(given.joints.size()) + " drawn one by one");
    if (given.voronoi)
        add("Voronoi cells",
            "size " + numeral(given.voronoi->size) + " m, seed " + std::to_string(given.voronoi->seed));
    for (const ScenePattern& pattern : given.boltPatterns)
        add("Bolt pattern", pattern.name + ": " + pattern.type + " of " + numeral(pattern.length) + " m every " +
                                numeral(pattern.spacing) + " m along the wall of " + pattern.tunnel);
}

ReportTable geometryTable(const Facts& facts) {
    const Scene& scene = facts.scene();
    ReportTable table{"Model", {{"Item"}, {"Value"}}, {}};
    const auto add = [&table](const char* item, const std::string& value) { table.rows.push_back({item, value}); };
    add("Analysis", std::string(scene.analysis.plane == Plane::Strain ? "plane strain" : "plane stress") +
                        ", thickness " + numeral(scene.analysis.thickness) + " m");
    add("Gravity (x, y)", numeral(scene.analysis.gravity.x()) + ", " + numeral(scene.analysis.gravity.y()) + " m/s²");
    if (facts.request.given) addCutRows(*facts.request.given, table);
    add("Blocks", std::to_string(scene.blocks.size()));
    if (facts.run.blockNames().size() > scene.blocks.size())
        add("Cells and plates modelled as blocks", std::to_string(facts.run.blockNames().size()) + " bodies in all");
    for (const SceneTunnel& tunnel : scene.tunnels) {
        const bool round = tunnel.profile == ProfileKind::Circle;
        const std::string size = tunnel.profile == ProfileKind::Polygon ? sizeText(tunnel.points)
                                 : round                                ? "diameter " + numeral(tunnel.diameter) + " m"
                                         : numeral(tunnel.width) + " m × " + numeral(tunnel.height) + " m";
        add("Tunnel", tunnel.name + ": " + labelOf(tunnel.profile) + ", " + size);
    }
    add("Bolts", std::to_string(scene.bolts.size()));
    if (scene.inSituStress) add("In-situ stress", inSituText(*scene.inSituStress));
    for (const Support& support : scene.supports) {
        const std::string where = support.boundary  ? "side " + labelOf(*support.boundary)
                                  : support.blockAt ? "block at " + pointText(*support.blockAt)
                                  : support.point   ? "point at " + pointText(*support.point)
                                                    : "";
        add("Support", where + ": " + fixText(support.fix));
    }
    return table;
}

ReportTable materialTable(const Scene& scene) {
    ReportTable table{
        "Rock",
        {{"Material"}, {"Density, kg/m³", true}, {"Young's modulus, GPa", true}, {"Poisson's ratio", true}},
        {}};
    for (const auto& [name, material] : scene.materials)
        table.rows.push_back(
            {name, numeral(material.density), inUnit(material.youngsModulus, "GPa"), numeral(material.poissonsRatio)});
    return table;
}

ReportTable jointTable(const Scene& scene) {
    ReportTable table{"Joints",
                      {{"Joint material"},
                       {"Friction angle, °", true},
                       {"Residual friction angle, °", true},
                       {"Cohesion, kPa", true},
                       {"Tensile strength, kPa", true},
                       {"Normal stiffness, GPa/m", true},
                       {"Shear stiffness, GPa/m", true}},
                      {}};
    for (const auto& [name, joint] : scene.jointMaterials)
        table.rows.push_back({name, numeral(joint.frictionAngle),
                              joint.residualFrictionAngle ? numeral(*joint.residualFrictionAngle) : "unchanged",
                              inUnit(joint.cohesion, "kPa"), inUnit(joint.tensileStrength, "kPa"),
                              optionalIn(joint.normalStiffness, "GPa", "penalty"),
                              optionalIn(joint.shearStiffness, "GPa", "penalty")});
    return table;
}

ReportTable jointSetTable(const Scene& scene) {
    ReportTable table{"Joint sets",
                      {{"Set"},
                       {"Dip, °", true},
                       {"Deviation, °", true},
                       {"Spacing, m", true},
                       {"Deviation, m", true},
                       {"Trace length, m", true},
                       {"Bridge, m", true},
                       {"Seed", true}},
                      {}};
    for (const SceneJointSet& set : scene.jointSets)
        table.rows.push_back({set.name, numeral(set.dip), numeral(set.dipDeviation), numeral(set.spacing),
                              numeral(set.spacingDeviation), optionalIn(set.traceLength, "m", "through-going"),
                              numeral(set.bridge), std::to_string(set.seed)});
    return table;
}

std::string anchorText(const Anchor& anchor) {
    const char* per = anchor.at || anchor.per == Per::Node ? "" : "/m";
    std::string text(rowOf(anchor.law).title);
    if (rowOf(anchor.law).hasPoints) return text;
    text += " " + inUnit(anchor.stiffness, "MN") + " MN/m" + per;
    if (anchor.strength) text += ", strength " + inUnit(*anchor.strength, "kN") + " kN" + per;
    if (rowOf(anchor.law).hasResidual) text += ", residual " + inUnit(anchor.residual, "kN") + " kN" + per;
    return text;
}

/// The different bonds of a bolt type, each once.
std::string anchorsText(const std::vector<Anchor>& anchors) {
    std::vector<std::string> texts;
    for (const Anchor& anchor : anchors)
        if (const std::string text = anchorText(anchor); std::ranges::count(texts, text) == 0) texts.push_back(text);
    std::string all;
    for (const std::string& text : texts) all += (all.empty() ? "" : "; ") + text;
    return all.empty() ? none : all;
}

ReportTable boltTypeTable(const Scene& scene) {
    ReportTable table{"Bolt types",
                      {{"Type"},
                       {"Class"},
                       {"Bolts", true},
                       {"Diameter, mm", true},
                       {"Steel area, mm²", true},
                       {"Yield, kN", true},
                       {"Strength, kN", true},
                       {"Bond, per bolt"},
                       {"Plate strength, kN", true}},
                      {}};
    for (const BoltType& type : scene.boltTypes) {
        const auto count = std::ranges::count(scene.bolts, type.name, &Bolt::type);
        if (count == 0) continue;
        const BoltSteel steel = boltSteel(type);
        table.rows.push_back({type.name, labelOf(type.boltClass), std::to_string(count), inUnit(type.diameter, "mm"),
                              numeral(steel.area * 1e6), optionalIn(steel.yield, "kN", "linear"),
                              optionalIn(steel.tensile, "kN", "unlimited"), anchorsText(type.anchors),
                              optionalIn(type.plate.normalStrength, "kN", "unlimited")});
    }
    return table;
}

std::string joined(const std::vector<std::string>& names) {
    std::string text;
    for (const std::string& name : names) text += (text.empty() ? "" : ", ") + name;
    return text;
}

std::string counted(std::size_t count, const char* one, const char* more) {
    return std::to_string(count) + " " + (count == 1 ? one : more);
}

/// What a stage does, such as "excavates drift; releases walls to 30 %".
std::string actionsText(const Stage& stage) {
    std::vector<std::string> actions;
    if (!stage.excavate.empty()) actions.push_back("excavates " + joined(stage.excavate));
    if (stage.relaxation) actions.push_back("releases walls to " + percentText(*stage.relaxation) + " %");
    if (!stage.install.empty()) actions.push_back("installs " + joined(stage.install));
    if (!stage.remove.empty()) actions.push_back("removes " + joined(stage.remove));
    if (!stage.set.empty()) {
        std::vector<std::string> names;
        for (const StrengthChange& change : stage.set) names.push_back(change.jointMaterial);
        actions.push_back("changes the strength of " + joined(names));
    }
    if (!stage.loads.empty()) actions.push_back(counted(stage.loads.size(), "load", "loads"));
    if (!stage.motions.empty())
        actions.push_back(counted(stage.motions.size(), "prescribed motion", "prescribed motions"));
    if (!stage.dilations.empty()) actions.push_back(counted(stage.dilations.size(), "dilation", "dilations"));
    if (!stage.initialVelocities.empty())
        actions.push_back(counted(stage.initialVelocities.size(), "initial velocity", "initial velocities"));
    if (stage.baseAcceleration) actions.push_back("shakes the ground");
    if (stage.bodyAcceleration) actions.push_back("accelerates all blocks");
    if (stage.followsCollapse) actions.push_back("follows the collapse");
    std::string text;
    for (const std::string& action : actions) text += (text.empty() ? "" : "; ") + action;
    return text.empty() ? none : text;
}

}  // namespace

void addModel(const Facts& facts, ReportSection& section) {
    const Scene& scene = facts.scene();
    if (!scene.about.shows.empty()) addText(section, scene.about.shows);
    addTable(section, geometryTable(facts));
    addTable(section, materialTable(scene));
    addTable(section, jointTable(scene));
    if (facts.request.given) addTable(section, jointSetTable(*facts.request.given));
    addTable(section, boltTypeTable(scene));
}

void addStages(const Facts& facts, ReportSection& section) {
    ReportTable table{
        "Stages of the run", {{"Stage"}, {"Kind"}, {"Actions"}, {"Outcome"}, {"Time", true}, {"Steps", true}}, {}};
    std::vector<std::string> messages;
    for (std::size_t i = 0; i < facts.scene().stages.size(); ++i) {
        const Stage& stage = facts.scene().stages[i];
        const auto record = std::ranges::find_if(
            facts.stages, [&](const StageRecord& one) { return one.result.stage == static_cast<int>(i); });
        const bool begun = record != facts.stages.end();
        if (!begun && stage.followsCollapse) continue;
        const bool ended = begun && record->ended;
        const std::string unit = stage.kind == StageKind::Dynamic ? " s" : "";
        table.rows.push_back({stage.name, std::string(wordOf(stage.kind)), actionsText(stage),
                              ended   ? std::string(wordOf(record->result.outcome))
                              : begun ? "not ended"
                                      : "not begun",
                              ended ? numeral(record->result.time) + unit : none,
                              ended ? std::to_string(record->result.steps) : none});
        if (begun && !record->result.message.empty())
            messages.push_back("Stage '" + stage.name + "': " + record->result.message + ".");
    }
    addTable(section, std::move(table));
    addText(section, "The time of a static stage is its pseudo-time from 0 to 1.");
    for (const std::string& message : messages) addText(section, message);
}

}  // namespace keyblock::report
