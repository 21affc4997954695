// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// One mode of vibration under every time integration scheme, as integrated by the
// program and according to the formulas of the scheme.
#pragma once

#include "solver/scene/scene.h"

#include <vector>

namespace keyblock {

struct ModeSetting {
    Integration scheme = Integration::Shi;
    double rhoInf = 0.8;
    double eta = 0.1;  // angular frequency × time step
    double massShare = 0.0, stiffnessShare = 0.0;  // mass and stiffness damping, as fractions of critical damping
    int steps = 12;
};

/// Amplitude of the mode at each step as integrated by the program, starting at rest with amplitude 1. It is the
/// normalised stress of a free block with an unbalanced initial stress. For a block of width w, height h and Poisson's
/// ratio 0, the stiffness Ewh and the consistent mass ρw³h/12 give the angular frequency ω with ω² = 12E/(ρw²).
std::vector<double> modeSeries(const ModeSetting& setting);

/// Amplitude of the mode at each step according to the formulas of the scheme for one mass on one spring, starting at
/// rest with amplitude 1.
std::vector<double> closedSeries(const ModeSetting& setting);

/// Number of preceding values that determine the next value: 2, or 3 if the scheme also stores accelerations that do
/// not follow from the forces.
int stepsRemembered(const ModeSetting& setting);

/// Spectral radius: the largest magnitude of a root of the linear recurrence of the given order that fits the series;
/// NaN if the series has fewer than 2·`order` values.
double spectralRadius(const std::vector<double>& series, int order);

/// Spectral radius according to the formulas of the scheme.
double closedRadius(const ModeSetting& setting);

}  // namespace keyblock
