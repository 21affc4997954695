// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Every form of a quantity is read, and every wrong one is answered with what
// could have been meant.
#include "solver/scene/quantity_text.h"

#include <gtest/gtest.h>

namespace keyblock {
namespace {

Scene monitoredScene() {
    Scene scene;
    scene.bolts.resize(2);
    scene.bolts[0].name = "B1";
    scene.bolts[1].name = "B.2";
    scene.monitors.resize(3);
    scene.monitors[0].name = "crown";
    scene.monitors[0].point = Point{0.0, 1.0};
    scene.monitors[1].name = "joint force";
    scene.monitors[1].bolt = "B1";
    scene.monitors[2].name = "B1";
    scene.monitors[2].between = std::array{Point{0.0, 0.0}, Point{1.0, 0.0}};
    return scene;
}

void expectQuantity(const std::string& text, const Quantity& expected) {
    const QuantityReading reading = readQuantity(text, monitoredScene());
    ASSERT_TRUE(reading.quantity) << text << ": " << reading.problem;
    EXPECT_EQ(*reading.quantity, expected) << text;
}

void expectUnreadable(const std::string& text, const std::string& part) {
    const QuantityReading reading = readQuantity(text, monitoredScene());
    EXPECT_FALSE(reading.quantity) << text;
    EXPECT_NE(reading.problem.find(part), std::string::npos) << text << ": " << reading.problem;
}

TEST(QuantityText, ReadsEveryForm) {
    expectQuantity("max joint force", {QuantityKind::Max, -1, {.monitor = 1}});
    expectQuantity("last crown.uy", {QuantityKind::Last, -1, {.monitor = 0, .component = 1}});
    expectQuantity(" min  crown.ux ", {QuantityKind::Min, -1, {.monitor = 0}});
    expectQuantity("first debonding joint force", {QuantityKind::First, 2, {.monitor = 1}});
    expectQuantity("max B1.plate_force",
                   {QuantityKind::Max, -1, {.bolt = 0, .boltQuantity = BoltQuantity::PlateForce}});
    expectQuantity("max B.2.strain", {QuantityKind::Max, -1, {.bolt = 1, .boltQuantity = BoltQuantity::Strain}});
    expectQuantity("max crown.u", {QuantityKind::Max, -1, {.monitor = 0, .component = 2}});
    expectQuantity("count debonding", {QuantityKind::Count, 2, {}});
    expectQuantity(" order  debonding", {QuantityKind::Order, 2, {}});
    expectQuantity("stands", {QuantityKind::Stands, -1, {}});
    expectQuantity("energy_error ", {QuantityKind::EnergyError, -1, {}});
    expectQuantity("factor_of_safety", {QuantityKind::FactorOfSafety, -1, {}});
}

TEST(QuantityText, TellsMonitorAndBoltOfOneNameApart) {
    expectQuantity("max B1", {QuantityKind::Max, -1, {.monitor = 2}});
    expectQuantity("max B1.slip", {QuantityKind::Max, -1, {.bolt = 0, .boltQuantity = BoltQuantity::Slip}});
}

TEST(QuantityText, SaysWhatToWriteInstead) {
    expectUnreadable("", "starts with max");
    expectUnreadable("mean crown.ux", "starts with max");
    expectUnreadable("first break joint force", "tensile-rupture");
    expectUnreadable("first debonding B1.slip", "add a monitor");
    expectUnreadable("max crown", "crown.ux");
    expectUnreadable("max crown.uz", ".uy");
    expectUnreadable("max joint force.ux", "omit");
    expectUnreadable("max B.2.force", "axial_force");
    expectUnreadable("max nothing", "crown, joint force");
    expectUnreadable("count", "is not a kind of event");
    expectUnreadable("count debonding crown", "omit");
    expectUnreadable("stands crown.u", "omit");
}

}  // namespace
}  // namespace keyblock
