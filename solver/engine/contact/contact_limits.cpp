// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/contact/contact_limits.h"

#include "solver/engine/contact/bonded_face.h"
#include "solver/engine/contact/springs.h"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

constexpr double leastFriction = 1e-12;  // of E · size · thickness: smaller forces are round-off
constexpr double leastTension = 1e-6;  // of the cohesive strength, for joints without tensile strength

/// Tension over tensile strength. \param compression force at the contact's end of its face [N].
double tensionRatio(const Model& model, const Contact& c, double compression) {
    const JointModel& joint = model.joints[c.joint];
    const double face = c.length * model.thickness;
    const double strength = std::max(joint.tensileStrength, leastTension * joint.cohesion) * face;
    if (strength <= 0.0) return compression < 0.0 ? 1.0 / leastTension : 0.0;  // the strength was removed by a stage
    return std::max(0.0, -compression) / strength;
}

double shearRatio(const Model& model, const Contact& c, double compression) {
    const JointModel& joint = model.joints[c.joint];
    const double strength =
        joint.cohesion * c.length * model.thickness + std::max(0.0, compression) * joint.tanPhi;
    return strength > 0.0 ? std::abs(c.shearForce) / strength : (c.shearForce == 0.0 ? 0.0 : 1.0 / leastTension);
}

/// True if the contact still has its peak friction, which is higher than the residual friction, and its force is more
/// than round-off.
bool holdsPeak(const Model& model, const Contact& c) {
    const JointModel& joint = model.joints[c.joint];
    if (c.bonded || c.slipped || joint.tanResidual >= joint.tanPhi) return false;
    const double modulus = std::min(model.blocks[c.blockA].youngsModulus, model.blocks[c.blockB].youngsModulus);
    const double size = std::min(model.blocks[c.blockA].size, model.blocks[c.blockB].size);
    return c.normalForce * joint.tanPhi > leastFriction * modulus * size * model.thickness;
}

/// Shear force that the contact would carry if it had not slid in its last step, over the peak strength; 1 when sliding
/// begins.
double peakRatio(const Model& model, const Contact& c) {
    return (std::abs(c.shearForce) + contactSprings(model, c).shear * std::abs(c.slid)) /
           (c.normalForce * model.joints[c.joint].tanPhi);
}

/// Friction drops to its residual value, which the joint then carries at the present positions of the blocks.
void dropFriction(const Model& model, State& state, Contact& c) {
    c.limit = std::max(0.0, c.normalForce) * frictionOf(model, c);
    const double kept = std::clamp(c.shearForce, -c.limit, c.limit);
    carryShear(model, c, slipOf(state.blocks, c), kept);
    c.shearForce = kept;
}

}  // namespace

void addJointLimits(const Model& model, const State& state, std::vector<Limit>& limits) {
    for (std::size_t i = 0; i < state.contacts.size(); ++i) {
        const Contact& c = state.contacts[i];
        if (holdsPeak(model, c))
            limits.push_back({LimitKind::PeakFriction, static_cast<int>(i), 0, peakRatio(model, c)});
        if (!c.bonded) continue;
        const double compression = edgeCompression(state.contacts, c);
        limits.push_back({LimitKind::JointBond, static_cast<int>(i), 0,
                          std::max(tensionRatio(model, c, compression), shearRatio(model, c, compression))});
    }
}

std::vector<Event> releaseJoint(const Model& model, State& state, const Limit& limit) {
    Contact& c = state.contacts[limit.owner];
    Event event;
    const double compression = edgeCompression(state.contacts, c);
    const bool opens = c.bonded && tensionRatio(model, c, compression) >= shearRatio(model, c, compression);
    event.kind = opens ? EventKind::JointOpen : EventKind::JointSlip;
    event.block = c.blockA;
    event.otherBlock = c.blockB;
    event.position = c.position;
    event.axialForce = -compression;
    event.shearForce = c.shearForce;
    event.slip = c.slip;
    state.energy.released += partBondedFace(model, state.blocks, state.contacts, c);
    state.energy.released += contactEnergy(model, state.blocks, c);
    c.bonded = false;
    c.slipped = c.slipped || !opens;
    dropFriction(model, state, c);
    state.energy.released -= contactEnergy(model, state.blocks, c);
    return {event};
}

}  // namespace keyblock
