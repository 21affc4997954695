// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The user's choice of units and sign convention. Sections and charts are first built
// in engineering units (mm, kN, MPa) with compression positive; the functions here
// convert them to SI base units or to tension positive. Colours do not change, because
// they depend on the values, not on how these are written.
#pragma once

#include <string>
#include <string_view>

namespace keyblock {

struct Chart;
struct SectionPicture;

struct ShownNumbers {
    bool si = false;  // use m, N, Pa and J
    bool tensionPositive = false;  // for stresses of blocks

    bool operator==(const ShownNumbers&) const = default;
};

/// How a quantity is displayed: displayed value = factor · value in engineering units.
struct ShownAs {
    std::string unit, convention;
    double factor = 1.0;
};

/// How a quantity is displayed. \param unit its engineering unit, such as `MPa` or `kN per bolt`. \param convention its
/// sign convention.
ShownAs shownAs(std::string_view unit, std::string_view convention, const ShownNumbers& numbers);

/// `value`, or 0 if its magnitude is so small that it may be due to round-off alone. \param unit engineering unit or SI
/// base unit of the value.
double withoutRoundOff(double value, std::string_view unit);

/// Conversion factor from the unit at the end of a title such as `Axial force (kN)` to the unit that is displayed; 1 if
/// both units are the same.
double factorOf(std::string title, const ShownNumbers& numbers);

/// Converts the units in a title, e.g. from `Axial force (kN) against joint opening (mm)` to `… (N) against … (m)`.
std::string shownTitle(const std::string& title, const ShownNumbers& numbers);

std::string forceText(double force, const ShownNumbers& numbers);  // force [N] with its unit: `119 kN`
std::string lengthText(double length, const ShownNumbers& numbers);  // length [m] with its unit: `31 mm`

/// Converts drawing data in place, from engineering units to the units and the sign convention of `numbers`. \pre the
/// data have not been converted before.
void showAs(SectionPicture& picture, const ShownNumbers& numbers);
void showAs(Chart& chart, const ShownNumbers& numbers);

}  // namespace keyblock
