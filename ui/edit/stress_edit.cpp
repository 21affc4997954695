// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/edit/stress_edit.h"

#include "geometry/polygon.h"
#include "solver/results/frame_quantities.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace keyblock {

namespace {

constexpr double usualDensity = 2700.0;  // [kg/m³]
constexpr double oneDegree = std::numbers::pi / 180.0;

/// Bounding box of the outline, or of all blocks; none without rock.
std::optional<Box> rockBox(const Scene& scene) {
    std::vector<Point> corners;
    if (scene.domain) corners = scene.domain->boundary;
    for (const Block& block : scene.blocks) corners.insert(corners.end(), block.points.begin(), block.points.end());
    return corners.empty() ? std::nullopt : std::optional(boxOf(corners));
}

double gravityOf(const Scene& scene) {
    const double down = -scene.analysis.gravity.y();
    return down > 0.0 ? down : 9.81;
}

}  // namespace

Edit withDepthStress(const Scene& scene, const DepthStress& stress) {
    const std::optional<Box> box = rockBox(scene);
    if (!box) return {scene, "The depth cannot be measured without rock. Draw the outline first."};
    if (!(stress.unitWeight > 0.0)) return {scene, "The unit weight must be above 0."};
    if (!(stress.k0 >= 0.0)) return {scene, "K0 must be 0 or more."};
    if (!(stress.surfaceY >= box->max.y() - 1e-9 * (box->max - box->min).norm()))
        return {scene, "The ground surface must not be below the upper edge of the rock."};
    Edit edit{scene};
    InSituStress& made = edit.scene.inSituStress.emplace();
    made.referenceY = 0.5 * (box->min.y() + box->max.y());
    made.syy = -stress.unitWeight * (stress.surfaceY - made.referenceY);
    made.sxx = stress.k0 * made.syy;
    made.gradientY.syy = stress.unitWeight;
    made.gradientY.sxx = stress.k0 * stress.unitWeight;
    edit.made = "/in_situ_stress";
    return edit;
}

Edit withPrincipalStresses(const Scene& scene, const PrincipalStresses& stress) {
    if (!(stress.major >= stress.minor)) return {scene, "σ1 must not be smaller than σ3."};
    Edit edit{scene};
    InSituStress& made = edit.scene.inSituStress.emplace();
    const double mean = 0.5 * (stress.major + stress.minor), radius = 0.5 * (stress.major - stress.minor);
    const double twice = 2.0 * stress.angle * oneDegree;
    made.sxx = -(mean + radius * std::cos(twice));
    made.syy = -(mean - radius * std::cos(twice));
    const double shear = -radius * std::sin(twice);
    made.sxy = std::abs(shear) > 1e-12 * std::abs(mean) ? shear : 0.0;
    edit.made = "/in_situ_stress";
    return edit;
}

DepthStress suggestedDepthStress(const Scene& scene) {
    DepthStress stress;
    if (const auto box = rockBox(scene)) stress.surfaceY = box->max.y();
    const double density = scene.materials.empty() ? usualDensity : scene.materials.front().second.density;
    stress.unitWeight = density * gravityOf(scene);
    if (!scene.inSituStress) return stress;
    const InSituStress& now = *scene.inSituStress;
    if (now.gradientY.syy > 0.0) {
        stress.unitWeight = now.gradientY.syy;
        stress.surfaceY = now.referenceY - now.syy / now.gradientY.syy;
        stress.k0 = now.gradientY.sxx / now.gradientY.syy;
    }
    return stress;
}

PrincipalStresses principalStressesOf(const Scene& scene) {
    if (!scene.inSituStress) return {};
    const PrincipalStress found =
        principalStress({scene.inSituStress->sxx, scene.inSituStress->syy, scene.inSituStress->sxy});
    double angle = std::atan2(found.direction.y(), found.direction.x()) / oneDegree;
    if (angle > 90.0) angle -= 180.0;
    if (angle <= -90.0) angle += 180.0;
    return {found.major, found.minor, angle};
}

}  // namespace keyblock
