// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/study/bolt_faults.h"

#include "geometry/polygon.h"
#include "geometry/random.h"
#include "geometry/segment.h"
#include "solver/scene/lookup.h"
#include "solver/scene/shapes.h"
#include "solver/study/case_plan.h"
#include "solver/study/distributions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace keyblock {

namespace {

enum Draw : std::int64_t { Occurs = 101, Share, Place, Offset, Angle };

constexpr double onWall = 1e-3;  // [m] from an outline up to which a head lies on it

const Scene& solvedScene(const SceneReading& read) { return read.cut ? read.cut->scene : *read.scene; }

/// Name of the pattern of a bolt; empty for a single bolt.
std::string patternName(const SceneReading& read, const Bolt& bolt) {
    return bolt.pattern < 0 ? std::string() : read.scene->boltPatterns[bolt.pattern].name;
}

bool isConcerned(const StudyFault& fault, const SceneReading& read, const Bolt& bolt) {
    const auto names = [&](const std::string& name) { return !name.empty() && std::ranges::count(fault.bolts, name); };
    return fault.bolts.empty() || names(bolt.name) || names(patternName(read, bolt));
}

/// Normal variable truncated at three standard deviations.
double drawnNormal(double u) {
    constexpr double beyond = 0.0013498980316300933;  // share below −3
    return normalQuantile(beyond + u * (1.0 - 2.0 * beyond));
}

/// All draws of one bolt for one fault.
class BoltDraws {
public:
    BoltDraws(const Study& study, const StudyFault& fault, const Bolt& bolt, long number)
        : seed_(study.plan.seed), fault_(streamOf(fault.name)), bolt_(streamOf(bolt.name)), number_(number) {}

    double operator()(Draw draw) const { return Random(seed_, {draw, fault_, bolt_, number_}).uniform(); }

private:
    int seed_;
    std::int64_t fault_, bolt_, number_;
};

BoltFault drawnFault(const StudyFault& fault, const Bolt& bolt, const BoltDraws& draw) {
    BoltFault drawn;
    drawn.bolt = bolt.name;
    drawn.kind = fault.kind;
    if (fault.kind == FaultKind::BondLost) {
        const double length = lengthOf(bolt);
        drawn.share = fault.share.x() + draw(Share) * (fault.share.y() - fault.share.x());
        const double lost = drawn.share * length;
        drawn.from = fault.where == BondLossPlace::FarEnd ? 0.0
                     : fault.where == BondLossPlace::Head ? length - lost
                                                          : draw(Place) * (length - lost);
        drawn.to = drawn.from + lost;
    }
    if (fault.kind == FaultKind::Misplaced) {
        drawn.offset = fault.offsetDeviation * drawnNormal(draw(Offset));
        drawn.angle = fault.angleDeviation * drawnNormal(draw(Angle));
    }
    return drawn;
}

/// Adds the parts of an anchor entry outside the interval from `low` to `high` [m].
void addBonded(std::vector<Anchor>& kept, const Anchor& anchor, double low, double high, double length) {
    if (anchor.at) {
        const double at = distanceAlong(*anchor.at, length);
        if (at < low || at > high) kept.push_back(anchor);
        return;
    }
    const double from = distanceAlong(anchor.from, length), to = distanceAlong(anchor.to, length);
    if (high <= from || low >= to) return kept.push_back(anchor);
    Anchor part = anchor;
    if (from < low) {
        part.to = {false, low};
        kept.push_back(part);
    }
    if (high < to) {
        part = anchor;
        part.from = {false, high};
        kept.push_back(part);
    }
}

void loseBond(const Scene& scene, Bolt& bolt, double low, double high) {
    const std::vector<Anchor> anchors = anchorsOf(scene, bolt);
    std::vector<Anchor> kept;
    for (const Anchor& anchor : anchors) addBonded(kept, anchor, low, high, lengthOf(bolt));
    bolt.anchors = std::move(kept);
}

/// The outline of a tunnel or block on which the head of a bolt lies; empty if there is none.
std::vector<Point> wallAt(const Scene& scene, const Point& head) {
    for (const SceneTunnel& tunnel : scene.tunnels) {
        std::vector<Point> wall = outline(tunnelProfile(shapeOf(tunnel)));
        if (distanceToBoundary(wall, head) < onWall) return wall;
    }
    for (const Block& block : scene.blocks)
        if (distanceToBoundary(block.points, head) < onWall) return block.points;
    return {};
}

/// Unit vector along the edge of an outline that is nearest to a point.
Point alongWall(const std::vector<Point>& wall, const Point& place) {
    double nearest = 1e300;
    Point along(1.0, 0.0);
    for (std::size_t i = 0; i < wall.size(); ++i) {
        const Point &a = wall[i], &b = wall[(i + 1) % wall.size()];
        const double distance = distanceToSegment(a, b, place);
        if (distance >= nearest || a == b) continue;
        nearest = distance;
        along = (b - a).normalized();
    }
    return along;
}

/// The point of a wall nearest to `head` on a line through it; `head` itself if the line does not meet the wall nearby.
Point onTheWall(const std::vector<Point>& wall, const Point& head, const Point& direction, double reach) {
    double nearest = 2.0 * reach;
    Point found = head;
    for (std::size_t i = 0; i < wall.size(); ++i) {
        const auto met = crossing(head - reach * direction, head + reach * direction, wall[i],
                                  wall[(i + 1) % wall.size()]);
        if (!met || (met->place - head).norm() >= nearest) continue;
        nearest = (met->place - head).norm();
        found = met->place;
    }
    return found;
}

void misplace(const Scene& scene, Bolt& bolt, double offset, double degrees) {
    const double length = lengthOf(bolt), angle = degrees * std::numbers::pi / 180.0;
    const Point axis = (bolt.head - bolt.farEnd).normalized(), left(-axis.y(), axis.x());
    const std::vector<Point> wall = wallAt(scene, bolt.head);
    Point along = wall.empty() ? left : alongWall(wall, bolt.head);
    if (along.dot(left) < 0.0) along = -along;
    const Point turned = std::cos(angle) * axis + std::sin(angle) * left;
    bolt.head += offset * along;
    if (!wall.empty()) bolt.head = onTheWall(wall, bolt.head, turned, 0.25 * length + std::abs(offset));
    bolt.farEnd = bolt.head - length * turned;
}

/// The document with the bolts of patterns one by one.
Scene withSingleBolts(const SceneReading& read) {
    Scene scene = *read.scene;
    if (!read.cut || scene.boltPatterns.empty()) return scene;
    scene.bolts = read.cut->scene.bolts;
    const auto expand = [&](std::vector<std::string>& names) {
        std::vector<std::string> single;
        for (const std::string& name : names) {
            const std::size_t before = single.size();
            for (const Bolt& bolt : scene.bolts)
                if (patternName(read, bolt) == name) single.push_back(bolt.name);
            if (single.size() == before) single.push_back(name);
        }
        names = std::move(single);
    };
    for (Stage& stage : scene.stages) {
        expand(stage.install);
        expand(stage.remove);
    }
    for (Bolt& bolt : scene.bolts) bolt.pattern = -1;
    scene.boltPatterns.clear();
    return scene;
}

void removeFromStart(Scene& scene, const std::string& bolt) {
    for (Stage& stage : scene.stages) {
        std::erase(stage.install, bolt);
        std::erase(stage.remove, bolt);
    }
    if (!scene.stages.empty()) scene.stages.front().remove.push_back(bolt);
}

}  // namespace

std::vector<BoltFault> faultsOf(const Study& study, long number, const SceneReading& read) {
    std::vector<BoltFault> faults;
    std::vector<std::string> missing;
    for (std::size_t f = 0; f < study.faults.size(); ++f)
        for (const Bolt& bolt : solvedScene(read).bolts) {
            const StudyFault& fault = study.faults[f];
            const BoltDraws draw(study, fault, bolt, number);
            if (!isConcerned(fault, read, bolt) || draw(Occurs) >= fault.probability) continue;
            if (fault.kind == FaultKind::Missing && std::ranges::count(missing, bolt.name)) continue;
            faults.push_back(drawnFault(fault, bolt, draw));
            faults.back().fault = static_cast<int>(f);
            if (fault.kind == FaultKind::Missing) missing.push_back(bolt.name);
        }
    return faults;
}

Scene withFaults(const SceneReading& read, const std::vector<BoltFault>& faults) {
    Scene scene = withSingleBolts(read);
    for (const BoltFault& fault : faults) {
        const auto bolt = std::ranges::find(scene.bolts, fault.bolt, &Bolt::name);
        if (bolt == scene.bolts.end()) continue;
        switch (fault.kind) {
            case FaultKind::Missing: removeFromStart(scene, fault.bolt); break;
            case FaultKind::BondLost: loseBond(scene, *bolt, fault.from, fault.to); break;
            case FaultKind::Misplaced: misplace(solvedScene(read), *bolt, fault.offset, fault.angle); break;
        }
    }
    return scene;
}

std::vector<double> faultMeasures(const Study& study, const std::vector<BoltFault>& faults, const SceneReading& read) {
    std::vector<double> measures;
    for (std::size_t f = 0; f < study.faults.size(); ++f) {
        const StudyFault& fault = study.faults[f];
        const auto concerned = std::ranges::count_if(solvedScene(read).bolts,
                                                     [&](const Bolt& bolt) { return isConcerned(fault, read, bolt); });
        double sum = 0.0;
        for (const BoltFault& one : faults) {
            if (one.fault != static_cast<int>(f)) continue;
            const double deviation = fault.offsetDeviation > 0.0 ? one.offset : one.angle;
            sum += fault.kind == FaultKind::Missing    ? 1.0
                   : fault.kind == FaultKind::BondLost ? one.share
                                                       : deviation * deviation;
        }
        const double mean = concerned > 0 ? sum / static_cast<double>(concerned) : 0.0;
        measures.push_back(fault.kind == FaultKind::Missing    ? sum
                           : fault.kind == FaultKind::BondLost ? mean
                                                               : std::sqrt(mean));
    }
    return measures;
}

}  // namespace keyblock
