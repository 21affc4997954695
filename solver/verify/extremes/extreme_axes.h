// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The axes along which scenes are pushed, as a table: values from ordinary ones to and
// past the edge, and the reason for the edge.
#pragma once

#include "solver/verify/extremes/conditions.h"

#include <string>
#include <vector>

namespace keyblock {

struct ExtremeAxis {
    std::string name;
    std::string title;
    std::string unit;  // empty: a pure number
    std::vector<double> values;
    double least = 0.0, most = 0.0;  // range of random combinations
    bool logarithmic = true;  // distribution in random combinations
    void (*apply)(Conditions&, double);
    double (*usual)(const Conditions&);  // the value under ordinary conditions
    std::string reason;
    std::vector<std::string> words{};  // names of the values 0, 1, …; empty: numbers
};

const std::vector<ExtremeAxis>& extremeAxes();

/// \pre there is an axis of this name.
const ExtremeAxis& extremeAxis(const std::string& name);

/// A value of an axis for display, with its unit.
std::string valueText(const ExtremeAxis& axis, double value);

}  // namespace keyblock
