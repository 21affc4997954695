// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/verify/reference/hinged_arch.h"

#include <cmath>
#include <complex>
#include <numbers>
#include <optional>

namespace keyblock::reference {
namespace {

using Place = std::complex<double>;  // x + iy; a turn at the rate w about o moves p by i·w·(p − o)

constexpr Place i(0.0, 1.0);
constexpr double roundOff = 1e-12;

double cross(const Place& a, const Place& b) { return (std::conj(a) * b).imag(); }

/// Centroid of a voussoir, on its axis of symmetry: that of the trapezium between its two chords.
Place centroidOf(const Arch& arch, int voussoir) {
    const double half = 0.5 * std::numbers::pi / arch.voussoirs;
    const double inner = arch.mean - 0.5 * arch.thickness, outer = arch.mean + 0.5 * arch.thickness;
    const double height = (outer - inner) * std::cos(half);
    const double above = height / 3.0 * (inner + 2.0 * outer) / (inner + outer);
    return std::polar(inner * std::cos(half) + above, (2 * voussoir + 1) * half);
}

struct Mechanism {
    std::array<int, 4> joints{};
    std::array<bool, 4> atIntrados{};
    std::array<Place, 4> hinges{};

    Mechanism(const Arch& arch, const std::array<int, 4>& at, unsigned sides) : joints(at) {
        for (std::size_t n = 0; n < 4; ++n) {
            atIntrados[n] = (sides >> n & 1u) != 0;
            const double radius = arch.mean + (atIntrados[n] ? -0.5 : 0.5) * arch.thickness;
            hinges[n] = std::polar(radius, std::numbers::pi * joints[n] / arch.voussoirs);
        }
    }

    /// Where the lines through the outer pairs of hinges meet: the middle link turns about it.
    std::optional<Place> pole() const {
        const Place right = hinges[1] - hinges[0], left = hinges[3] - hinges[2];
        const double between = cross(right, left);
        if (std::abs(between) < roundOff) return std::nullopt;
        return hinges[0] + cross(hinges[2] - hinges[0], left) / between * right;
    }

    /// Every joint opens at the side where it has no hinge.
    bool opens(const std::array<double, 5>& rates) const {
        for (std::size_t n = 0; n < 4; ++n)
            if ((rates[n + 1] - rates[n]) * (atIntrados[n] ? 1.0 : -1.0) < -roundOff) return false;
        return true;
    }

    /// Motion of all voussoirs together where the middle link turns at the rate `middle`; none where a joint would close.
    std::optional<Place> motion(const Arch& arch, double middle) const {
        const std::optional<Place> about = pole();
        if (!about) return std::nullopt;
        const auto rate = [&](std::size_t near, std::size_t support) {
            return (middle * (hinges[near] - *about) / (hinges[near] - hinges[support])).real();
        };
        const double right = rate(1, 0), left = rate(2, 3);
        if (!opens({0.0, right, middle, left, 0.0})) return std::nullopt;
        Place sum = 0.0;
        for (int v = joints[0]; v < joints[3]; ++v) {
            const Place at = centroidOf(arch, v);
            sum += v < joints[1] ? i * right * (at - hinges[0]) : v < joints[2] ? i * middle * (at - *about) : i * left * (at - hinges[3]);
        }
        return sum;
    }
};

}  // namespace

ArchCollapse collapseOf(const Arch& arch) {
    ArchCollapse least{0.5 * std::numbers::pi, {}, {}};
    std::array<int, 4> at{};
    for (at[0] = 0; at[0] <= arch.voussoirs; ++at[0])
        for (at[1] = at[0] + 1; at[1] <= arch.voussoirs; ++at[1])
            for (at[2] = at[1] + 1; at[2] <= arch.voussoirs; ++at[2])
                for (at[3] = at[2] + 1; at[3] <= arch.voussoirs; ++at[3])
                    for (unsigned sides = 0; sides < 16; ++sides)
                        for (const double middle : {-1.0, 1.0}) {
                            const Mechanism mechanism(arch, at, sides);
                            const std::optional<Place> moved = mechanism.motion(arch, middle);
                            if (!moved || moved->real() <= roundOff) continue;  // weight tilts towards +x
                            const double tilt = std::atan2(moved->imag(), moved->real());
                            if (tilt < least.tilt) least = {tilt, at, mechanism.atIntrados};
                        }
    return least;
}

}  // namespace keyblock::reference
