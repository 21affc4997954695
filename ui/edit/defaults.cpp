// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/edit/defaults.h"

#include "geometry/polygon.h"
#include "solver/scene/lookup.h"
#include "solver/scene/shapes.h"
#include "solver/scene/structures.h"
#include "ui/edit/appended.h"
#include "ui/edit/settle.h"
#include "ui/edit/values.h"

#include <algorithm>

namespace keyblock {
namespace {

constexpr Material granite{.density = 2700.0, .youngsModulus = 50e9, .poissonsRatio = 0.2};
constexpr double share = 0.5;  // relaxation of the walls before bolts are installed, as a fraction
constexpr double usualDuration = 0.1;  // [s] duration of a rockburst and the failures after it
constexpr const char* usualBolt = "d-bolt-20";

void makeMaterial(const Scene&, void* made) { *static_cast<Material*>(made) = granite; }
void makeBlock(const Scene& scene, void* made) { static_cast<Block*>(made)->material = firstMaterial(scene); }
void makeDomain(const Scene& scene, void* made) {
    auto& domain = *static_cast<SceneDomain*>(made);
    domain.material = firstMaterial(scene);
    domain.boundary = {{-15.0, -15.0}, {15.0, -15.0}, {15.0, 15.0}, {-15.0, 15.0}};
}
void makeSet(const Scene& scene, void* made) {
    auto& set = *static_cast<SceneJointSet*>(made);
    constexpr double dips[] = {60.0, -60.0, 0.0, 90.0};  // different for each new set
    set.dip = dips[(std::max<std::size_t>(scene.jointSets.size(), 1) - 1) % 4];
    set.spacing = 2.0;
    if (scene.domain && scene.domain->boundary.size() >= 3) {
        const Box box = boxOf(scene.domain->boundary);
        set.origin = 0.5 * (box.min + box.max);
    }
}
void makeTunnel(const Scene&, void* made) {
    auto& tunnel = *static_cast<SceneTunnel*>(made);
    tunnel.profile = ProfileKind::DShape;
    tunnel.width = 5.0, tunnel.height = 5.0;
}
void makeVoronoi(const Scene&, void* made) { static_cast<SceneVoronoi*>(made)->size = 1.5; }
void makeCells(const Scene&, void* made) { static_cast<CellSettings*>(made)->size = 1.0; }
void makeBolt(const Scene&, void* made) {
    auto& bolt = *static_cast<Bolt*>(made);
    bolt.type = usualBolt;
    bolt.farEnd = {0.0, 2.4};
}
void makePattern(const Scene& scene, void* made) {
    auto& pattern = *static_cast<ScenePattern*>(made);
    pattern.type = usualBolt;
    pattern.spacing = 1.0;
    pattern.length = 2.4;
    if (scene.tunnels.empty()) return;
    pattern.tunnel = scene.tunnels.front().name;
    pattern.from = pattern.to = scene.tunnels.front().center;
}
void makeMotion(const Scene&, void* made) { static_cast<Motion*>(made)->table = {{0.0, 0.0}, {1.0, 0.001}}; }
void makeSine(const Scene&, void* made) { static_cast<Sine*>(made)->amplitude = 1.0; }

struct Maker {
    const Structure& (*structure)();
    void (*make)(const Scene&, void*);
};
constexpr Maker makers[] = {
    {tableOf<Material>, makeMaterial}, {tableOf<Block>, makeBlock}, {tableOf<SceneDomain>, makeDomain},
    {tableOf<SceneJointSet>, makeSet}, {tableOf<SceneTunnel>, makeTunnel}, {tableOf<SceneVoronoi>, makeVoronoi},
    {tableOf<CellSettings>, makeCells}, {tableOf<Bolt>, makeBolt}, {tableOf<ScenePattern>, makePattern},
    {tableOf<Motion>, makeMotion}, {tableOf<Sine>, makeSine}};

bool excavates(const Stage& stage, const std::string& name) {
    return std::find(stage.excavate.begin(), stage.excavate.end(), name) != stage.excavate.end();
}

/// The last stage that excavates; otherwise the first stage whose name contains "excavat"; −1 if there is none.
int excavatingStage(const Scene& scene) {
    int found = -1;
    for (std::size_t i = 0; i < scene.stages.size(); ++i)
        if (!scene.stages[i].excavate.empty()) found = static_cast<int>(i);
    for (std::size_t i = 0; found < 0 && i < scene.stages.size(); ++i)
        if (scene.stages[i].name.find("excavat") != std::string::npos) found = static_cast<int>(i);
    return found;
}

/// The stage that excavates the tunnel, or any tunnel if the name is empty; −1 if there is none.
int excavatingStage(const Scene& scene, const std::string& tunnel) {
    if (tunnel.empty()) return excavatingStage(scene);
    for (std::size_t i = 0; i < scene.stages.size(); ++i)
        if (excavates(scene.stages[i], tunnel)) return static_cast<int>(i);
    return -1;
}

void installAfter(Edit& edit, int excavating, const std::string& name) {
    std::vector<Stage>& stages = edit.scene.stages;
    const auto behind = stages.begin() + excavating + 1;
    const auto installs = std::find_if(behind, stages.end(), [](const Stage& stage) { return !stage.install.empty(); });
    if (installs != stages.end()) {
        installs->install.push_back(name);
        return;
    }
    Stage bolts;
    bolts.name = "bolts";
    for (int n = 2; std::any_of(stages.begin(), stages.end(), [&](const Stage& s) { return s.name == bolts.name; }); ++n)
        bolts.name = "bolts " + std::to_string(n);
    bolts.install = {name};
    const Stage& before = *(behind - 1);
    edit.notes.push_back("The new stage '" + bolts.name + "' after '" + before.name + "' installs " + name + ".");
    if (before.kind == StageKind::Static && !before.relaxation) {
        (behind - 1)->relaxation = share;
        bolts.relaxation = 1.0;
        edit.notes.push_back("Relaxation of the walls: 50 % in '" + before.name + "', 100 % in '" + bolts.name + "'.");
    }
    stages.insert(behind, std::move(bolts));
}

/// The tunnel that contains the bolt's head or has it on its wall; empty if there is none.
std::string tunnelAt(const Scene& scene, const Point& head) {
    for (const SceneTunnel& tunnel : scene.tunnels) {
        if (profileProblem(shapeOf(tunnel))) continue;
        const std::vector<Point> wall = outline(tunnelProfile(shapeOf(tunnel)));
        const Box box = boxOf(wall);
        if (locate(wall, head, 0.02 * (box.max - box.min).norm()) != Side::Outside) return tunnel.name;
    }
    return {};
}

}  // namespace

std::string outlineProblem(const std::vector<Point>& points) {
    if (points.size() < 3) return "An outline needs at least three corners.";
    if (!std::all_of(points.begin(), points.end(), isUsable)) return "A corner is too far away.";
    const Box box = boxOf(points);
    const double size = (box.max - box.min).norm();
    if (std::abs(signedArea(points)) <= 1e-9 * size * size) return "The outline has no area.";
    if (crossesItself(points, 1e-9 * size)) return "The outline crosses itself.";
    return {};
}

std::string firstMaterial(const Scene& scene) { return scene.materials.empty() ? "" : scene.materials.front().first; }

std::string firstJointMaterial(const Scene& scene) {
    return scene.jointMaterials.empty() ? "" : scene.jointMaterials.front().first;
}

Scene newScene() {
    Scene scene;
    scene.analysis.gravity = {0.0, -9.81};
    scene.materials = {{"granite", granite}};
    scene.jointMaterials = {{"joint", JointMaterial{}}};
    scene.stages.resize(2);
    scene.stages[0].name = "settle";
    scene.stages[1].name = "excavate";
    return scene;
}

void makeDefaults(const Scene& scene, const Structure& structure, void* made) {
    for (const Maker& maker : makers)
        if (&structure == &maker.structure()) maker.make(scene, made);
}

void supportSides(Edit& edit) {
    for (const auto& [side, fix] : {std::pair{BoundarySide::Bottom, Fix::XY}, std::pair{BoundarySide::Left, Fix::X},
                                    std::pair{BoundarySide::Right, Fix::X}}) {
        Support& support = edit.scene.supports.emplace_back();
        support.boundary = side;
        support.fix = fix;
    }
    edit.notes.push_back("The base is fixed, the sides are on vertical rollers.");
}

Edit withDomain(const Scene& scene, const std::vector<Point>& boundary) {
    Edit edit{scene, outlineProblem(boundary)};
    if (!edit.done()) return edit;
    if (!edit.scene.domain) {
        edit.scene.domain.emplace().material = firstMaterial(scene);
        if (edit.scene.domain->material.empty()) {
            edit.scene.materials.emplace_back("granite", granite);
            edit.scene.domain->material = "granite";
        }
    }
    edit.scene.domain->boundary = boundary;
    edit.made = "/domain";
    if (!scene.supports.empty()) return edit;
    supportSides(edit);
    return edit;
}

Edit withTunnel(const Scene& scene, const SceneTunnel& tunnel) {
    if (const auto problem = profileProblem(shapeOf(tunnel))) return {scene, "The tunnel cannot be drawn: " + problem->message + "."};
    Edit edit = appended(scene, &Scene::tunnels, "/tunnels", tunnel);
    const int stage = excavatingStage(scene);
    if (stage >= 0) edit.scene.stages[stage].excavate.push_back(edit.scene.tunnels.back().name);
    return edit;
}

Edit withPattern(const Scene& scene, const ScenePattern& pattern) {
    if (const auto problem = boltPatternProblem(patternOf(pattern))) return {scene, "The pattern cannot be laid out: " + problem->message + "."};
    if (findTunnel(scene, pattern.tunnel) < 0)
        return {scene, "A bolt pattern follows the wall of a tunnel. Draw a tunnel first."};
    Edit edit = appended(scene, &Scene::boltPatterns, "/bolt_patterns", pattern);
    const int stage = excavatingStage(scene, pattern.tunnel);
    if (stage >= 0) installAfter(edit, stage, edit.scene.boltPatterns.back().name);
    settle(edit.scene);
    return edit;
}

void installOnWall(Edit& edit, const Bolt& bolt) {
    const std::string tunnel = tunnelAt(edit.scene, bolt.head);
    const int stage = tunnel.empty() ? -1 : excavatingStage(edit.scene, tunnel);
    if (stage >= 0) installAfter(edit, stage, bolt.name);
}

Edit withStageKind(const Scene& scene, std::size_t stage, StageKind kind) {
    const std::string pointer = under("/stages", stage);
    Edit edit = setValueAt(scene, under(pointer, "kind"), std::string(kind == StageKind::Dynamic ? "dynamic" : "static"));
    if (!edit.done()) return edit;
    double& duration = edit.scene.stages[stage].duration;
    if (kind == StageKind::Dynamic && !(duration > 0.0)) duration = usualDuration;
    return edit;
}

Edit withBolt(const Scene& scene, const Bolt& bolt) {
    if (!isUsable(bolt.head) || !isUsable(bolt.farEnd) || !(lengthOf(bolt) > 0.0)) return {scene, "A bolt needs a length."};
    Edit edit = appended(scene, &Scene::bolts, "/bolts", bolt);
    installOnWall(edit, edit.scene.bolts.back());
    settle(edit.scene);
    return edit;
}

}  // namespace keyblock
