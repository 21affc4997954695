// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Independent reference values against which the program is checked. They come from
// calculations that share no code with the engine (tests/verify/reference), for bolts
// from one that steps exactly from event to event; tests recompute them with these
// calculations. Rock is rigid unless stated otherwise, bars are linear or piecewise
// linear, SI units throughout.
#pragma once

#include <array>
#include <optional>
#include <vector>

namespace keyblock {

/// A release in the reference solution: the index of the node, starting with 0 at the far end, and the opening [m] and
/// joint force [N] just before the release.
struct ReferenceRelease {
    int node = 0;
    double opening = 0.0;
    double load = 0.0;
};

/// Releases, in chronological order, of the paper's rebar with a brittle bond and E = 200 GPa. The joint is in the
/// middle of an element.
inline const std::vector<ReferenceRelease> brittleDebonding{
    {29, 0.64768e-3, 128.734691e3}, {30, 0.70975e-3, 128.734691e3}, {28, 0.78546e-3, 130.974229e3},
    {31, 0.84753e-3, 130.974229e3}, {27, 0.92561e-3, 133.213523e3}, {32, 0.98768e-3, 133.213523e3},
    {26, 1.06814e-3, 135.452444e3}, {33, 1.13021e-3, 135.452444e3}, {25, 1.21304e-3, 137.690798e3},
    {34, 1.27511e-3, 137.690798e3}, {24, 1.36031e-3, 139.928283e3}, {35, 1.42238e-3, 139.928283e3},
    {23, 1.50994e-3, 142.164443e3}, {36, 1.57201e-3, 142.164443e3}, {22, 1.66192e-3, 144.398579e3},
    {37, 1.72400e-3, 144.398579e3}, {21, 1.81624e-3, 146.629625e3}, {38, 1.87832e-3, 146.629625e3},
    {20, 1.97287e-3, 148.855952e3}, {39, 2.03496e-3, 148.855952e3}, {19, 2.13177e-3, 151.075076e3},
    {40, 2.19387e-3, 151.075076e3}, {18, 2.29286e-3, 153.283203e3}, {41, 2.35498e-3, 153.283203e3},
    {17, 2.45604e-3, 155.474548e3}, {42, 2.51819e-3, 155.474548e3}, {16, 2.62113e-3, 157.640285e3},
    {43, 2.68333e-3, 157.640285e3}, {15, 2.78784e-3, 159.766971e3}, {44, 2.85010e-3, 159.766971e3},
    {14, 2.95570e-3, 161.834143e3}, {45, 3.01807e-3, 161.834143e3}, {13, 3.12399e-3, 163.810713e3},
    {46, 3.18652e-3, 163.810713e3}, {12, 3.29154e-3, 165.649582e3}, {47, 3.35431e-3, 165.649582e3},
    {11, 3.45652e-3, 167.279684e3}, {48, 3.51966e-3, 167.279684e3}, {10, 3.61605e-3, 168.594485e3},
    {49, 3.67977e-3, 168.594485e3}, {9, 3.76570e-3, 169.435824e3}, {50, 3.83031e-3, 169.435824e3},
    {8, 3.89868e-3, 169.572432e3}, {7, 3.93940e-3, 168.673943e3}, {6, 3.93940e-3, 166.303380e3},
    {5, 3.93940e-3, 163.868920e3}, {4, 3.93940e-3, 161.254310e3}, {3, 3.93940e-3, 158.246230e3},
    {2, 3.93940e-3, 154.393202e3}, {1, 3.93940e-3, 148.511601e3}, {0, 3.93940e-3, 136.071170e3}};

/// Reference values for a debonding rebar: joint force and opening at the first release and at the largest joint force,
/// opening at the last release, and number of releases.
struct RebarReference {
    const char* title;
    double youngsModulus, peak;  // [Pa], peak bond force per node [N]
    int divisions;  // 59: joint in an element, 60: joint at a node
    double firstLoad, firstOpening, largestLoad, largestOpening, lastOpening;  // [N], [m]
    int releases;
};

inline constexpr double rebarResidual = 67.2e3;  // [N] 30 nodes with 2.24 kN each

inline constexpr std::array<RebarReference, 6> rebarReferences{{
    {"stated parameters", 213.043e9, 24.56e3, 59, 132430.7, 0.645337e-3, 172451.9, 3.632214e-3, 3.724503e-3, 50},
    {"reading (a)", 177e9, 24.56e3, 59, 121913.7, 0.652464e-3, 164269.1, 4.193304e-3, 4.270694e-3, 51},
    {"reading (b)", 215.8e9, 22.32e3, 59, 121049.1, 0.586056e-3, 161424.6, 3.430553e-3, 3.462620e-3, 51},
    {"stated parameters", 213.043e9, 24.56e3, 60, 132430.7, 0.711293e-3, 172451.9, 3.718101e-3, 3.809728e-3, 50},
    {"reading (a)", 177e9, 24.56e3, 60, 121913.7, 0.725545e-3, 164269.1, 4.291776e-3, 4.367962e-3, 51},
    {"reading (b)", 215.8e9, 22.32e3, 60, 121049.1, 0.645573e-3, 161424.6, 3.509922e-3, 3.541515e-3, 51},
}};

/// Nodes in the order in which they are released: alternately on the two sides of the joint, then only on the side of
/// the far end, until the far end itself is released.
/// \param divisions 59 or 60. \param releases 50 or 51.
std::vector<int> rebarOrder(int divisions, int releases);

/// Reference values for a D-bolt: joint force and opening at yield and at rupture, and joint force at openings of 50 mm
/// and 100 mm.
struct DBoltReference {
    const char* title;
    bool tableSteel, plate;
    double yieldLoad, yieldOpening, loadAt50, loadAt100, ruptureOpening, ruptureLoad;  // [N], [m]
};

inline constexpr std::array<DBoltReference, 4> dBoltReferences{{
    {"text's steel, plate", false, true, 153938.0, 3.8004e-3, 179338.0, 195076.0, 130.521e-3, 197920.0},
    {"text's steel, no plate", false, false, 153938.0, 4.0538e-3, 179208.0, 195013.0, 130.846e-3, 197920.0},
    {"table's steel, plate", true, true, 159907.0, 3.9589e-3, 183557.0, 199480.0, 194.608e-3, 204518.0},
    {"table's steel, no plate", true, false, 159907.0, 4.2211e-3, 183359.0, 199426.0, 194.943e-3, 204518.0},
}};

/// Reference values for a rebar with an elastic bond under 200 kN. `stiffness` is the bond stiffness per node,
/// `largestAnchor` is the largest bond force of a node, and `force20` is the axial force in the element that begins at
/// node 20. The Young's modulus of the rock is 6e13 Pa, because with a stiff bond even small strains of the rock affect
/// the plate force (at 60 GPa, the three plate forces are 17321, 690.2 and 47.7 N).
struct ElasticRebarReference {
    double stiffness, opening, plate, largestAnchor, force20;  // [N/m], [m], [N]
};

inline constexpr std::array<ElasticRebarReference, 3> elasticRebarReferences{{
    {20e6, 2.104470e-3, 17295.62, 19130.00, 80301.68},
    {84.78e6, 1.076890e-3, 641.553, 37166.59, 31432.94},
    {300e6, 0.626213e-3, 2.4980, 63914.11, 6252.85},
}};

/// Reference values for shear lag under 200 kN without a plate: slip at the joint, and axial forces at 0.25 m and 0.5 m
/// from the joint. There are `perSide` springs on each side of the joint, each in the middle of its tributary length.
struct ShearLagReference {
    int perSide;
    double slip, quarter, half;  // [m], [N]
};

inline constexpr std::array<ShearLagReference, 3> shearLagReferences{{
    {20, 1.641884e-3, 117145.1, 64531.6},
    {40, 1.640255e-3, 117129.5, 64515.9},
    {80, 1.639847e-3, 117125.6, 64512.0},
}};

/// Reference values for a load of 2 kN: joint opening without and with a rigid plate, and the plate force. The bond is
/// that of `ShearLagReference`, but its stiffness is given per unit length.
struct PlateLagReference {
    int divisions;
    double openingWithout, openingWith, plate;  // [m], [m], [N]
};

inline constexpr std::array<PlateLagReference, 2> plateLagReferences{{
    {41, 32.83558514e-6, 31.70033588e-6, 526.547859},
    {81, 32.80482760e-6, 31.67195364e-6, 525.772895},
}};

/// Thrust and lever arm, for small displacements, of a voussoir beam of 10 m span and 0.5 m depth with E = 10 GPa,
/// ν = 0.25 and a unit weight of 25 kN/m³. They were computed with 64 rows of bilinear finite elements. The thrust
/// differs by less than 0.1 % from the thrust computed with 32 rows.
struct VoussoirReference {
    double thrust, arm;  // [N], [m]
};

inline constexpr VoussoirReference voussoirReference{355.138e3, 0.43997};

}  // namespace keyblock
