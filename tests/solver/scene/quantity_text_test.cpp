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
    expectQuantity("max joint force", {Reduction::Max, -1, {.monitor = 1}});
    expectQuantity("last crown.uy", {Reduction::Last, -1, {.monitor = 0, .component = 1}});
    expectQuantity(" min  crown.ux ", {Reduction::Min, -1, {.monitor = 0}});
    expectQuantity("first debonding joint force", {Reduction::First, 2, {.monitor = 1}});
    expectQuantity("max B1.plate_force", {Reduction::Max, -1, {.bolt = 0, .boltQuantity = BoltQuantity::PlateForce}});
    expectQuantity("max B.2.strain", {Reduction::Max, -1, {.bolt = 1, .boltQuantity = BoltQuantity::Strain}});
}

TEST(QuantityText, TellsMonitorAndBoltOfOneNameApart) {
    expectQuantity("max B1", {Reduction::Max, -1, {.monitor = 2}});
    expectQuantity("max B1.slip", {Reduction::Max, -1, {.bolt = 0, .boltQuantity = BoltQuantity::Slip}});
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
}

}  // namespace
}  // namespace keyblock
