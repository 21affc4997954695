// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/trade/stress.h"

#include "solver/results/result_names.h"
#include "solver/scene/automatic.h"
#include "solver/scene/check.h"
#include "solver/scene/number_text.h"
#include "solver/scene/preset.h"
#include "solver/trade/change_text.h"
#include "solver/trade/trade_errors.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace keyblock {

namespace {

constexpr double leastChange = 1e-9;  // in the SI unit of a quantity; smaller changes do not count
constexpr double mostTimes = 20.0, mostAdded = 20.0;  // limit of the time of a run: times the scene's own, plus [s]

bool hasKind(const Scene& scene, StageKind kind) {
    return std::any_of(scene.stages.begin(), scene.stages.end(),
                       [&](const Stage& stage) { return stage.kind == kind; });
}

std::string factorText(double factor) { return factor >= 1.0 ? "× " + rounded(factor) : "÷ " + rounded(1.0 / factor); }

StressPush pushed(const std::string& axis, double factor, bool physical, const std::string& remedy,
                  std::function<void(Scene&)> apply) {
    return {axis, factorText(factor), std::abs(std::log10(factor)), physical, remedy, std::move(apply)};
}

void addTimeSteps(std::vector<StressPush>& pushes) {
    for (const double factor : {0.1, 10.0})
        pushes.push_back(
            pushed("time step", factor, false,
                   "give a 'time_step' of a tenth to a third of the present one, until the answer does not change",
                   [factor](Scene& scene) {
                       for (Stage& stage : scene.stages)
                           if (stage.kind == StageKind::Dynamic)
                               stage.timeStep = factor * stage.timeStep.value_or(automaticTimeStep(scene, stage));
                   }));
}

void addPenalties(const Scene& scene, std::vector<StressPush>& pushes) {
    for (const double factor : {0.1, 0.01, 10.0, 100.0}) {
        const double value = factor * numericsOf(scene.analysis).penaltyRatio;
        pushes.push_back(pushed("penalty ratio", factor, false,
                                "give joint materials a 'normal_stiffness', or \"contact\": \"augmented-lagrangian\"",
                                [value](Scene& changed) { changed.analysis.penaltyRatio = value; }));
    }
}

void addTolerances(const Scene& scene, std::vector<StressPush>& pushes) {
    for (const double factor : {0.01, 0.1, 10.0, 100.0}) {
        const double value = factor * numericsOf(scene.analysis).tolerance;
        if (value > 0.1) continue;
        pushes.push_back(pushed("tolerance", factor, false, "give a 'tolerance' ten times smaller",
                                [value](Scene& changed) { changed.analysis.tolerance = value; }));
    }
}

/// The stiffest material is made stiffer and the softest softer; a single material both.
void addContrasts(const Scene& scene, std::vector<StressPush>& pushes) {
    if (scene.materials.empty()) return;
    const auto [soft, stiff] = std::minmax_element(
        scene.materials.begin(), scene.materials.end(),
        [](const auto& a, const auto& b) { return a.second.youngsModulus < b.second.youngsModulus; });
    const std::size_t softest = soft - scene.materials.begin(), stiffest = stiff - scene.materials.begin();
    for (const double factor : {0.01, 0.1, 10.0, 100.0, 1e4}) {
        const std::size_t material = factor < 1.0 ? softest : stiffest;
        StressPush push = pushed(
            "stiffness", factor, true, "check 'youngs_modulus' of the material",
            [factor, material](Scene& changed) { changed.materials[material].second.youngsModulus *= factor; });
        push.text += " of " + scene.materials[material].first;
        pushes.push_back(std::move(push));
    }
}

void multiplyLoads(Scene& scene, double factor) {
    bool any = false;
    for (Stage& stage : scene.stages) {
        for (Load& load : stage.loads) {
            load.force *= factor;
            load.pressure *= factor;
            any = true;
        }
        for (Motion& motion : stage.motions) {
            for (auto& [time, displacement] : motion.table) displacement *= factor;
            any = true;
        }
        if (stage.baseAcceleration) stage.baseAcceleration->factor *= factor, any = true;
        if (stage.bodyAcceleration) stage.bodyAcceleration->factor *= factor, any = true;
        for (InitialVelocity& initial : stage.initialVelocities) {
            initial.velocity *= factor;
            initial.spin *= factor;
            any = true;
        }
    }
    if (!any) scene.analysis.gravity *= factor;
}

void addLoads(std::vector<StressPush>& pushes) {
    for (const double factor : {2.0, 10.0})
        pushes.push_back(pushed("load", factor, true,
                                "the scene has no reserve for this load: add support, or check the load",
                                [factor](Scene& scene) { multiplyLoads(scene, factor); }));
}

void addOffsets(std::vector<StressPush>& pushes) {
    for (const double offset : {1e4, 1e6, 1e8}) {
        StressPush push{"coordinates",
                        "+ " + rounded(offset) + " m",
                        std::log10(offset),
                        false,
                        "use local coordinates with an origin near the section",
                        [offset](Scene& scene) {
                            scene = movedBy(std::move(scene), {offset, offset});
                        }};
        pushes.push_back(std::move(push));
    }
}

struct LargestChange {
    double change = 0.0;
    std::string quantity;
};

LargestChange changeOf(const TradePoint& point, const TradePoint& own, const std::vector<std::string>& quantities) {
    LargestChange largest;
    for (std::size_t q = 0; q < quantities.size(); ++q) {
        const auto &here = point.values[q].value, &there = own.values[q].value;
        if (quantities[q] == "energy_error" || quantities[q].starts_with("order ")) continue;
        if (here && there && std::abs(*here - *there) < leastChange) continue;
        const double change = errorOf(point, own, quantities, q).value_or(std::numeric_limits<double>::infinity());
        if (change > largest.change) largest = {change, quantities[q]};
    }
    return largest;
}

/// 1 or 0 where the scene is stable or not; none where that is not known.
std::optional<double> verdictOfPoint(const TradePoint& point, const std::vector<std::string>& quantities) {
    const auto at = std::find(quantities.begin(), quantities.end(), "stands");
    return at == quantities.end() ? std::nullopt : point.values[at - quantities.begin()].value;
}

class Pushing {
public:
    Pushing(const Scene& scene, const StressSettings& settings, StressTest& stress)
        : scene_(scene), settings_(settings), stress_(stress), pushes_(stressPushes(scene)) {}

    bool all() {
        stress_.quantities = scene_.quantities;
        std::optional<TradePoint> own = measured(scene_, "scene as given");
        if (!own) return false;
        stress_.own = std::move(*own);
        warnings_ = warningsOf(scene_);
        if (!stress_.own.failure.empty()) return true;
        return std::all_of(pushes_.begin(), pushes_.end(), [&](const StressPush& push) { return add(push); });
    }

private:
    static std::vector<std::string> warningsOf(const Scene& scene) {
        std::vector<std::string> texts;
        for (const Problem& problem : checkScene(scene))
            if (problem.severity == Severity::Warning) texts.push_back(problem.pointer + ": " + problem.message);
        return texts;
    }

    std::optional<TradePoint> measured(const Scene& scene, const std::string& what) {
        const std::string label = "run " + std::to_string(++done_) + " of " + std::to_string(pushes_.size() + 1) +
                                  ", " + what;
        TradeSetting setting{"stress", what, {}, [](Scene&) {}};
        return measurePoint(scene, setting, stress_.quantities,
                            [&](const Scene& changed, const SceneCut& cut, int, Sink& sink) {
                                settings_.run(changed, cut, label, sink);
                            });
    }

    bool add(const StressPush& push) {
        Scene changed = scene_;
        push.apply(changed);
        StressPoint point{push, StressEnding::Same, 0.0, {}, {}, {}};
        for (const Problem& problem : checkScene(changed)) {
            if (problem.severity == Severity::Error && point.reason.empty()) {
                point.ending = StressEnding::Refused;
                point.reason = problem.pointer + ": " + problem.message;
            }
            const std::string text = problem.pointer + ": " + problem.message;
            if (problem.severity == Severity::Warning && !std::count(warnings_.begin(), warnings_.end(), text))
                point.warnings.push_back(text);
        }
        if (point.ending != StressEnding::Refused) {
            const double limit = mostTimes * stress_.own.seconds + mostAdded;
            changed.limits.wallTime = std::min(limit, changed.limits.wallTime.value_or(limit));
            std::optional<TradePoint> run = measured(changed, push.axis + " " + push.text);
            if (!run) return false;
            judge(*run, point);
        }
        if (settings_.measured) settings_.measured(point);
        stress_.points.push_back(std::move(point));
        return true;
    }

    void judge(const TradePoint& run, StressPoint& point) const {
        point.seconds = run.seconds;
        if (!run.failure.empty()) {
            point.ending = StressEnding::Stopped;
            point.reason = run.failure;
            return;
        }
        const LargestChange change = changeOf(run, stress_.own, stress_.quantities);
        point.moved = change.change;
        point.quantity = change.quantity;
        if (verdictOfPoint(run, stress_.quantities) != verdictOfPoint(stress_.own, stress_.quantities))
            point.ending = StressEnding::Verdict;
        else if (point.moved > stressMoved) point.ending = StressEnding::Moved;
    }

    const Scene& scene_;
    const StressSettings& settings_;
    StressTest& stress_;
    std::vector<StressPush> pushes_;
    std::vector<std::string> warnings_;
    std::size_t done_ = 0;
};

bool breaks(const StressPoint& point) {
    return point.push.physical ? point.ending == StressEnding::Refused || point.ending == StressEnding::Stopped ||
                                     point.ending == StressEnding::Verdict
                               : point.ending != StressEnding::Same;
}

std::string movedText(const StressPoint& point) {
    if (!std::isfinite(point.moved)) return "'" + point.quantity + "' no longer has the same kind of value";
    return "'" + point.quantity + "' changes by " + changeText(point.moved);
}

std::string endingText(const StressPoint& point) {
    switch (point.ending) {
        case StressEnding::Same: return point.quantity.empty() ? "no quantity changes" : movedText(point);
        case StressEnding::Moved: return movedText(point);
        case StressEnding::Refused: return "the scene is refused: " + point.reason;
        case StressEnding::Stopped: return point.reason;
        case StressEnding::Verdict: return "the verdict on stability changes, and " + movedText(point);
    }
    return {};
}

}  // namespace

std::string_view wordOf(StressEnding ending) {
    constexpr std::array<std::string_view, 5> words{"same", "moved", "refused", "stopped", "verdict"};
    return words[static_cast<std::size_t>(ending)];
}

std::vector<StressPush> stressPushes(const Scene& scene) {
    std::vector<StressPush> pushes;
    if (hasKind(scene, StageKind::Dynamic)) addTimeSteps(pushes);
    addPenalties(scene, pushes);
    addTolerances(scene, pushes);
    addOffsets(pushes);
    addContrasts(scene, pushes);
    addLoads(pushes);
    return pushes;
}

Scene movedBy(Scene scene, const Point& offset) {
    const auto move = [&](Point& p) { p += offset; };
    const auto moveAll = [&](std::vector<Point>& points) { std::for_each(points.begin(), points.end(), move); };
    const auto moveIf = [&](std::optional<Point>& p) {
        if (p) move(*p);
    };
    if (scene.domain) moveAll(scene.domain->boundary);
    for (SceneJoint& joint : scene.joints) moveAll(joint.points);
    for (SceneJointSet& set : scene.jointSets) move(set.origin);
    for (SceneRegion& region : scene.regions) moveAll(region.points);
    for (SceneTunnel& tunnel : scene.tunnels) {
        move(tunnel.center);
        moveAll(tunnel.points);
    }
    for (Block& block : scene.blocks) moveAll(block.points);
    for (Support& support : scene.supports) {
        moveIf(support.blockAt);
        moveIf(support.point);
    }
    if (scene.inSituStress) scene.inSituStress->referenceY += offset.y();
    for (Bolt& bolt : scene.bolts) {
        move(bolt.farEnd);
        move(bolt.head);
    }
    for (ScenePattern& pattern : scene.boltPatterns) {
        move(pattern.from);
        move(pattern.to);
    }
    for (Monitor& monitor : scene.monitors) {
        moveIf(monitor.point);
        if (monitor.between) std::for_each(monitor.between->begin(), monitor.between->end(), move);
    }
    for (Stage& stage : scene.stages) {
        for (Motion& motion : stage.motions) move(motion.blockAt);
        for (Load& load : stage.loads) {
            moveIf(load.blockAt);
            moveIf(load.at);
            moveIf(load.point);
            if (load.along) std::for_each(load.along->begin(), load.along->end(), move);
        }
        for (InitialVelocity& initial : stage.initialVelocities) move(initial.blockAt);
    }
    return scene;
}

bool measureStress(const Scene& scene, const StressSettings& settings, StressTest& stress) {
    stress.interrupted = !Pushing(scene, settings, stress).all();
    return !stress.interrupted;
}

int firstToBreak(const StressTest& stress) {
    int first = -1;
    const auto size = [](const StressPoint& point) {
        // moves of coordinates start at kilometres, and a physical push only counts if no numerical one breaks
        return point.push.decades - (point.push.axis == "coordinates" ? 3.0 : 0.0) +
               (point.push.physical ? 100.0 : 0.0);
    };
    for (std::size_t i = 0; i < stress.points.size(); ++i)
        if (breaks(stress.points[i]) && (first < 0 || size(stress.points[i]) < size(stress.points[first])))
            first = static_cast<int>(i);
    return first;
}

std::string stressAnswer(const StressTest& stress) {
    const int first = firstToBreak(stress);
    if (first < 0)
        return "Nothing breaks: no numerical setting moves a quantity by more than " + changeText(stressMoved) +
               ", and the scene bears every push.\n";
    const StressPoint& point = stress.points[first];
    std::string text = "Breaks first: " + point.push.axis + " " + point.push.text + "; " + endingText(point) + ".\n";
    text += "What to set: " + point.push.remedy + ".\n";
    if (point.push.physical)
        text += "No numerical setting moves a quantity by more than " + changeText(stressMoved) + ".\n";
    return text;
}

}  // namespace keyblock
