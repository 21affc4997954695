// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// How bolts of a pattern are shared out over a part of a wall: from its beginning at
// the given spacing, the same with equal rests at both ends, or a number of bolts
// from end to end. The scene keeps only the spacing and the offset that follow.
#pragma once

namespace keyblock {

enum class PatternFit { FromStart, Centred, EndToEnd };

struct PatternPlaces {
    double spacing = 1.0, offset = 0.0;  // [m]
};

/// \param given spacing and offset as the user wants them. \param bolts from end to end; not fewer than 1.
/// \param run length of the wall [m]. \param isClosed it is the whole wall, whose ends are one place.
PatternPlaces fitted(PatternFit fit, const PatternPlaces& given, int bolts, double run, bool isClosed);

}  // namespace keyblock
