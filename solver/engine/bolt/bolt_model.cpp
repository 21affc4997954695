// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/bolt/bolt_model.h"

#include "solver/engine/bolt/slots.h"
#include "solver/scene/lookup.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace keyblock {
namespace {

/// Normal spring of the shank per metre where a type gives none: a 20 mm bar grouted
/// into a 33 mm hole, 2·E_g/(D/d − 1) with E_g 8.8 GPa (theory, "The dowel") [N/m²].
constexpr double groutNormalStiffness = 27.08e9;
constexpr double coarseDivisions = 60.0;

BeamSection sectionOf(const BoltType& type) {
    const double d = type.diameter;
    const double full = std::numbers::pi * d * d / 4.0;
    BeamSection section;
    section.area = type.area.value_or(full);
    const double inner2 = std::max(0.0, d * d - 4.0 * section.area / std::numbers::pi);
    section.secondMoment = type.secondMoment.value_or(std::numbers::pi / 64.0 * (d * d * d * d - inner2 * inner2));
    section.youngsModulus = type.steel.empty() ? type.youngsModulus.value_or(200e9)
                                               : Backbone::of(type.steel).modulus;
    section.shearModulus = type.shearModulus;
    section.shearCoefficient = type.shearCoefficient;
    section.density = type.density;
    return section;
}

/// N_p = A × the tensile strength [N]; 0 for steel without limit.
double tensileStrengthOf(const BoltType& type, double area) {
    double stress = 0.0;
    for (const auto& [strain, value] : type.steel) stress = std::max(stress, value);
    return type.steel.empty() ? 0.0 : type.tensileStrength.value_or(stress) * area;
}

/// Of a tube (d³ − d_i³)/6, d_i² = d² − 4A/π; of a full bar d³/6 [m³].
double plasticModulusOf(const BoltType& type, double area) {
    const double d = type.diameter, inner = std::sqrt(std::max(0.0, d * d - 4.0 * area / std::numbers::pi));
    return type.plasticModulus.value_or((d * d * d - inner * inner * inner) / 6.0);
}

void setSteel(const BoltType& type, BoltModel& bolt) {
    bolt.diameter = type.diameter;
    bolt.dynamicFactor = type.dynamicFactor;
    bolt.bends = type.bending != Bending::None;
    bolt.plasticModulus = plasticModulusOf(type, bolt.section.area);
    bolt.tensileStrength = tensileStrengthOf(type, bolt.section.area);
    bolt.shearStrength = type.shearStrengthRatio * bolt.tensileStrength;
    if (type.steel.empty()) return;
    bolt.steel = Backbone::of(type.steel);
    if (type.dynamicFactor != 1.0) bolt.dynamicSteel = bolt.steel->strengthened(type.dynamicFactor);
    bolt.hinges = type.bending == Bending::ElasticPlastic;
    bolt.interacts = type.ruptureRule == RuptureRule::Interaction;
}

double placeOf(const BoltPlace& place, double length) { return place.head ? length : place.s; }

AnchorModel anchorModel(const Anchor& anchor, double dynamicFactor) {
    AnchorModel model;
    model.real = true;
    model.law = anchor.law;
    model.per = anchor.at ? Per::Node : anchor.per;
    model.stiffness = anchor.stiffness;
    model.strength = anchor.strength;
    model.residual = anchor.law == AnchorLaw::Frictional ? anchor.strength.value_or(0.0) : anchor.residual;
    model.tanPhi = std::tan(anchor.frictionAngle * std::numbers::pi / 180.0);
    model.restick = anchor.restick;
    model.boltLost = anchor.onFailure == OnFailure::BoltLost;
    model.curveEnds = anchor.law == AnchorLaw::Curve && anchor.after == AfterCurve::Zero;
    if (anchor.law == AnchorLaw::Curve) model.curve = Backbone::of(anchor.curve);
    if (model.curve && dynamicFactor != 1.0) model.dynamicCurve = model.curve->strengthened(dynamicFactor);
    return model;
}

int nearestNode(const std::vector<double>& nodes, double s) {
    int best = 0;
    for (int i = 1; i < static_cast<int>(nodes.size()); ++i)
        if (std::abs(nodes[i] - s) < std::abs(nodes[best] - s) * (1.0 - 1e-12)) best = i;
    return best;
}

/// What is left of intervals once another is taken out of it.
std::vector<Interval> without(const std::vector<Interval>& intervals, const Interval& taken) {
    std::vector<Interval> left;
    for (const auto& [from, to] : intervals) {
        if (std::min(to, taken.first) > from) left.emplace_back(from, std::min(to, taken.first));
        if (to > std::max(from, taken.second)) left.emplace_back(std::max(from, taken.second), to);
    }
    return left;
}

/// Intervals of the bolt that each entry holds: later entries take theirs from earlier ones.
std::vector<std::vector<Interval>> intervalsOf(const std::vector<Anchor>& entries, double length) {
    std::vector<std::vector<Interval>> intervals;
    for (const Anchor& entry : entries) {
        const Interval own{placeOf(entry.from, length), placeOf(entry.to, length)};
        if (!entry.at)
            for (std::vector<Interval>& earlier : intervals) earlier = without(earlier, own);
        intervals.push_back({own});
    }
    return intervals;
}

/// Later entries override earlier ones on the nodes they share.
std::vector<AnchorModel> anchorsOfNodes(const std::vector<Anchor>& entries, const std::vector<double>& nodes,
                                        double length, double tolerance, double dynamicFactor) {
    std::vector<AnchorModel> anchors(nodes.size());
    for (std::size_t e = 0; e < entries.size(); ++e) {
        const Anchor& entry = entries[e];
        AnchorModel model = anchorModel(entry, dynamicFactor);
        model.entry = static_cast<int>(e);
        const double from = placeOf(entry.from, length), to = placeOf(entry.to, length);
        bool any = false;
        for (std::size_t i = 0; i < nodes.size() && !entry.at; ++i) {
            if (nodes[i] < from - tolerance || nodes[i] > to + tolerance) continue;
            anchors[i] = model;
            any = true;
        }
        const double middle = entry.at ? placeOf(*entry.at, length) : 0.5 * (from + to);
        if (!any) anchors[static_cast<std::size_t>(nearestNode(nodes, middle))] = model;
    }
    return anchors;
}

void setSprings(const Plate& type, PlateModel& plate) {
    plate.present = true;
    plate.normalStiffness = type.normalStiffness;
    plate.shearStiffness = type.shearStiffness;
    plate.normalStrength = type.normalStrength;
    plate.shearStrength = type.shearStrength;
}

/// Ties the head to its place on the plate that is a block, square to the face that it lies against.
PlateModel blockPlate(const Model& model, const BoltModel& bolt, int index, const BoltType& type) {
    PlateModel plate;
    for (plate.block = model.firstOf.back(); model.blocks[plate.block].plateOf != index;) ++plate.block;
    const BlockModel& body = model.blocks[plate.block];
    plate.place = bolt.farEnd + bolt.s.back() * bolt.axis - body.centroid;
    plate.along = turnLeft((body.shape[1] - body.shape[0]).normalized());
    setSprings(type.plate, plate);
    return plate;
}

PlateModel plateModel(const Model& model, const BoltModel& bolt, const BoltType& type) {
    PlateModel plate;
    const double length = bolt.s.back();
    const double reach = bolt.elements.back().length + model.tolerance;
    double nearest = std::numeric_limits<double>::max();
    for (const Slot& slot : bolt.slots) {
        const double away = std::max(0.0, length - slot.s3);
        if (away > reach || away >= nearest) continue;
        nearest = away;
        plate.block = slot.block;
    }
    if (plate.block < 0) return plate;
    plate.place = bolt.farEnd + length * bolt.axis - model.blocks[static_cast<std::size_t>(plate.block)].centroid;
    plate.along = bolt.axis;
    setSprings(type.plate, plate);
    return plate;
}

void setNormalSprings(BoltModel& bolt, const BoltType& type, bool automatic) {
    bolt.normalStiffness = type.normalStiffness.value_or(groutNormalStiffness);
    bolt.normalPer = type.normalStiffness ? type.normalPer : Per::Length;
    if (automatic && bolt.normalPer == Per::Node) {
        bolt.normalStiffness *= coarseDivisions / bolt.s.back();
        bolt.normalPer = Per::Length;
    }
}

/// Length over which a dowel in these springs bends: 1/β, β = (K/4EI)^¼ [m].
double dowelLengthOf(const BoltType& type, const BeamSection& section, double length) {
    double k = type.normalStiffness.value_or(groutNormalStiffness);
    if (type.normalStiffness && type.normalPer == Per::Node) k *= coarseDivisions / length;
    return std::pow(4.0 * section.youngsModulus * section.secondMoment / k, 0.25);
}

/// Adds nodes up to `to`, in equal elements no longer than `longest`; nothing where `to` is the last node but for
/// round-off.
void fill(std::vector<double>& nodes, double to, double longest) {
    const double from = nodes.back();
    if (to - from <= 1e-9 * longest) return;
    const int count = std::max(1, static_cast<int>(std::ceil((to - from) / longest - 1e-9)));
    for (int i = 1; i <= count; ++i) nodes.push_back(from + (to - from) * i / count);
}

/// Half the element around a joint: no longer than `longest`, clear of the other joints and within the bolt [m].
double halfElement(const std::vector<double>& joints, std::size_t joint, double length, double longest) {
    double room = std::min({longest, 2.0 * joints[joint], 2.0 * (length - joints[joint])});
    if (joint > 0) room = std::min(room, joints[joint] - joints[joint - 1]);
    if (joint + 1 < joints.size()) room = std::min(room, joints[joint + 1] - joints[joint]);
    return 0.5 * room;
}

}  // namespace

BoltModel boltModel(const Scene& scene, int index, const Model& model) {
    const Bolt& bolt = scene.bolts[static_cast<std::size_t>(index)];
    const BoltType& type = boltTypeOf(scene, bolt);
    BoltModel b;
    b.name = bolt.name;
    b.farEnd = bolt.farEnd - model.origin;
    const Point head = bolt.head - model.origin;
    const double length = (head - b.farEnd).norm();
    b.axis = (head - b.farEnd) / length;
    b.angle = std::atan2(b.axis.y(), b.axis.x());
    b.share = model.thickness / bolt.spacingOutOfPlane.value_or(model.thickness);
    b.section = sectionOf(type);
    setSteel(type, b);
    b.pretension = bolt.pretension;
    b.slots = slotsAlong(model, b.farEnd, head);
    b.joints = jointPlaces(model, b.slots, length);
    b.dowelLength = dowelLengthOf(type, b.section, length);
    b.s = boltNodes(length, bolt.divisions, b.joints, b.dowelLength);
    for (std::size_t i = 0; i + 1 < b.s.size(); ++i) {
        const bool shears = std::any_of(b.joints.begin(), b.joints.end(), [&](double s) {
            return s >= b.s[i] - model.tolerance && s <= b.s[i + 1] + model.tolerance;
        });
        b.elements.push_back({b.s[i + 1] - b.s[i], shears});
    }
    for (double s : b.s) b.startBlock.push_back(startBlockOf(model, b.slots, s));
    b.anchors = anchorsOfNodes(anchorsOf(scene, bolt), b.s, length, model.tolerance, type.dynamicFactor);
    b.intervals = intervalsOf(anchorsOf(scene, bolt), length);
    setNormalSprings(b, type, !bolt.divisions);
    if (bolt.plate == PlateKind::Spring) b.plate = plateModel(model, b, type);
    if (bolt.plate == PlateKind::Block) b.plate = blockPlate(model, b, index, type);
    b.firstNode = model.nodes;
    return b;
}

std::vector<double> boltNodes(double length, std::optional<int> divisions, const std::vector<double>& joints,
                              double dowel) {
    std::vector<double> nodes{0.0};
    if (divisions) {
        fill(nodes, length, length / *divisions * (1.0 + 1e-9));
        return nodes;
    }
    const double coarse = length / coarseDivisions;
    const double fine = std::min(coarse, dowel / 8.0);
    const double zone = 3.0 * dowel;
    double fineUntil = -1.0;  // how far the zone of the last joint reaches
    for (std::size_t i = 0; i < joints.size(); ++i) {
        const double half = halfElement(joints, i, length, fine);
        const double first = joints[i] - half;
        fill(nodes, std::min(fineUntil, first), fine);
        fill(nodes, std::min(std::max(nodes.back(), joints[i] - zone), first), coarse);
        fill(nodes, first, fine);
        nodes.push_back(joints[i] + half);
        fineUntil = std::min(joints[i] + zone, length);
    }
    fill(nodes, fineUntil, fine);
    fill(nodes, length, coarse);
    nodes.back() = length;
    return nodes;
}

}  // namespace keyblock
