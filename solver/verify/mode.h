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

/// Amplitude of the mode at the start and after each step, as integrated by the program. The mode starts at rest with
/// amplitude 1. The program runs a free block with an unbalanced initial stress σxx, and the amplitude is the ratio of
/// σxx to its initial value. With width w, height h, density ρ, Young's modulus E and Poisson's ratio 0 of the block,
/// the stiffness Ewh and the consistent mass ρw³h/12 give the angular frequency √(12E/(ρw²)).
std::vector<double> modeSeries(const ModeSetting& setting);

/// Amplitude of the mode at the start and after each step, according to the formulas of the scheme for one mass on one
/// spring. The mode starts at rest with amplitude 1.
std::vector<double> closedSeries(const ModeSetting& setting);

/// Number of preceding amplitudes that determine the next one: 2, or 3 if the scheme also stores accelerations that do
/// not follow from the forces.
int stepsRemembered(const ModeSetting& setting);

/// Spectral radius of the linear recurrence of the given order that fits the series, i.e. the largest magnitude of its
/// characteristic roots. NaN if the series has fewer than 2·`order` values.
double spectralRadius(const std::vector<double>& series, int order);

/// Spectral radius according to the formulas of the scheme.
double closedRadius(const ModeSetting& setting);

}  // namespace keyblock
