// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One mode of vibration under every scheme: as the program integrates it, and as
// the schemes' own formulas do.
#pragma once

#include "solver/scene/scene.h"

#include <vector>

namespace keyblock {

struct ModeSetting {
    Integration scheme = Integration::Shi;
    double rhoInf = 0.8;
    double eta = 0.1;  // frequency × step
    double massShare = 0.0, stiffnessShare = 0.0;  // of critical damping, by mass and by stiffness
    int steps = 12;
};

/// Values of the mode step by step, from 1 at rest, as the program integrates it: the stress of a free block whose
/// initial stress nothing balances. With Poisson's ratio 0 and the consistent mass ρw³h/12, ω² = 12E/(ρw²).
std::vector<double> modeSeries(const ModeSetting& setting);

/// The same by the scheme's own formulas for one mass on one spring.
std::vector<double> closedSeries(const ModeSetting& setting);

/// Steps that determine the next: 2, or 3 where accelerations are carried that the forces do not give.
int stepsRemembered(const ModeSetting& setting);

/// Largest root of the recurrence of `order` that the series obeys.
double spectralRadius(const std::vector<double>& series, int order);

/// Spectral radius by the scheme's own formulas.
double closedRadius(const ModeSetting& setting);

}  // namespace keyblock
