// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The energy account of a search for equilibrium closes when contacts end on the way.
#include "solver/engine/stage/energy_account.h"

#include "solver/engine/contact/search.h"
#include "solver/engine/contact/springs.h"
#include "solver/engine/setup/make_model.h"
#include "solver/engine/stage/step_build.h"
#include "solver/verify/scenes.h"

#include <gtest/gtest.h>

namespace keyblock {
namespace {

constexpr double drop = 0.02;  // m

/// A box of 1 m × 1 m at rest on a fixed base. Its two contacts carry half of its weight each.
class EnergyAccountTest : public testing::Test {
protected:
    EnergyAccountTest() : model_(makeModel(boxOnBase())), start_(makeState(model_)) {
        at_.gravity = 1.0;
        weight_ = model_.blocks[1].mass * gravity;
        start_.contacts = findContacts(model_, start_.blocks, {}, 1e-3, true);
        for (Contact& c : start_.contacts) {
            carryNormal(model_, c, c.gap, 0.5 * weight_);
            c.normalForce = 0.5 * weight_;
        }
    }

    static Scene boxOnBase() {
        Scene scene = emptyScene(10e9, 0.2, 30.0);
        scene.analysis.gravity = {0.0, -gravity};
        scene.blocks = {boxBlock("base", {-1, -1}, {2, 0}), boxBlock("box", {0, 0}, {1, 1})};
        Support support;
        support.blockAt = Point(0.5, -0.5);
        scene.supports = {support};
        return scene;
    }

    /// The box has come to rest lower down, as if a corner had given way: `contacts` carry half of its weight there.
    State lowered(std::vector<Contact> contacts) const {
        State end = start_;
        Vector6 d = Vector6::Zero();
        d[1] = -drop;
        moveBlock(model_.blocks[1], end.blocks[1], d);
        for (Contact& c : contacts) carryNormal(model_, c, c.gap - drop, 0.5 * weight_);
        end.contacts = std::move(contacts);
        return end;
    }

    /// The energies that the account adds on the way to `end`.
    EnergyLedger accountOf(State end) const {
        const StaticAccount account(model_, start_, loads_, at_);
        StepProblem problem = buildStep(model_, end, loads_, at_, {Inertia::None});
        Eigen::VectorXd moved = Eigen::VectorXd::Zero(problem.unknowns());
        moved[7] = -drop;
        account.add(end, at_, moved, problem);
        return end.energy;
    }

    Model model_;
    State start_;
    Loads loads_;
    LoadPoint at_;
    double weight_ = 0.0;  // [N]
};

/// Neither the elastic energy nor that of the contacts has changed, so that all of the work is lost.
TEST_F(EnergyAccountTest, TheWorkOfABlockWhoseContactsEndedAndFormedAgainIsDamped) {
    std::vector<Contact> formed = start_.contacts;
    for (Contact& c : formed) c.normalForce = 0.0;
    const EnergyLedger energy = accountOf(lowered(formed));
    EXPECT_NEAR(energy.external, weight_ * drop, 1e-9 * weight_ * drop);
    EXPECT_NEAR(energy.damped, weight_ * drop, 1e-6 * weight_ * drop);
}

/// Half of the work is that of the net force at the end, where nothing carries the box, half that of its contacts.
TEST_F(EnergyAccountTest, TheWorkOfABlockWhoseContactsHaveEndedIsDampedToo) {
    const EnergyLedger energy = accountOf(lowered({}));
    EXPECT_NEAR(energy.external, weight_ * drop, 1e-9 * weight_ * drop);
    EXPECT_NEAR(energy.damped, weight_ * drop, 1e-6 * weight_ * drop);
}

}  // namespace
}  // namespace keyblock
