// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Distribution of the bolts of a pattern along part of a wall: with the given spacing
// from its start, with the given spacing and centred, or a given number of bolts from
// end to end. The scene stores only the resulting spacing and offset.
#pragma once

namespace keyblock {

enum class PatternFit { FromStart, Centred, EndToEnd };

struct PatternPlaces {
    double spacing = 1.0, offset = 0.0;  // [m]
};

/// Spacing and offset of the bolts after fitting.
/// \param given spacing and offset set by the user
/// \param bolts number of bolts, at least 1; used only if `fit` is `EndToEnd`
/// \param run length of the part of the wall along which the bolts are placed [m]
/// \param isClosed true if this part is the whole wall, so that its ends coincide
PatternPlaces fitted(PatternFit fit, const PatternPlaces& given, int bolts, double run, bool isClosed);

}  // namespace keyblock
