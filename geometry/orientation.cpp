// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The determinant in double precision decides unless it is within its error bound (Shewchuk 1997, stage A). Otherwise
// its six products are computed exactly, each as a double and its round-off error, and all twelve numbers are summed
// exactly.
#include "geometry/orientation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace keyblock {
namespace {

/// A sum of doubles stored as non-overlapping parts, the smallest first.
class ExactSum {
public:
    void addProduct(double a, double b) {
        const double product = a * b;
        add(std::fma(a, b, -product));
        add(product);
    }

    /// The largest part decides the sign.
    int sign() const {
        for (int i = count_ - 1; i >= 0; --i)
            if (parts_[i] != 0.0) return parts_[i] > 0.0 ? 1 : -1;
        return 0;
    }

private:
    void add(double value) {
        for (int i = 0; i < count_; ++i) {
            double& part = parts_[i];
            const double sum = value + part, shift = sum - value;
            part = (value - (sum - shift)) + (part - shift);  // round-off error of the sum
            value = sum;
        }
        parts_[count_++] = value;
    }

    std::array<double, 12> parts_{};
    int count_ = 0;
};

int exactOrientation(const Point& a, const Point& b, const Point& c) {
    ExactSum sum;
    sum.addProduct(a.x(), b.y());
    sum.addProduct(-a.y(), b.x());
    sum.addProduct(b.x(), c.y());
    sum.addProduct(-b.y(), c.x());
    sum.addProduct(c.x(), a.y());
    sum.addProduct(-c.y(), a.x());
    return sum.sign();
}

}  // namespace

int orientation(const Point& a, const Point& b, const Point& c) {
    const double left = (a.x() - c.x()) * (b.y() - c.y()), right = (a.y() - c.y()) * (b.x() - c.x());
    const double det = left - right;
    const double bound = 2.0 * std::numeric_limits<double>::epsilon() * (std::abs(left) + std::abs(right));
    if (std::abs(det) > bound) return det > 0.0 ? 1 : -1;
    return exactOrientation(a, b, c);
}

bool segmentsMeet(const Point& a, const Point& b, const Point& c, const Point& d) {
    for (int axis = 0; axis < 2; ++axis)
        if (std::max(a[axis], b[axis]) < std::min(c[axis], d[axis]) ||
            std::max(c[axis], d[axis]) < std::min(a[axis], b[axis]))
            return false;
    if (orientation(a, b, c) * orientation(a, b, d) > 0) return false;
    return orientation(c, d, a) * orientation(c, d, b) <= 0;
}

}  // namespace keyblock
