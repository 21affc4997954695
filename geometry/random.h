// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Random numbers that are the same on every machine, so that a seed in a scene file
// always gives the same geometry. The standard library specifies its engines but not
// its distributions, so both are implemented here. A stream is identified by the seed
// and a few integers (a line, a trace on it), so that the numbers for one line do not
// depend on how many others were generated before.
#pragma once

#include <cstdint>
#include <initializer_list>

namespace keyblock {

/// SplitMix64 generator (Steele, Lea and Flood 2014): the mixed bits of a counter with an increment of 2⁶⁴ divided by
/// the golden ratio.
class Random {
public:
    /// Starts the stream with this seed and name. Streams with different names are independent of each other.
    explicit Random(std::uint64_t seed, std::initializer_list<std::int64_t> name = {});

    std::uint64_t bits();

    /// Uniformly distributed in [0, 1), a multiple of 2⁻⁵³.
    double uniform();

    /// Normally distributed with mean 0 and standard deviation 1, by the polar method. Because it uses a logarithm,
    /// results can differ in the last digits between machines.
    double normal();

    /// Like `normal`, but truncated: values are drawn until the absolute value of one is at most `cut`. \pre cut is not
    /// much below 1.
    double normalWithin(double cut);

private:
    std::uint64_t counter_ = 0;
};

/// A positive random length with a mean and a standard deviation.
struct Scatter {
    double mean = 0.0;  // [m]
    double deviation = 0.0;  // standard deviation [m]; 0: always the mean
};

/// Number of standard deviations at which distributions are truncated.
inline constexpr double scatterCut = 3.0;

/// A random value of the log-normal distribution with this mean and standard deviation, whose normal variable is
/// truncated at `scatterCut`. The truncation does not change the mean but reduces the standard deviation: by 1.3 % if
/// it is a small fraction of the mean, by 6.8 % if it equals the mean.
/// \pre deviation >= 0; mean > 0 unless deviation is 0.
double draw(Random& random, const Scatter& scatter);

/// Largest value [m] that `draw` can return; 0 for a mean of 0.
double largest(const Scatter& scatter);

}  // namespace keyblock
