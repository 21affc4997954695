// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A study: one scene that is run many times with different values. It is a plain
// value, read from a file through a field table like a scene.
#pragma once

#include "geometry/point.h"

#include <optional>
#include <string>
#include <vector>

namespace keyblock {

enum class PlanKind { FullFactorial, LatinHypercube, MonteCarlo };
enum class DistributionKind { Uniform, Triangular, Normal, Lognormal, Seed };
enum class FaultKind { Missing, BondLost, Misplaced };
enum class BondLossPlace { Anywhere, FarEnd, Head };
enum class KeptStores { All, Thin, None };

/// How the cases of a study are chosen.
struct StudyPlan {
    PlanKind kind = PlanKind::MonteCarlo;
    std::optional<int> cases;  // null: all combinations of a full factorial plan
    int seed = 1;
    std::optional<int> casesPerTask;  // cases that one task of a job array runs; null: at most 1000 tasks

    bool operator==(const StudyPlan&) const = default;
};

/// Equally spaced values, both ends included.
struct StudyRange {
    double from = 0.0, to = 0.0;
    int count = 2;

    bool operator==(const StudyRange&) const = default;
};

struct StudyDistribution {
    DistributionKind kind = DistributionKind::Uniform;
    std::optional<double> mean, deviation;  // of normal and lognormal, before they are truncated
    std::optional<double> least, most;  // bounds; of normal and lognormal null: not truncated
    std::optional<double> peak;  // of triangular

    bool operator==(const StudyDistribution&) const = default;
};

/// A value of the scene that varies: one of a list, of a range or of a distribution.
struct StudyParameter {
    std::string name;  // empty: the path
    std::string path;  // as for `--set`
    std::vector<std::string> also;  // further paths that get the same value; seeds differ
    std::vector<std::string> values;  // as JSON texts
    std::optional<StudyRange> range;
    std::optional<StudyDistribution> distribution;

    bool operator==(const StudyParameter&) const = default;
};

/// A fault of installation that each of some bolts may have, independently of the others.
struct StudyFault {
    std::string name;
    FaultKind kind = FaultKind::Missing;
    std::vector<std::string> bolts;  // bolts and patterns; empty: all
    double probability = 1.0;
    Point share{0.0, 0.0};  // least and most share of the length without bond
    BondLossPlace where = BondLossPlace::Anywhere;
    double offsetDeviation = 0.0;  // [m] at right angles to the bolt
    double angleDeviation = 0.0;  // [°]

    bool operator==(const StudyFault&) const = default;
};

struct Study {
    std::string title;
    std::string scene;  // path of the scene, relative to the study file
    StudyPlan plan;
    std::vector<StudyParameter> parameters;
    std::vector<StudyFault> faults;
    std::vector<std::string> quantities;  // empty: those of the scene
    std::string fails;  // criterion of failure; empty: none
    bool safety = false;  // also find the factor of safety of each case
    KeptStores keep = KeptStores::None;  // run stores of finished cases

    bool operator==(const Study&) const = default;
};

}  // namespace keyblock
