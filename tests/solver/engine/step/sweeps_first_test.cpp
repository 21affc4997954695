// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/engine/step/sweeps_first.h"

#include <gtest/gtest.h>

namespace keyblock {
namespace {

/// Notes `steps` steps and counts those that begin with sweeps. \param swept, newton work of a step that begins with
/// sweeps, and of one that does not. \param stalls Newton's method stalls.
int noteSteps(SweepsFirst& first, int steps, double swept, double newton, bool stalls) {
    int count = 0;
    for (int step = 0; step < steps; ++step) {
        const bool now = first.now();
        count += now;
        first.note(now, stalls && !now, now ? swept : newton);
    }
    return count;
}

TEST(SweepsFirst, AreNotMadeWhereNewtonsMethodDoesNotStall) {
    SweepsFirst first;
    EXPECT_EQ(noteSteps(first, 100, 1.0, 5.0, false), 0);
}

TEST(SweepsFirst, AreMadeInAlmostAllStepsWhereTheyTakeLessWork) {
    SweepsFirst first;
    first.note(false, true, 5.0);
    const int steps = 360, compared = 5;  // after 16, 16, 64, 128 and 128 steps
    EXPECT_EQ(noteSteps(first, steps, 3.0, 5.0, false), steps - compared);
}

TEST(SweepsFirst, EndSoonWhereNewtonsMethodTakesClearlyLessWork) {
    SweepsFirst first;
    first.note(false, true, 5.0);
    EXPECT_EQ(noteSteps(first, 100, 3.0, 1.0, false), SweepsFirst::fewest);
    EXPECT_FALSE(first.now());
}

TEST(SweepsFirst, ContinueWhereNewtonsMethodStallsAtLittleWork) {
    SweepsFirst first;
    first.note(false, true, 1.0);
    const int steps = 40, compared = 2;  // after 16 and 16 steps
    EXPECT_EQ(noteSteps(first, steps, 3.0, 1.0, true), steps - compared);
}

TEST(SweepsFirst, AreTriedWhereNewtonsMethodTakesMuchWork) {
    const double much = 2.0 * SweepsFirst::much;
    SweepsFirst better;
    const int steps = 180, newton = 4;  // the first step, and those after 1, 16 and 64 with sweeps
    EXPECT_EQ(noteSteps(better, steps, 0.5 * much, much, false), steps - newton);
    SweepsFirst worse;
    const int trials = 6;  // after 0, 1, 2, 4, 8 and 16 further steps with much work
    EXPECT_EQ(noteSteps(worse, 64, 2.0 * much, much, false), trials);
}

TEST(SweepsFirst, AreDroppedAtOnceWhereTheyAreOfNoUse) {
    SweepsFirst first;
    first.note(false, true, 5.0);
    first.drop();
    EXPECT_EQ(noteSteps(first, 10, 3.0, 5.0, false), 0);
}

}  // namespace
}  // namespace keyblock
