// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The user's choice of units and signs. Pictures and charts are made in the usual units
// (mm, kN, MPa) with compression positive; here they are converted to SI base units, or
// to tension positive. Colours stay: they belong to the values, not to their notation.
#pragma once

#include <string>
#include <string_view>

namespace keyblock {

struct Chart;
struct SectionPicture;

struct ShownNumbers {
    bool si = false;  // m, N, Pa and J
    bool tensionPositive = false;  // for stresses of blocks

    bool operator==(const ShownNumbers&) const = default;
};

/// How a quantity is shown: shown = factor · value in units of pictures.
struct ShownAs {
    std::string unit, convention;
    double factor = 1.0;
};

/// For a quantity with that unit (`MPa`, `kN per bolt`) and sign convention, as in pictures.
ShownAs shownAs(std::string_view unit, std::string_view convention, const ShownNumbers& numbers);

/// A number in its unit, as in pictures or SI base units; 0 if it is no more than round-off in that unit.
double withoutRoundOff(double value, std::string_view unit);

/// For a title that ends with its unit: `Axial force (kN)`.
double factorOf(std::string title, const ShownNumbers& numbers);

/// A title with its units as shown: `Axial force (kN) over joint opening (mm)` becomes `… (N) over … (m)`.
std::string shownTitle(const std::string& title, const ShownNumbers& numbers);

std::string forceText(double force, const ShownNumbers& numbers);  // of [N], with its unit: `119 kN`
std::string lengthText(double length, const ShownNumbers& numbers);  // of [m], with its unit: `31 mm`

/// Converts data in the units of pictures; call once.
void showAs(SectionPicture& picture, const ShownNumbers& numbers);
void showAs(Chart& chart, const ShownNumbers& numbers);

}  // namespace keyblock
