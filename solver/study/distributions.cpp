// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/study/distributions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace keyblock {

namespace {

/// Natural logarithm by its series, from operations that IEEE 754 defines to the last digit. \pre x > 0
double exactLog(double x) {
    int exponent = 0;
    double m = std::frexp(x, &exponent);  // 0.5 … 1, exact
    if (m < std::numbers::sqrt2 / 2.0) {
        m *= 2.0;
        --exponent;
    }
    const double t = (m - 1.0) / (m + 1.0), square = t * t;  // ln m = 2 artanh t, |t| < 0.172
    double sum = 0.0;
    for (int n = 21; n >= 1; n -= 2) sum = sum * square + 1.0 / n;
    return 2.0 * t * sum + exponent * std::numbers::ln2;
}

using Coefficients = std::array<double, 8>;

double ratio(const Coefficients& a, const Coefficients& b, double x) {
    double top = a[7], bottom = b[7];
    for (int i = 6; i >= 0; --i) {
        top = top * x + a[i];
        bottom = bottom * x + b[i];
    }
    return top / bottom;
}

// Wichura, M. J. (1988), Algorithm AS 241, Applied Statistics 37, 477–484: PPND16.
constexpr Coefficients middleTop{3.3871328727963666080e0, 1.3314166789178437745e2, 1.9715909503065514427e3,
                                 1.3731693765509461125e4, 4.5921953931549871457e4, 6.7265770927008700853e4,
                                 3.3430575583588128105e4, 2.5090809287301226727e3};
constexpr Coefficients middleBottom{1.0,
                                    4.2313330701600911252e1,
                                    6.8718700749205790830e2,
                                    5.3941960214247511077e3,
                                    2.1213794301586595867e4,
                                    3.9307895800092710610e4,
                                    2.8729085735721942674e4,
                                    5.2264952788528545610e3};
constexpr Coefficients tailTop{1.42343711074968357734e0,  4.63033784615654529590e0, 5.76949722146069140550e0,
                               3.64784832476320460504e0,  1.27045825245236838258e0, 2.41780725177450611770e-1,
                               2.27238449892691845833e-2, 7.74545014278341407640e-4};
constexpr Coefficients tailBottom{1.0,
                                  2.05319162663775882187e0,
                                  1.67638483018380384940e0,
                                  6.89767334985100004550e-1,
                                  1.48103976427480074590e-1,
                                  1.51986665636164571966e-2,
                                  5.47593808499534494600e-4,
                                  1.05075007164441684324e-9};
constexpr Coefficients farTop{6.65790464350110377720e0,  5.46378491116411436990e0,  1.78482653991729133580e0,
                              2.96560571828504891230e-1, 2.65321895265761230930e-2, 1.24266094738807843860e-3,
                              2.71155556874348757815e-5, 2.01033439929228813265e-7};
constexpr Coefficients farBottom{1.0,
                                 5.99832206555887937690e-1,
                                 1.36929880922735805310e-1,
                                 1.48753612908506148525e-2,
                                 7.86869131145613259100e-4,
                                 1.84631831751005468180e-5,
                                 1.42151175831644588870e-7,
                                 2.04426310338993978564e-15};

struct LogMoments {
    double mean = 0.0, deviation = 0.0;  // of the logarithm
};

LogMoments logMoments(const StudyDistribution& d) {
    const double ratio = *d.deviation / *d.mean;
    const double variance = std::log1p(ratio * ratio);
    return {std::log(*d.mean) - 0.5 * variance, std::sqrt(variance)};
}

double triangularShare(const StudyDistribution& d, double x) {
    const double a = *d.least, b = *d.most, c = *d.peak;
    if (x <= a) return 0.0;
    if (x >= b) return 1.0;
    return x < c ? (x - a) * (x - a) / ((b - a) * (c - a)) : 1.0 - (b - x) * (b - x) / ((b - a) * (b - c));
}

double triangularQuantile(const StudyDistribution& d, double u) {
    const double a = *d.least, b = *d.most, c = *d.peak;
    const double left = (c - a) / (b - a);
    return u < left ? a + std::sqrt(u * (b - a) * (c - a)) : b - std::sqrt((1.0 - u) * (b - a) * (b - c));
}

/// Share below x without truncation.
double wholeShare(const StudyDistribution& d, double x) {
    switch (d.kind) {
        case DistributionKind::Normal: return normalShare((x - *d.mean) / *d.deviation);
        case DistributionKind::Lognormal: {
            if (x <= 0.0) return 0.0;
            const LogMoments log = logMoments(d);
            return normalShare((std::log(x) - log.mean) / log.deviation);
        }
        case DistributionKind::Triangular: return triangularShare(d, x);
        default: return std::clamp((x - *d.least) / (*d.most - *d.least), 0.0, 1.0);
    }
}

/// Quantile without truncation.
double wholeQuantile(const StudyDistribution& d, double u) {
    switch (d.kind) {
        case DistributionKind::Normal: return *d.mean + *d.deviation * normalQuantile(u);
        case DistributionKind::Lognormal: {
            const LogMoments log = logMoments(d);
            return std::exp(log.mean + log.deviation * normalQuantile(u));
        }
        case DistributionKind::Triangular: return triangularQuantile(d, u);
        default: return *d.least + u * (*d.most - *d.least);
    }
}

bool isTruncated(const StudyDistribution& d) {
    const bool unbounded = d.kind == DistributionKind::Normal || d.kind == DistributionKind::Lognormal;
    return unbounded && (d.least || d.most);
}

}  // namespace

double normalQuantile(double p) {
    const double q = p - 0.5;
    if (std::abs(q) <= 0.425) return q * ratio(middleTop, middleBottom, 0.180625 - q * q);
    const double r = std::sqrt(-exactLog(q < 0.0 ? p : 1.0 - p));
    const double z = r <= 5.0 ? ratio(tailTop, tailBottom, r - 1.6) : ratio(farTop, farBottom, r - 5.0);
    return q < 0.0 ? -z : z;
}

double normalShare(double z) { return 0.5 * std::erfc(-z / std::numbers::sqrt2); }

double quantileOf(const StudyDistribution& d, double u) {
    if (!isTruncated(d)) return wholeQuantile(d, u);
    const double low = d.least ? wholeShare(d, *d.least) : 0.0, high = d.most ? wholeShare(d, *d.most) : 1.0;
    constexpr double tiny = std::numeric_limits<double>::min();
    const double share = std::clamp(low + u * (high - low), tiny, 1.0 - 0x1p-53);
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return std::clamp(wholeQuantile(d, share), d.least.value_or(-infinity), d.most.value_or(infinity));
}

double shareBelow(const StudyDistribution& d, double x) {
    const double share = wholeShare(d, x);
    if (!isTruncated(d)) return share;
    const double low = d.least ? wholeShare(d, *d.least) : 0.0, high = d.most ? wholeShare(d, *d.most) : 1.0;
    return std::clamp((share - low) / (high - low), 0.0, 1.0);
}

}  // namespace keyblock
