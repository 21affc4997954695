// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How bolts of a pattern are distributed along part of a wall: from its start at the
// given spacing, the same centred, or a number of bolts from end to end. The scene
// stores only the resulting spacing and offset.
#pragma once

namespace keyblock {

enum class PatternFit { FromStart, Centred, EndToEnd };

struct PatternPlaces {
    double spacing = 1.0, offset = 0.0;  // [m]
};

/// \param given spacing and offset set by the user. \param bolts number from end to end; at least 1.
/// \param run length of the wall [m]. \param isClosed it is the whole wall, whose ends coincide.
PatternPlaces fitted(PatternFit fit, const PatternPlaces& given, int bolts, double run, bool isClosed);

}  // namespace keyblock
