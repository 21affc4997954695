// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Stresses around a circular opening in bonded rock, compared with Kirsch's
// solution. A user could draw the same scene: a domain under in-situ stress,
// cut by joints along rings and along the zigzags between them, all of them
// bonded so that they cannot fail, and a tunnel that a static stage excavates.
#include "solver/verify/checks.h"
#include "solver/verify/groups.h"
#include "solver/verify/readings.h"
#include "solver/verify/scenes.h"

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace keyblock {

namespace {

constexpr double pi = std::numbers::pi;
constexpr double radius = 1.0;  // [m] radius of the opening
// [m] radius of the fixed boundary, which makes the rock at the opening too stiff by about (radius/boundary)²
constexpr double boundary = 20.0;
constexpr double sideways = -2e6, upright = -1e6;  // [Pa] in-situ stress, horizontal and vertical
constexpr double openingModulus = 10e9;  // [Pa]
constexpr double unbreakable = 1e15;  // [Pa]
constexpr double nearest = 1.2, farthest = 3.0;  // [radii] range in which stresses are compared

/// A polygon with `sides` corners. \param turned rotates it by half a side.
std::vector<Point> ring(int sides, double cornerRadius, bool turned) {
    std::vector<Point> points;
    for (int i = 0; i < sides; ++i) {
        const double angle = 2.0 * pi * (i + (turned ? 0.5 : 0.0)) / sides;
        points.push_back(cornerRadius * Point(std::cos(angle), std::sin(angle)));
    }
    return points;
}

/// Corner radius of a polygon that has the same area as the circular opening. To first order in the deviation from a
/// circle, all other effects of the polygon have the period of its sides and decay as (radius/r)^sides.
double cornerOfEqualArea(int sides) { return radius / std::sqrt(sides / (2.0 * pi) * std::sin(2.0 * pi / sides)); }

/// Polygons from the opening to the boundary. Their radii increase by a constant factor, so that the triangles between
/// two polygons are nearly equilateral.
std::vector<std::vector<Point>> rings(int sides) {
    const double first = cornerOfEqualArea(sides);
    const double range = std::log(boundary / first), step = std::log(1.0 + std::sqrt(3.0) * pi / sides);
    const int count = static_cast<int>(std::lround(range / step));
    std::vector<std::vector<Point>> all;
    for (int k = 0; k <= count; ++k) all.push_back(ring(sides, first * std::exp(range * k / count), k % 2 == 1));
    return all;
}

/// The zigzag line from corner to corner between two rings, all the way round.
std::vector<Point> zigzag(const std::vector<Point>& inner, const std::vector<Point>& outer, bool innerTurned) {
    const auto &first = innerTurned ? outer : inner, &second = innerTurned ? inner : outer;
    std::vector<Point> points;
    for (std::size_t i = 0; i < first.size(); ++i) {
        points.push_back(first[i]);
        points.push_back(second[i]);
    }
    points.push_back(first[0]);
    return points;
}

void addJoint(Scene& scene, const std::vector<Point>& points) {
    SceneJoint joint;
    joint.name = "joint " + std::to_string(scene.joints.size() + 1);
    joint.points = points;
    scene.joints.push_back(joint);
}

void cutIntoTriangles(Scene& scene, const std::vector<std::vector<Point>>& rings) {
    for (std::size_t k = 0; k + 1 < rings.size(); ++k) {
        addJoint(scene, zigzag(rings[k], rings[k + 1], k % 2 == 1));
        if (k == 0) continue;  // the first ring is the outline of the opening
        std::vector<Point> closed = rings[k];
        closed.push_back(closed.front());
        addJoint(scene, closed);
    }
    scene.cutting.minArea = 0.0;  // triangles of all sizes are intended
    scene.cutting.minWidth = 0.0;
}

Scene openingScene(int sides) {
    Scene scene = emptyScene(openingModulus, 0.25, 30.0);
    scene.analysis.plane = Plane::Strain;
    scene.jointMaterials[0].second.cohesion = unbreakable;
    scene.jointMaterials[0].second.tensileStrength = unbreakable;
    const std::vector<std::vector<Point>> polygons = rings(sides);
    SceneDomain domain;
    domain.boundary = polygons.back();
    domain.material = "rock";
    domain.jointMaterial = "joint";
    scene.domain = domain;
    cutIntoTriangles(scene, polygons);
    SceneTunnel tunnel;
    tunnel.name = "opening";
    tunnel.profile = ProfileKind::Polygon;
    tunnel.points = polygons.front();
    scene.tunnels = {tunnel};
    Support held;
    held.boundary = BoundarySide::All;
    held.fix = Fix::XY;
    scene.supports = {held};
    InSituStress inSitu;
    inSitu.sxx = sideways;
    inSitu.syy = upright;
    scene.inSituStress = inSitu;
    Stage stage;
    stage.name = "excavate";
    stage.excavate = {"opening"};
    stage.increments = 1;  // nothing can fail, so one is enough
    scene.stages = {stage};
    return scene;
}

/// Hoop stress around a circular opening in an infinite plate under `sideways` and `upright` [Pa] (Kirsch 1898).
double kirschHoop(const Point& place) {
    const double q = radius * radius / place.squaredNorm(), angle = std::atan2(place.y(), place.x());
    const double mean = 0.5 * (sideways + upright), half = 0.5 * (sideways - upright);
    return mean * (1.0 + q) - half * (1.0 + 3.0 * q * q) * std::cos(2.0 * angle);
}

double hoop(const Stress& stress, const Point& place) {
    const Point r = place.normalized();
    return stress[0] * r.y() * r.y() + stress[1] * r.x() * r.x() - 2.0 * stress[2] * r.x() * r.y();
}

struct HoopError {
    int blocks = 0;  // number of blocks compared
    double norm = 0.0;  // L2 norm of the error, divided by that of Kirsch's stresses
};

HoopError hoopError(const Results& results) {
    if (results.frames.empty() || results.stages.back().outcome != Outcome::Equilibrium)
        return {0, std::nan("")};
    HoopError error;
    double difference = 0.0, whole = 0.0;
    for (const BlockState& block : results.frames.back().blocks) {
        const double r = block.centroid.norm() / radius;
        if (r < nearest || r > farthest) continue;
        const double expected = kirschHoop(block.centroid), off = hoop(block.stress, block.centroid) - expected;
        difference += block.area * off * off;
        whole += block.area * expected * expected;
        ++error.blocks;
    }
    error.norm = std::sqrt(difference / whole);
    return error;
}

/// A triangle has a single strain, which follows from the displacements of its corners. At the centroid it differs from
/// the exact strain by the second derivatives of the displacement times the size, with opposite signs in triangles that
/// point inwards and outwards. The error is therefore of first order: it halves with the size.
std::vector<CaseResult> openings() {
    Checks checks("circular opening");
    double before = 0.0;
    for (const auto& [sides, most] : {std::pair{16, 0.2}, {32, 0.1}, {64, 0.05}}) {
        const HoopError error = hoopError(solve(openingScene(sides)).results);
        const std::string where = " at the centroids of " + std::to_string(error.blocks) + " blocks";
        checks.absolute("hoop stress, L2 error" + where, error.norm, 0.0, most);
        if (before > 0.0) checks.absolute("that error relative to the previous one", error.norm / before, 0.5, 0.1);
        before = error.norm;
    }
    return checks.take();
}

}  // namespace

std::vector<Case> openingCases() {
    return {{"circular opening", "A circular opening in glued rock under a 2:1 stress, against Kirsch.", openings}};
}

}  // namespace keyblock
