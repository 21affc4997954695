// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Bonded faces between cells: which contacts are joined, what they carry as a
// resultant and a moment, and that nothing of it is lost when they part.

#include "solver/engine/contact/bonded_face.h"
#include "solver/engine/contact/contact_limits.h"
#include "solver/engine/contact/search.h"
#include "solver/engine/setup/make_model.h"
#include "solver/verify/scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace keyblock {
namespace {

constexpr double modulus = 10e9, depth = 0.5;

/// Two blocks side by side with a bonded joint at x = 1, in square cells of half their depth.
Scene pair(bool cells, std::optional<double> stiffness = {}) {
    Scene scene = emptyScene(modulus, 0.2, 40.0);
    scene.analysis.plane = Plane::Stress;
    JointMaterial& joint = scene.jointMaterials.front().second;
    joint.cohesion = 1e8;
    joint.tensileStrength = 1e5;
    joint.normalStiffness = stiffness;
    scene.blocks = {boxBlock("left", {0, 0}, {1, depth}), boxBlock("right", {1, 0}, {2, depth})};
    if (cells)
        for (Block& block : scene.blocks) block.subBlocks = CellSettings{0.5 * depth};
    return scene;
}

struct Joined {
    Model model;
    State state;

    explicit Joined(const Scene& scene) : model(makeModel(scene)), state(makeState(model)) {
        state.contacts = findContacts(model, state.blocks, {}, 1e-3, true);
    }

    /// The two contacts of the lowest face, the lower one first.
    std::pair<Contact*, Contact*> lowest() {
        Contact *low = nullptr, *high = nullptr;
        for (Contact& c : state.contacts) {
            if (!c.bonded) continue;
            const double y = at(c).y() + model.origin.y();
            if (y < 0.01 * depth) low = &c;
        }
        for (Contact& c : state.contacts)
            if (&c != low && std::minmax(c.blockA, c.blockB) == std::minmax(low->blockA, low->blockB)) high = &c;
        return {low, high};
    }

    Point at(const Contact& c) const {
        return state.blocks[c.blockA].corners[c.corner];
    }
};

TEST(BondedFace, WholeBlocksKeepTheSpringsAtTheirCorners) {
    for (const Contact& c : Joined(pair(false)).state.contacts) EXPECT_LT(c.face.toward, 0);
}

TEST(BondedFace, EveryFaceOfCellsIsJoinedAndNoCornerIsLeftBesides) {
    const Joined found(pair(true));
    ASSERT_EQ(found.state.contacts.size(), 4u);  // two faces with two ends each, and none across the corner they share
    for (const Contact& c : found.state.contacts) {
        EXPECT_TRUE(c.bonded);
        EXPECT_GE(c.face.toward, 0);
        EXPECT_NEAR(gapOf(found.state.blocks, c), 0.0, 1e-12);
    }
}

TEST(BondedFace, ASoftJointActsAtTheGaussPoints) {
    Joined found(pair(true, 1e6));  // rock is 10,000 times as stiff
    const auto [low, high] = found.lowest();
    EXPECT_NEAR(low->face.spread, 1.0 / std::sqrt(3.0), 1e-4);
    EXPECT_NEAR((contactPoint(found.state.blocks, *low) - contactPoint(found.state.blocks, *high)).norm(),
                low->face.spread * 0.5 * depth, 1e-12);
}

TEST(BondedFace, TwoSpringsTurnAsTheHalvesOfTheCellsBesideThem) {
    Joined found(pair(true));
    const auto [low, high] = found.lowest();
    const double length = 0.5 * depth, apart = low->face.spread * length;
    const double turning = 0.5 * contactSprings(found.model, *low).normal * apart * apart;
    EXPECT_NEAR(turning, modulus * std::pow(length, 3) / 12.0 / (0.5 * depth), 1e-9 * turning);
}

TEST(BondedFace, EndsShowALinearTractionAndAreJudgedByIt) {
    Joined found(pair(true));
    const auto [low, high] = found.lowest();
    const double length = 0.5 * depth, mean = 3e4, slope = 5e4;  // traction mean ± slope [Pa]
    const double resultant = mean * length, moment = slope * length * length / 6.0;
    low->normalForce = 0.5 * resultant + moment / (low->face.spread * length);
    high->normalForce = 0.5 * resultant - moment / (low->face.spread * length);
    const std::vector<Contact>& all = found.state.contacts;
    EXPECT_NEAR(forcesAtCorner(all, *low).normal, 0.5 * resultant + moment / length, 1e-9 * resultant);
    EXPECT_NEAR(forcesAtCorner(all, *high).normal, 0.5 * resultant - moment / length, 1e-9 * resultant);
    EXPECT_NEAR(edgeCompression(all, *low), 0.5 * length * (mean + slope), 1e-9 * resultant);
    EXPECT_NEAR(edgeCompression(all, *high), 0.5 * length * (mean - slope), 1e-9 * resultant);
    std::vector<Limit> limits;
    addJointLimits(found.model, found.state, limits);
    double worst = 0.0;
    for (const Limit& limit : limits) worst = std::max(worst, limit.ratio);
    EXPECT_NEAR(worst, (slope - mean) / 1e5, 1e-9);
}

TEST(BondedFace, PartedEndsCarryTheSameResultantAndMomentAndTheEnergyIsBooked) {
    Joined found(pair(true));
    const auto [low, high] = found.lowest();
    low->normalForce = 4e3, high->normalForce = -1e3, low->shearForce = high->shearForce = 2e2;
    for (Contact* c : {low, high}) {
        carryNormal(found.model, *c, gapOf(found.state.blocks, *c), c->normalForce);
        carryShear(found.model, *c, slipOf(found.state.blocks, *c), c->shearForce);
    }
    const double apart = low->face.spread;
    const auto energy = [&] {
        return contactEnergy(found.model, found.state.blocks, *low) + contactEnergy(found.model, found.state.blocks, *high);
    };
    const double before = energy();
    const double lost = partBondedFace(found.model, found.state.blocks, found.state.contacts, *high);
    EXPECT_LT(low->face.toward, 0);
    EXPECT_LT(high->face.toward, 0);
    EXPECT_NEAR(low->normalForce, 1.5e3 + 2.5e3 * apart, 1e-9);
    EXPECT_NEAR(high->normalForce, 1.5e3 - 2.5e3 * apart, 1e-9);
    for (const Contact* c : {low, high}) {
        const auto [open, free] = zeroPoints(*c, contactSprings(found.model, *c));
        const ContactSprings k = contactSprings(found.model, *c);
        EXPECT_NEAR(k.normal * (open - gapOf(found.state.blocks, *c)), c->normalForce, 1e-6);
        EXPECT_NEAR(k.shear * (slipOf(found.state.blocks, *c) - free), c->shearForce, 1e-6);
    }
    EXPECT_NEAR(before - energy(), lost, 1e-12);
    EXPECT_GT(lost, 0.0);
    const double parted = energy();
    EXPECT_NEAR(joinBondedFaces(found.model, found.state.blocks, found.state.contacts), parted - before, 1e-12);
    EXPECT_NEAR(low->normalForce, 4e3, 1e-9);
    EXPECT_NEAR(high->normalForce, -1e3, 1e-9);
}

}  // namespace
}  // namespace keyblock
