// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Whether the steps of a motion begin with sweeps over the contact forces. Where
// Newton's method stalls, it is likely to stall in the next steps, too; a few of these
// therefore begin with sweeps. Then one begins with Newton's method again: if that
// does not stall and takes clearly less work, the steps after it do the same;
// otherwise more steps than before begin with sweeps until the next comparison. Where
// Newton's method takes much work without a stall, one step begins with sweeps on
// trial; they continue if they take less work than the step after it, and as long as
// they do not, trials become rarer.
#pragma once

#include <algorithm>

namespace keyblock {

struct SweepsFirst {
    // number of steps that begin with sweeps before a comparison; at most as many steps with much work between trials
    static constexpr int fewest = 16, most = 128;
    static constexpr int longer = 4;  // times that number after a comparison in favour of sweeps
    static constexpr double clearlyLess = 0.7;  // times the work of a step that began with sweeps
    static constexpr double much = 6.0;  // work of a step that calls for a trial of sweeps

    int left = 0;  // further steps that begin with sweeps
    int after = fewest;  // number of them after the next comparison, if it is in favour of sweeps
    int pause = 0;  // number of steps that take much work before the next trial
    int nextPause = 1;  // the same after that trial
    bool onTrial = false;  // the sweeps begun last were a trial
    double work = 0.0;  // of the last step that began with sweeps; 0: none to compare with

    bool now() const { return left > 0; }

    /// Takes note of a step that was solved; each solution of a repeated step counts.
    /// \param swept it began with sweeps.
    /// \param stalled Newton's method stalled in it; without effect if `swept`.
    /// \param workOfStep as given by `workOf`.
    void note(bool swept, bool stalled, double workOfStep) {
        if (swept) {
            --left;
            work = workOfStep;
            return;
        }
        if (work > 0.0 && (stalled || workOfStep > (onTrial ? 1.0 : clearlyLess) * work)) {
            left = after;
            after = std::min(longer * after, most);
            onTrial = false;
            pause = 0;
            nextPause = 1;
            return;
        }
        onTrial = !stalled && work == 0.0 && isTrialDue(workOfStep);
        left = stalled ? fewest : onTrial ? 1 : 0;
        after = fewest;
        work = 0.0;
    }

    /// Sweeps at the beginning of a step were of no use: the next step begins with Newton's method and, if
    /// sweeps were of use before, is compared with the last step that began with them.
    void drop() { left = 0; }

private:
    /// Whether a step of this work is followed by a trial of sweeps.
    bool isTrialDue(double workOfStep) {
        if (workOfStep <= much) return false;
        if (pause > 0) {
            --pause;
            return false;
        }
        pause = nextPause;
        nextPause = std::min(2 * nextPause, most);
        return true;
    }
};

}  // namespace keyblock
