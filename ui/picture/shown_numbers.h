// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a person wants numbers. Pictures and charts are made in the units of daily
// work (mm, kN, MPa) with compression positive; what is made is turned here to
// plain SI, or to tension positive. Colours stay: they tell of the rock, not of
// how its numbers are written.
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

/// How a quantity is shown: shown = factor · as pictures are made.
struct ShownAs {
    std::string unit, convention;
    double factor = 1.0;
};

/// Of a quantity with that unit (`MPa`, `kN per bolt`) and sign convention, as pictures are made.
ShownAs shownAs(std::string_view unit, std::string_view convention, const ShownNumbers& numbers);

/// A number in its unit, as pictures are made or plain SI; 0 where it is no more than round-off can leave of that unit.
double withoutRoundOff(double value, std::string_view unit);

/// Of a title that ends with its unit: `Axial force (kN)`.
double factorOf(std::string title, const ShownNumbers& numbers);

/// A title with its units as shown: `Axial force (kN) over joint opening (mm)` becomes `… (N) over … (m)`.
std::string shownTitle(const std::string& title, const ShownNumbers& numbers);

std::string forceText(double force, const ShownNumbers& numbers);  // of [N], with its unit: `119 kN`
std::string lengthText(double length, const ShownNumbers& numbers);  // of [m], with its unit: `31 mm`

/// Turns what was made with the usual numbers; once.
void showAs(SectionPicture& picture, const ShownNumbers& numbers);
void showAs(Chart& chart, const ShownNumbers& numbers);

}  // namespace keyblock
