// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/bolt/bolt_model.h"

#include "solver/engine/bolt/acts_across.h"
#include "solver/engine/bolt/bolt_mesh.h"
#include "solver/engine/bolt/slots.h"
#include "solver/scene/anchor_curve.h"
#include "solver/scene/automatic.h"
#include "solver/scene/bond_per_node.h"
#include "solver/scene/bolt_steel.h"
#include "solver/scene/lookup.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numbers>

namespace keyblock {
namespace {

/// Normal stiffness of the shank per metre if the bolt type gives none: a 20 mm bar grouted into a 33 mm hole,
/// 2·E_g/(D/d − 1) with E_g = 8.8 GPa (theory, "The dowel") [N/m²].
constexpr double groutNormalStiffness = 27.08e9;
constexpr double bondedDivisions = 60.0;  // minimum for an automatic mesh; values per node refer to this number
constexpr double freeDivisions = 20.0;  // the same for a bolt that is anchored at single points only
constexpr double transferShare = 0.25;  // element length over transfer length: a pull opens a joint 0.8 % too far
constexpr double elementsBetweenJoints = 12.0;  // used if joints are closer than the transfer length
constexpr double softeningShare = 0.15;  // transferShare of a softening bond: its peak is reached 8 % too late

BeamSection sectionOf(const BoltType& type) {
    BeamSection section;
    section.area = boltSteel(type).area;
    section.secondMoment = type.secondMoment.value_or(automaticSecondMoment(type));
    const bool isLinear = type.steel.empty();  // otherwise the modulus follows from the curve
    section.youngsModulus = isLinear && type.youngsModulus ? *type.youngsModulus : automaticYoungsModulus(type);
    section.shearModulus = type.shearModulus;
    section.shearCoefficient = type.shearCoefficient;
    section.density = type.density;
    return section;
}

void setSteel(const BoltType& type, BoltModel& bolt) {
    bolt.diameter = type.diameter;
    bolt.bends = type.bending != Bending::None;
    bolt.plasticModulus = type.plasticModulus.value_or(automaticPlasticModulus(type));
    bolt.tensileStrength = boltSteel(type).tensile.value_or(0.0);
    bolt.shearStrength = type.shearStrengthRatio * bolt.tensileStrength;
    if (type.steel.empty()) return;
    bolt.steel = Backbone::of(type.steel);
    if (const double factor = bolt.dynamicFactors.steel; factor != 1.0)
        bolt.dynamicSteel = bolt.steel->strengthened(factor);
    bolt.hinges = type.bending == Bending::ElasticPlastic;
    bolt.interacts = type.ruptureRule == RuptureRule::Interaction;
}

double placeOf(const BoltPlace& place, double length) { return place.head ? length : place.s; }

Anchor strengthened(Anchor anchor, double factor) {
    *anchor.strength *= factor;
    anchor.residual *= factor;
    return anchor;
}

AnchorModel anchorModel(const Anchor& written, double dynamicFactor) {
    const Anchor anchor = withCurve(written);
    const bool isMade = anchor.law != written.law;  // a generated curve is scaled by the strength only
    AnchorModel model;
    model.real = true;
    model.canFail = canFail(rowOf(anchor.law));
    model.per = anchor.at ? Per::Node : anchor.per;
    model.stiffness = anchor.stiffness;
    model.strength = anchor.strength;
    model.residual = rowOf(anchor.law).keepsStrength ? anchor.strength.value_or(0.0) : anchor.residual;
    model.tanPhi = std::tan(anchor.frictionAngle * std::numbers::pi / 180.0);
    model.restick = anchor.restick;
    model.boltLost = anchor.onFailure == OnFailure::BoltLost;
    model.curveEnds = rowOf(anchor.law).hasPoints && anchor.after == AfterCurve::Zero;
    if (rowOf(anchor.law).hasPoints) model.curve = Backbone::of(anchor.curve);
    if (model.curve && dynamicFactor != 1.0)
        model.dynamicCurve = isMade ? Backbone::of(withCurve(strengthened(written, dynamicFactor)).curve)
                                    : model.curve->strengthened(dynamicFactor);
    return model;
}

int nearestNode(const std::vector<double>& nodes, double s) {
    int best = 0;
    for (int i = 1; i < static_cast<int>(nodes.size()); ++i)
        if (std::abs(nodes[i] - s) < std::abs(nodes[best] - s) * (1.0 - 1e-12)) best = i;
    return best;
}

/// The parts of the intervals that remain when another interval is removed from them.
std::vector<Interval> without(const std::vector<Interval>& intervals, const Interval& taken) {
    std::vector<Interval> left;
    for (const auto& [from, to] : intervals) {
        if (std::min(to, taken.first) > from) left.emplace_back(from, std::min(to, taken.first));
        if (to > std::max(from, taken.second)) left.emplace_back(std::max(from, taken.second), to);
    }
    return left;
}

/// Intervals of the bolt to which each entry applies; later entries override earlier ones.
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
        if (!any) anchors[nearestNode(nodes, middle)] = model;
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

/// Ties the head to a plate that is modelled as a block, normal to the face against which the plate lies.
PlateModel blockPlate(const Model& model, const BoltModel& bolt, int index, const BoltType& type) {
    PlateModel plate;
    for (plate.block = model.firstOf.back(); model.blocks[plate.block].plateOf != index;) ++plate.block;
    const BlockModel& body = model.blocks[plate.block];
    plate.place = bolt.farEnd + bolt.s.back() * bolt.axis - body.centroid;
    plate.along = turnLeft((body.shape[1] - body.shape[0]).normalized());
    setSprings(type.plate, plate);
    return plate;
}

/// \param divisions number of elements of the bolt, which defines how close to rock the head must be; null: automatic.
PlateModel plateModel(const Model& model, const BoltModel& bolt, const BoltType& type, std::optional<int> divisions) {
    PlateModel plate;
    const double length = bolt.s.back();
    const double reach = length / divisions.value_or(static_cast<int>(bondedDivisions)) + model.tolerance;
    double nearest = std::numeric_limits<double>::max();
    for (const Slot& slot : bolt.slots) {
        const double away = std::max(0.0, length - slot.s3);
        if (away > reach || away >= nearest) continue;
        nearest = away;
        plate.block = slot.block;
    }
    if (plate.block < 0) return plate;
    plate.place = bolt.farEnd + length * bolt.axis - model.blocks[plate.block].centroid;
    plate.along = bolt.axis;
    setSprings(type.plate, plate);
    return plate;
}

void setNormalSprings(BoltModel& bolt, const BoltType& type, bool automatic) {
    bolt.normalStiffness = type.normalStiffness.value_or(groutNormalStiffness);
    bolt.normalPer = type.normalStiffness ? type.normalPer : Per::Length;
    if (automatic && bolt.normalPer == Per::Node) {
        bolt.normalStiffness *= bondedDivisions / bolt.s.back();
        bolt.normalPer = Per::Length;
    }
}

/// Length over which a dowel on these springs bends: 1/β, β = (K/4EI)^¼ [m].
double dowelLengthOf(const BoltType& type, const BeamSection& section, double length) {
    double k = type.normalStiffness.value_or(groutNormalStiffness);
    if (type.normalStiffness && type.normalPer == Per::Node) k *= bondedDivisions / length;
    return std::pow(4.0 * section.youngsModulus * section.secondMoment / k, 0.25);
}

/// Properties of a bond that determine the mesh, per metre of bolt.
struct Bond {
    double stiffness = 0.0, peak = 0.0, residual = 0.0;  // [N/m², N/m, N/m]; peak 0: unlimited strength
    double softeningSlip = 0.0;  // [m]
};

Bond bondOf(const Anchor& anchor) {
    if (!rowOf(anchor.law).hasPoints) {
        const double peak = anchor.strength.value_or(0.0);
        const double residual = rowOf(anchor.law).keepsStrength ? peak : anchor.residual;
        return {anchor.stiffness, peak, residual, anchor.softeningSlip};
    }
    Bond bond;
    bond.stiffness = anchor.curve[1].second / anchor.curve[1].first;
    bond.residual = anchor.after == AfterCurve::Last ? anchor.curve.back().second : 0.0;
    for (const auto& [slip, force] : anchor.curve) {
        bond.peak = std::max(bond.peak, force);
        if (force == bond.peak) bond.softeningSlip = anchor.curve.back().first - slip;
    }
    return bond;
}

/// Greatest distance from a point of load transfer to which the bond is loaded [m]: three transfer lengths, the length
/// over which the bond softens, and the length over which it debonds before the steel reaches its strength. The
/// debonding front carries about √(2·EA·G), where G is the work under the bond's curve per metre of bolt.
double reachOf(const Bond& bond, double transfer, double axialStiffness, double steelStrength, double length) {
    if (bond.peak <= 0.0) return 3.0 * transfer;
    const double softened = (bond.peak - bond.residual) * bond.softeningSlip;
    const double front = std::sqrt(axialStiffness * (bond.peak * bond.peak / bond.stiffness + softened));
    const double soft = bond.softeningSlip > 0.0 ? front / (0.5 * (bond.peak + bond.residual)) : 0.0;
    const double left = steelStrength > 0.0 ? std::max(0.0, steelStrength - front) : axialStiffness;
    const double gone = left > 0.0 ? left / std::max(bond.residual, left / length) : 0.0;
    return 3.0 * transfer + soft + gone;
}

/// Distance from a joint to the nearest other joint or end of the bolt [m].
double spacingAt(const MeshRequest& request, std::size_t joint) {
    const double s = request.joints[joint];
    double spacing = std::min(s, request.length - s);
    if (joint > 0) spacing = std::min(spacing, s - request.joints[joint - 1]);
    if (joint + 1 < request.joints.size()) spacing = std::min(spacing, request.joints[joint + 1] - s);
    return spacing;
}

/// Requests short elements where load is transferred to a bond: at joints, at the plate, and where the bond begins or
/// ends inside the bolt.
void addTransferPlaces(const Anchor& anchor, const std::vector<Interval>& intervals, const BoltModel& b, bool plated,
                       MeshRequest& request) {
    const Bond bond = bondOf(anchor);
    if (bond.stiffness <= 0.0) return;
    const double axial = b.section.youngsModulus * b.section.area;
    const double transfer = std::sqrt(axial / bond.stiffness);
    const double share = bond.residual < bond.peak ? softeningShare : transferShare;
    const double reach = reachOf(bond, transfer, axial, b.tensileStrength, request.length);
    const auto add = [&](double s) { request.fine.push_back({s, share * transfer, reach}); };
    for (const auto& [from, to] : intervals) {
        for (std::size_t i = 0; i < request.joints.size(); ++i) {
            if (request.joints[i] < from || request.joints[i] > to) continue;
            add(request.joints[i]);
            const double spacing = spacingAt(request, i);
            const double between = std::max(spacing / elementsBetweenJoints, share * transfer / 20.0);
            request.fine.push_back({request.joints[i], between, spacing});
        }
        if (from > 0.0) add(from);
        if (to < request.length || plated) add(to);
    }
}

bool isBonded(const std::vector<Anchor>& anchors) {
    return std::any_of(anchors.begin(), anchors.end(), [](const Anchor& anchor) { return !anchor.at; });
}

/// The automatic mesh (theory, "Divisions").
/// \param factor on the number of elements, without effect on a bond given per node.
MeshRequest meshRequest(const std::vector<Anchor>& anchors, const BoltModel& b, double length, bool plated,
                        double factor) {
    MeshRequest request;
    request.length = length;
    request.longest = length / (isBonded(anchors) ? bondedDivisions : freeDivisions);
    request.joints = b.joints;
    if (b.bends && b.shears)
        for (double joint : b.joints) request.fine.push_back({joint, b.dowelLength / 8.0, b.dowelLength});
    for (std::size_t e = 0; e < anchors.size(); ++e) {
        if (anchors[e].at) request.nodes.push_back(placeOf(*anchors[e].at, length));
        else if (anchors[e].per == Per::Length) addTransferPlaces(anchors[e], b.intervals[e], b, plated, request);
    }
    if (!isGivenPerNode(anchors)) {
        request.longest /= factor;
        for (FinePlace& place : request.fine) place.element /= factor;
    }
    std::sort(request.nodes.begin(), request.nodes.end());
    return request;
}

}  // namespace

BoltModel boltModel(const Scene& scene, int index, const Model& model) {
    assert(model.firstOf.size() == scene.blocks.size() + 1);
    const Bolt& bolt = scene.bolts[index];
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
    b.dynamicFactors = {bolt.dynamicFactor.value_or(type.dynamicFactor),
                        bolt.steelDynamicFactor.value_or(type.steelDynamicFactor),
                        bolt.plateDynamicFactor.value_or(type.plateDynamicFactor)};
    setSteel(type, b);
    b.pretension = bolt.pretension;
    b.slots = slotsAlong(model, b.farEnd, head);
    b.joints = jointPlaces(model, b.slots, length);
    b.dowelLength = dowelLengthOf(type, b.section, length);
    b.shears = actsAcross(scene, b, model);
    b.intervals = intervalsOf(anchorsOf(scene, bolt), length);
    b.s = bolt.divisions ? equalNodes(length, *bolt.divisions)
                         : gradedNodes(meshRequest(anchorsOf(scene, bolt), b, length, bolt.plate != PlateKind::None,
                                                   model.numerics.divisionsFactor));
    for (std::size_t i = 0; i + 1 < b.s.size(); ++i) {
        const bool shears = std::any_of(b.joints.begin(), b.joints.end(), [&](double s) {
            return s >= b.s[i] - model.tolerance && s <= b.s[i + 1] + model.tolerance;
        });
        b.elements.push_back({b.s[i + 1] - b.s[i], shears});
    }
    for (double s : b.s) b.startBlock.push_back(startBlockOf(model, b.slots, s));
    b.anchors = anchorsOfNodes(anchorsOf(scene, bolt), b.s, length, model.tolerance,
                               b.dynamicFactors.bond);
    setNormalSprings(b, type, !bolt.divisions);
    if (bolt.plate == PlateKind::Spring) b.plate = plateModel(model, b, type, bolt.divisions);
    if (bolt.plate == PlateKind::Block) b.plate = blockPlate(model, b, index, type);
    b.firstNode = model.nodes;
    return b;
}

}  // namespace keyblock
