// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The reference of the voussoir beam, made afresh, and the calculation that it
// comes from against statics and against itself.
#include "solver/verify/references.h"
#include "tests/verify/reference/voussoir.h"

#include <gtest/gtest.h>

#include <cmath>

namespace keyblock {
namespace {

using reference::VoussoirBeam;
using reference::VoussoirThrust;
using reference::voussoirThrust;

const VoussoirBeam beam{10.0, 0.5, 10e9, 0.25, 25e3};

TEST(VoussoirReference, IsWhatTheElementsGive) {
    const VoussoirThrust found = voussoirThrust(beam, 64);
    EXPECT_NEAR(found.thrust, voussoirReference.thrust, 1e-5 * found.thrust);
    EXPECT_NEAR(found.arm, voussoirReference.arm, 1e-5);
}

TEST(VoussoirReference, ThrustAndArmMakeUpTheMoment) {
    for (const int rows : {2, 4, 8, 16}) {
        const VoussoirThrust found = voussoirThrust(beam, rows);
        EXPECT_NEAR(found.thrust * found.arm, 25e3 * 0.5 * 100.0 / 8.0, 1e-6 * 156e3) << rows;
    }
}

TEST(VoussoirReference, Converges) {
    const double coarse = voussoirThrust(beam, 8).thrust, fine = voussoirThrust(beam, 16).thrust,
                 finer = voussoirThrust(beam, 32).thrust;
    EXPECT_LT(std::abs(finer - fine), 0.5 * std::abs(fine - coarse));
    EXPECT_NEAR(finer, voussoirReference.thrust, 2e-3 * finer);
}

/// Nothing but shapes decides in an arch of one stiffness: thrust goes with the weight and does not know E.
TEST(VoussoirReference, DoesNotKnowTheModulus) {
    VoussoirBeam other = beam;
    other.youngsModulus *= 7.0;
    EXPECT_NEAR(voussoirThrust(other, 8).thrust, voussoirThrust(beam, 8).thrust, 1e-3);
    other.unitWeight *= 3.0;
    EXPECT_NEAR(voussoirThrust(other, 8).thrust, 3.0 * voussoirThrust(beam, 8).thrust, 1e-2);
}

}  // namespace
}  // namespace keyblock
