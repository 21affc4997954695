// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The table of quantities: names are one each, and what is derived is right.
#include "solver/results/frame_quantities.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

namespace keyblock {
namespace {

TEST(FrameQuantities, NoNameMeansTwoThings) {
    std::set<std::string_view> names;
    std::size_t rows = 0;
    const auto add = [&](const auto& list) {
        for (const auto& row : list) {
            names.insert(row.name);
            ++rows;
        }
    };
    add(blockQuantities());
    add(contactQuantities());
    add(boltQuantities());
    EXPECT_EQ(names.size(), rows);
    EXPECT_EQ(findQuantity(blockQuantities(), "sigma2"), nullptr);
    EXPECT_EQ(findQuantity(boltQuantities(), "slip")->column, "slip_m");
}

TEST(FrameQuantities, OfBoltsAreThoseOfTheTableInItsOrder) {
    int before = -1;
    for (const FrameQuantity<BoltNodeFrame>& quantity : boltQuantities()) {
        const BoltQuantityRow& row = rowOf(quantity);
        EXPECT_EQ(quantity.name, row.key);
        EXPECT_EQ(quantity.column, row.column);
        EXPECT_EQ(quantity.display.title, row.title);
        EXPECT_EQ(findQuantity(row.quantity), &quantity);
        EXPECT_NE(row.part, BoltPart::Bolt) << row.key;  // has no value at a node
        EXPECT_LT(before, static_cast<int>(row.quantity));
        before = static_cast<int>(row.quantity);
    }
    EXPECT_EQ(findQuantity(BoltQuantity::Strain), nullptr);
    BoltNodeFrame node;
    node.axialForce = 5e3;
    const auto* axial = findQuantity(BoltQuantity::AxialForce);
    EXPECT_DOUBLE_EQ(axial->value(node) * axial->display.factor, 5.0);
}

TEST(FrameQuantities, PrincipalStressesAreCompressionPositiveAndTurned) {
    const PrincipalStress upright = principalStress({-2e6, -5e6, 0.0});
    EXPECT_DOUBLE_EQ(upright.major, 5e6);
    EXPECT_DOUBLE_EQ(upright.minor, 2e6);
    EXPECT_NEAR(std::abs(upright.direction.y()), 1.0, 1e-15);

    // 7 and 1 MPa of compression, the larger at 30° to x
    const double c = std::cos(std::numbers::pi / 6), s = std::sin(std::numbers::pi / 6);
    const PrincipalStress turned = principalStress({-(7e6 * c * c + 1e6 * s * s), -(7e6 * s * s + 1e6 * c * c),
                                                    -(7e6 - 1e6) * s * c});
    EXPECT_NEAR(turned.major, 7e6, 1e-8);
    EXPECT_NEAR(turned.minor, 1e6, 1e-8);
    EXPECT_NEAR(turned.direction.x(), c, 1e-14);
    EXPECT_NEAR(turned.direction.y(), s, 1e-14);
}

TEST(FrameQuantities, EqualPrincipalStressesHaveADirection) {
    const PrincipalStress even = principalStress({-1e6, -1e6, 0.0});
    EXPECT_EQ(even.major, even.minor);
    EXPECT_EQ(even.direction, Point(1.0, 0.0));
}

TEST(FrameQuantities, APushOnAHasANormalAndAShearPart) {
    ContactFrame contact;
    contact.normal = {0.0, 1.0};  // a stands on b
    contact.normalForce = 5.0;
    contact.shearForce = 2.0;
    EXPECT_EQ(forceOnA(contact), Point(2.0, 5.0));
}

TEST(FrameQuantities, ShownCompressionIsPositive) {
    BlockState block;
    block.stress = {-3e6, -1e6, 0.0};
    const auto* sxx = findQuantity(blockQuantities(), "sxx");
    EXPECT_DOUBLE_EQ(sxx->value(block) * sxx->display.factor, 3.0);
    const auto* major = findQuantity(blockQuantities(), "sigma1");
    EXPECT_DOUBLE_EQ(major->value(block) * major->display.factor, 3.0);
}

}  // namespace
}  // namespace keyblock
