// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random numbers that are the same on every machine, so that a seed in a scene
// file names one geometry. The standard library fixes its engines but not its
// distributions; here both are ours. A stream is named by the seed and a few
// whole numbers (a line, a piece on it), so that what one line draws does not
// hang on how many others were drawn before.
#pragma once

#include <cstdint>
#include <initializer_list>

namespace keyblock {

/// SplitMix64 (Steele, Lea and Flood 2014): a counter that rises by 2⁶⁴ over the golden ratio, its bits mixed.
class Random {
public:
    /// The stream of `seed` with this name; another name gives numbers that have nothing to do with these.
    explicit Random(std::uint64_t seed, std::initializer_list<std::int64_t> name = {});

    std::uint64_t bits();

    /// Evenly spread over [0, 1), a multiple of 2⁻⁵³.
    double uniform();

    /// Mean 0, standard deviation 1, by the polar method: exact but for the last digits of one logarithm.
    double normal();

    /// As `normal`, drawn again until no farther from 0 than `cut`. \pre cut is not much below 1.
    double normalWithin(double cut);

private:
    std::uint64_t counter_ = 0;
};

/// A positive length that scatters about a mean.
struct Scatter {
    double mean = 0.0;  // [m]
    double deviation = 0.0;  // standard deviation [m]; 0: always the mean
};

/// Draws beyond this many standard deviations are drawn again.
inline constexpr double scatterCut = 3.0;

/// A draw from the log-normal distribution with this mean and standard deviation, its normal variable cut at
/// `scatterCut`. The mean is kept in spite of the cut; the deviation comes out smaller: by 1.3 % where it is a
/// small share of the mean, by 6.8 % where it equals the mean. \pre mean > 0, deviation >= 0.
double draw(Random& random, const Scatter& scatter);

/// The largest value `draw` can give [m]; 0 of a mean of 0.
double largest(const Scatter& scatter);

}  // namespace keyblock
