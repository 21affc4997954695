// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run/stage_settings.h"

#include "solver/scene/acceleration.h"
#include "solver/scene/automatic.h"
#include "solver/scene/deciding.h"
#include "solver/scene/lookup.h"
#include "solver/scene/enum_names.h"
#include "solver/scene/preset.h"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

Inertia inertiaOf(Integration integration) {
    switch (integration) {
        case Integration::Shi: return Inertia::Shi;
        case Integration::BackwardEuler: return Inertia::BackwardEuler;
        case Integration::Newmark: return Inertia::Newmark;
        case Integration::GeneralizedAlpha: return Inertia::GeneralizedAlpha;
    }
    return Inertia::Shi;
}

}  // namespace

StaticSettings staticSettings(const Scene& scene, const Stage& stage) {
    StaticSettings settings;
    settings.unbalanced = stage.until.unbalanced.value_or(automaticUnbalanced(scene));
    settings.body = stage.until.body.value_or(automaticBody);
    settings.smallest = smallestOf(stage);
    settings.maxSteps = scene.limits.iterations.value_or(automaticIterations);
    if (stage.until.maxSteps) settings.maxSteps = std::min<long>(settings.maxSteps, *stage.until.maxSteps);
    settings.chosen = !stage.increments;
    return settings;
}

double sleepTolerance(const Scene& scene) {
    return scene.analysis.modelEverything ? 0.0 : numericsOf(scene.analysis).sleepTolerance;
}

DynamicSettings dynamicSettings(const Scene& scene, const Stage& stage) {
    DynamicSettings settings;
    settings.scheme = inertiaOf(stage.integration.value_or(scene.analysis.integration));
    settings.rhoInf = stage.rhoInf.value_or(scene.analysis.rhoInf);
    settings.damping = scene.analysis.damping;
    settings.timeStep = stage.timeStep.value_or(automaticTimeStep(scene, stage));
    return settings;
}

std::vector<BoundarySide> viscousSides(const Stage& stage) {
    std::vector<BoundarySide> sides;
    for (const std::string& name : stage.viscousBoundaries) {
        const auto word = std::find(boundarySideWords.begin(), boundarySideWords.end(), name);
        sides.push_back(static_cast<BoundarySide>(word - boundarySideWords.begin()));
    }
    return sides;
}

std::optional<double> framesEvery(const Scene& scene, const Stage& stage) {
    if (scene.output.every || !scene.output.frames) return scene.output.every;
    const double duration = stage.kind == StageKind::Static ? 1.0 : stage.duration;
    return duration * static_cast<double>(scene.stages.size()) / *scene.output.frames;
}

double frameInterval(const Scene& scene, const Stage& stage) {
    const double duration = stage.kind == StageKind::Static ? 1.0 : stage.duration;
    return framesEvery(scene, stage).value_or(duration * static_cast<double>(scene.stages.size()) / defaultFrames);
}

long plannedFrames(const Scene& scene, int stage) {
    double planned = 0.0;
    for (int s = 0; s <= stage; ++s) {
        const Stage& one = scene.stages[s];
        const bool isStatic = one.kind == StageKind::Static;
        const double frames = (isStatic ? 1.0 : one.duration) / frameInterval(scene, one);
        planned += isStatic && one.increments ? std::min<double>(frames, *one.increments) : frames;
    }
    return std::lround(planned);
}

std::vector<double> incrementTimes(const Scene& scene, const Stage& stage, const StageLoads& loads) {
    std::vector<double> times{0.0};
    if (!loads.varies() && !stage.increments) return times;
    const int count = stage.increments.value_or(1);
    for (int i = 1; i <= count; ++i) times.push_back(static_cast<double>(i) / count);
    for (double turn : loads.turns()) times.push_back(turn);
    const double every = stage.increments ? 1.0 : framesEvery(scene, stage).value_or(1.0);
    for (int i = 1; i * every < 1.0; ++i) times.push_back(i * every);
    std::sort(times.begin(), times.end());
    times.erase(std::unique(times.begin(), times.end(), [](double a, double b) { return b - a < 1e-12; }),
                times.end());
    return times;
}

void setVelocity(const Scene& scene, const Model& model, const InitialVelocity& initial, State& state) {
    const std::size_t rock = blockAt(scene, initial.blockAt);
    const int first = model.firstOf[rock], end = model.firstOf[rock + 1];
    Point middle{0.0, 0.0};  // mass times centroid, summed over the block or its cells
    double mass = 0.0;
    for (int row = first; row < end; ++row) {
        middle += model.blocks[row].mass * state.blocks[row].centroid;
        mass += model.blocks[row].mass;
    }
    for (int row = first; row < end; ++row) {
        BlockMotion& motion = state.blocks[row];
        const Point away = end - first > 1 ? Point(motion.centroid - middle / mass) : Point(0.0, 0.0);
        const Point velocity = initial.velocity + initial.spin * turnLeft(away);
        motion.velocity.setZero();
        motion.velocity[0] = velocity.dot(motion.axis);
        motion.velocity[1] = velocity.dot(turnLeft(motion.axis));
        motion.velocity[2] = initial.spin;
    }
}

}  // namespace keyblock
