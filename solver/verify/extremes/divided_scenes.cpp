// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Sections that are cut, blocks divided into cells, and values that no scene may have.
#include "solver/verify/extremes/scene_parts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace keyblock {

namespace {

using SectionAxes = std::vector<std::string>;

constexpr double width = 8.0, height = 6.0;  // [m] of the domain

Scene section(const Conditions& c) {
    Scene scene = conditionedScene(c);
    SceneDomain domain;
    domain.boundary = {{0, 0}, {width, 0}, {width, height}, {0, height}};
    domain.material = "rock";
    scene.domain = domain;
    for (const BoundarySide side : {BoundarySide::Left, BoundarySide::Right, BoundarySide::Bottom}) {
        if (c.turn != 0.0) continue;  // sides have names only in a domain that is not turned
        Support support;
        support.boundary = side;
        support.fix = side == BoundarySide::Bottom ? Fix::XY : Fix::X;
        scene.supports.push_back(support);
    }
    Stage stage = conditionedRest();
    scene.stages = {stage};
    return scene;
}

SceneJoint sectionJoint(const std::string& name, const Point& from, const Point& to) {
    SceneJoint joint;
    joint.name = name;
    joint.points = {from, to};
    return joint;
}

/// A vertex of a regular polygon about `center`.
Point around(const Point& center, double radius, double turn) {
    return center + radius * Point(std::cos(2.0 * std::numbers::pi * turn), std::sin(2.0 * std::numbers::pi * turn));
}

SceneTunnel opening(const Point& center, double diameter) {
    SceneTunnel tunnel;
    tunnel.name = "drift";
    tunnel.profile = ProfileKind::Polygon;
    for (int i = 0; i < 24; ++i) tunnel.points.push_back(around(center, 0.5 * diameter, i / 24.0));
    return tunnel;
}

double area(const std::vector<Point>& points) {
    double twice = 0.0;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Point &a = points[i] - points[0], &b = points[(i + 1) % points.size()] - points[0];
        twice += a.x() * b.y() - a.y() * b.x();
    }
    return 0.5 * std::abs(twice);
}

double openingArea(const Scene& scene) {
    double sum = 0.0;
    for (const SceneTunnel& tunnel : scene.tunnels) sum += area(tunnel.points);
    return sum;
}

/// No rock is lost in the cut, and every block that is not supported is in balance with its contact forces.
void judgeSection(const Conditions& c, const Solved& solved, Findings& findings) {
    double sum = 0.0;
    for (const Block& block : solved.scene.blocks) sum += area(block.points);
    const double expected = width * height - openingArea(solved.scene);
    findings.near("area of the blocks, m²", sum, expected, 1e-6 * expected);
    findings.holds("the rock is stable", endedWell(solved));
    const double weight = c.density * c.gravity * expected * c.thickness;
    double pulled = 0.0;
    for (const ContactFrame& contact : solved.results.frames.back().contacts)
        if (contact.state != ContactState::Bonded) pulled = std::max(pulled, -contact.normalForce);
    findings.atMost("largest tension in a joint without tensile strength, N", pulled, 0.0, 1e-3 * weight);
    double lowest = 0.0;
    for (const BlockState& block : solved.results.frames.back().blocks)
        lowest = std::max(lowest, block.displacement.norm());
    // 6 m of rock under their own weight settle by ρgh²/2E, and every joint by its own contact
    const double settles = c.density * c.gravity * height * height / c.modulus;
    findings.atMost("movement, m", lowest, 0.0, settles * (4.0 + 200.0 / c.penalty));
}

/// Two nearly parallel joints, `ratio` metres apart.
Scene nearlyParallel(const Conditions& c) {
    Scene scene = section(c);
    scene.joints = {sectionJoint("a", {-1, 2}, {9, 2}), sectionJoint("b", {-1, 2 + c.ratio}, {9, 2 + 0.5 * c.ratio})};
    return scene;
}

/// Two joints that cross at the angle `ratio` [°].
Scene crossing(const Conditions& c) {
    Scene scene = section(c);
    const double rise = 5.0 * std::tan(c.ratio * degree);
    scene.joints = {sectionJoint("a", {-1, 3}, {9, 3}), sectionJoint("b", {-1, 3 - rise}, {9, 3 + rise})};
    return scene;
}

/// `ratio` joints through one point.
Scene star(const Conditions& c) {
    Scene scene = section(c);
    const int joints = std::max(1, static_cast<int>(std::lround(c.ratio)));
    const Point center(0.5 * width, 0.5 * height);
    for (int i = 0; i < joints; ++i) {
        const double turn = 0.5 * (i + 0.25) / joints;
        scene.joints.push_back(
            sectionJoint("j" + std::to_string(i), around(center, 20.0, turn), around(center, 20.0, turn + 0.5)));
    }
    return scene;
}

/// The same joint `ratio` times.
Scene repeated(const Conditions& c) {
    Scene scene = section(c);
    const int joints = std::max(1, static_cast<int>(std::lround(c.ratio)));
    for (int i = 0; i < joints; ++i) scene.joints.push_back(sectionJoint("j" + std::to_string(i), {-1, 2}, {9, 2.5}));
    return scene;
}

/// A joint at the distance `ratio` from the crown of an opening.
Scene jointAtWall(const Conditions& c) {
    Scene scene = section(c);
    scene.tunnels = {opening({4.0, 2.0}, 2.0)};
    scene.joints = {sectionJoint("roof", {-1, 3.0 + c.ratio}, {9, 3.0 + c.ratio})};
    return scene;
}

/// An opening at the distance `ratio` from the side of the domain.
Scene openingAtEdge(const Conditions& c) {
    Scene scene = section(c);
    scene.tunnels = {opening({1.0 + c.ratio, 3.0}, 2.0)};
    return scene;
}

// --- a bar of cells

/// A block of 4 m × 1 m in cells, fixed at a frictionless end and pulled at the other.
Scene cells(const Conditions& c) {
    Scene scene = conditionedScene(c);
    scene.analysis.gravity = {0.0, 0.0};
    Block bar = boxBlock("bar", {0, 0}, {4, 1});
    bar.subBlocks = CellSettings{c.ratio};
    scene.blocks = {bar};
    Support left, low;
    left.point = Point(1e-9, 0.5);
    left.fix = Fix::XY;
    low.point = Point(4.0 - 1e-9, 0.5);
    low.fix = Fix::Y;
    scene.supports = {left, low};
    Stage stage = conditionedRest();
    for (const double side : {0.0, 4.0}) {
        Load load;
        load.along = {Point(side, 0.0), Point(side, 1.0)};
        load.pressure = -c.load * 1e6;
        stage.loads.push_back(load);
    }
    scene.stages = {stage};
    Monitor stretch;
    stretch.name = "stretch";
    stretch.between = {Point(1e-6, 0.5), Point(4.0 - 1e-6, 0.5)};
    scene.monitors = {stretch};
    return scene;
}

/// σ = p in every cell, and the bar grows by p·L/E.
void judgeCells(const Conditions& c, const Solved& solved, Findings& findings) {
    const double stress = c.load * 1e6;
    findings.holds("the bar is stable", endedWell(solved));
    double worst = 0.0;
    for (const BlockState& block : solved.results.frames.back().blocks)
        worst = std::max(worst, std::abs(block.stress[0] + block.stress[1] - stress));
    findings.near("deviation of the stress of a cell, Pa", worst, 0.0, 0.02 * std::abs(stress));
    findings.near("stretch, m", series(solved, "stretch").back(), 4.0 * stress / c.modulus,
                  (0.02 + 2.0 * std::abs(stress) / c.modulus) * 4.0 * std::abs(stress) / c.modulus);
}

// --- values that no scene may have

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double beyond = std::numeric_limits<double>::infinity();

Scene invalid(const Conditions& c) {
    Conditions usual;
    Scene scene = conditionedScene(usual);
    addBase(scene, {-2.0, -1.0}, {3.0, 0.0});
    scene.blocks.push_back(boxBlock("box", {0, 0}, {1, 1}));
    scene.stages = {conditionedRest()};
    std::vector<Point>& box = scene.blocks[1].points;
    Material& rock = scene.materials[0].second;
    switch (static_cast<int>(c.ratio)) {
        case 1: box[1].x() = notANumber; break;
        case 2: box[1].x() = beyond; break;
        case 3: rock.density = notANumber; break;
        case 4: rock.density = 0.0; break;
        case 5: rock.youngsModulus = beyond; break;
        case 6: rock.youngsModulus = -1.0; break;
        case 7: rock.poissonsRatio = 0.5; break;
        case 8: scene.analysis.gravity.y() = notANumber; break;
        case 9: box = {{0, 0}, {1, 0}, {0.5, 0}}; break;
        case 10: box = {{0, 0}, {1, 0}}; break;
        case 11: box = {{0, 0}, {1, 1}, {1, 0}, {0, 1}}; break;
        case 12: box = {{0, 0}, {1, 0}, {1, 0}, {1, 1}, {0, 1}}; break;
        case 13: scene.blocks.push_back(boxBlock("other", {0.5, 0}, {1.5, 1})); break;
        case 14: scene.analysis.tolerance = notANumber; break;
        case 15: scene.analysis.penaltyRatio = 0.0; break;
        case 16: scene.jointMaterials[0].second.frictionAngle = 90.0; break;
        case 17: scene.blocks[1].material = "missing"; break;
        case 18: scene.supports[0].blockAt = Point(100.0, 100.0); break;
        case 19: scene.stages[0].until.unbalanced = -1.0; break;
        case 20: scene.analysis.thickness = beyond; break;
        default: break;
    }
    return scene;
}

void judgeInvalid(const Conditions& c, const Solved& solved, Findings& findings) {
    findings.holds("a scene with an invalid value is refused", static_cast<int>(c.ratio) == 0 && endedWell(solved));
}

Conditions ratioOf(double ratio) {
    Conditions conditions;
    conditions.ratio = ratio;
    return conditions;
}

}  // namespace

std::vector<KnownScene> dividedScenes() {
    const SectionAxes settings{"penalty", "tolerance", "modulus",   "density", "friction",
                               "offset",  "mirror",    "thickness", "plane"};
    const auto with = [&](const char* axis) {
        SectionAxes axes{axis};
        axes.insert(axes.end(), settings.begin(), settings.end());
        return axes;
    };
    const std::string kept = "no rock is lost; stable, without tension, settled by Hooke's law";
    return {
        {"parallel-joints", "two nearly parallel joints", kept, ratioOf(1.0), with("distance"), nearlyParallel,
         judgeSection},
        {"crossing-joints", "two joints that cross at an angle", kept, ratioOf(45.0), with("sliver-angle"), crossing,
         judgeSection},
        {"star", "joints through one point", kept, ratioOf(2.0), with("number"), star, judgeSection},
        {"repeated-joint", "the same joint several times", kept, ratioOf(1.0), with("number"), repeated, judgeSection},
        {"joint-at-wall", "a joint next to the wall of an opening", kept, ratioOf(1.0), with("distance"), jointAtWall,
         judgeSection},
        {"opening-at-edge", "an opening next to the edge of the domain", kept, ratioOf(1.0), with("distance"),
         openingAtEdge, judgeSection},
        {"cells",
         "a bar of cells that is pulled",
         "stress = p in every cell; stretch = pL/E",
         ratioOf(0.5),
         {"cell-size", "pressure", "modulus", "poisson", "penalty", "tolerance", "max-passes", "offset", "mirror",
          "thickness"},
         cells,
         judgeCells},
        {"invalid",
         "a value that no scene may have",
         "it is refused",
         ratioOf(0.0),
         {"invalid"},
         invalid,
         judgeInvalid},
    };
}

}  // namespace keyblock
