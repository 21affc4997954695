// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/pattern_fit.h"

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

constexpr double roundedTo = 1e-6;  // [m] spacings and offsets are rounded to it, so that files have short numbers
constexpr double together = 1e-9;  // of the run

/// Rounds down, because the last bolt must not be beyond the end.
double roundedDown(double metres) { return std::floor(metres / roundedTo) * roundedTo; }

}  // namespace

PatternPlaces fitted(PatternFit fit, const PatternPlaces& given, int bolts, double run, bool isClosed) {
    if (fit == PatternFit::FromStart || !(given.spacing > 0.0) || !(run > 0.0)) return given;
    if (fit == PatternFit::Centred) {
        const double intervals = std::floor(run * (1.0 + together) / given.spacing);
        if (isClosed) return {given.spacing, 0.0};  // a ring has no ends
        return {given.spacing, std::max(0.0, roundedDown(0.5 * (run - intervals * given.spacing)))};
    }
    const int intervals = isClosed ? bolts : bolts - 1;
    if (intervals < 1) return {run, roundedDown(0.5 * run)};  // one bolt, centred
    return {std::max(roundedTo, roundedDown(run / intervals)), 0.0};
}

}  // namespace keyblock
