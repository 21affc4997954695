// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run/bolt_extremes.h"

#include "solver/run/bolt_readings.h"

#include <algorithm>
#include <cmath>

namespace keyblock {
namespace {

/// Records values of one state.
class Notes {
public:
    Notes(int stage, double time) : stage_(stage), time_(time) {}

    void add(BoltPeak& peak, double value, double at) const {
        if (std::abs(value) > std::abs(peak.value)) peak = {value, at, stage_, time_};
    }

    /// Omits the utilisation of a strength that the bolt does not have.
    void addUse(BoltPeak& peak, double use, double at) const {
        if (peak.value >= 0.0) add(peak, use, at);
    }

private:
    int stage_;
    double time_;
};

void addElement(const BoltModel& bolt, const BoltMotion& motion, std::size_t e, const Notes& notes, BoltExtremes& out) {
    const BoltElementState& element = motion.elements[e];
    const double middle = 0.5 * (bolt.s[e] + bolt.s[e + 1]);
    const bool first = std::abs(element.moment1) > std::abs(element.moment2);
    const double moment = first ? -element.moment1 : element.moment2, node = bolt.s[first ? e : e + 1];
    notes.add(out.axialForce, element.axialForce, middle);
    notes.add(out.shearForce, element.shearForce, middle);
    notes.add(out.moment, moment, node);
    if (bolt.tensileStrength > 0.0) {
        const double strength = motion.strength.steel * bolt.tensileStrength;
        const double plastic = strength * bolt.plasticModulus / bolt.section.area;
        notes.addUse(out.steel, steelUse(element.axialForce / strength, bolt.bends ? moment / plastic : 0.0), middle);
    }
    if (bolt.shearStrength > 0.0)
        notes.addUse(out.shear, std::abs(element.shearForce) / (motion.strength.steel * bolt.shearStrength), middle);
}

void addNode(const BoltModel& bolt, const BoltMotion& motion, std::size_t n, const Notes& notes, BoltExtremes& out) {
    const BoltNode& node = motion.nodes[n];
    if (const double strength = bondStrengthNow(bolt.anchors[n], motion, node); strength > 0.0)
        notes.addUse(out.bond, std::abs(node.bond.force) / strength, bolt.s[n]);
}

void addPlate(const BoltModel& bolt, const BoltMotion& motion, const Notes& notes, BoltExtremes& out) {
    if (!motion.plateHolds) return;
    const PlateModel& plate = bolt.plate;
    const double normal = plate.normalStrength ? std::abs(motion.plateNormal) / *plate.normalStrength : 0.0;
    const double shear = plate.shearStrength ? std::abs(motion.plateShear) / *plate.shearStrength : 0.0;
    notes.addUse(out.plate, std::max(normal, shear) / motion.strength.plate, bolt.s.back());
}

bool hasBondStrength(const BoltModel& bolt) {
    return std::any_of(bolt.anchors.begin(), bolt.anchors.end(),
                       [](const AnchorModel& anchor) { return anchor.real && (anchor.strength || anchor.curve); });
}

}  // namespace

double steelUse(double axial, double bending) {
    const double m = std::abs(bending);
    return 0.5 * (m + std::sqrt(m * m + 4.0 * axial * axial));
}

std::vector<BoltExtremes> startExtremes(const Model& model) {
    std::vector<BoltExtremes> extremes;
    for (const BoltModel& bolt : model.bolts) {
        BoltExtremes start;
        start.steel.value = bolt.tensileStrength > 0.0 ? 0.0 : -1.0;
        start.shear.value = bolt.shearStrength > 0.0 ? 0.0 : -1.0;
        start.bond.value = hasBondStrength(bolt) ? 0.0 : -1.0;
        const PlateModel& plate = bolt.plate;
        start.plate.value = plate.present && (plate.normalStrength || plate.shearStrength) ? 0.0 : -1.0;
        extremes.push_back(start);
    }
    return extremes;
}

void addExtremes(const Model& model, const State& state, int stage, double time, std::vector<BoltExtremes>& extremes) {
    const Notes notes(stage, time);
    for (std::size_t b = 0; b < model.bolts.size(); ++b) {
        const BoltModel& bolt = model.bolts[b];
        const BoltMotion& motion = state.bolts[b];
        if (!acts(motion)) continue;
        for (std::size_t e = 0; e < motion.elements.size(); ++e) addElement(bolt, motion, e, notes, extremes[b]);
        for (std::size_t n = 0; n < motion.nodes.size(); ++n) addNode(bolt, motion, n, notes, extremes[b]);
        addPlate(bolt, motion, notes, extremes[b]);
    }
}

}  // namespace keyblock
