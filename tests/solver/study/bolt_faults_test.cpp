// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Faults of bolts of a drift whose bolts are a pattern: the scene with faults is valid,
// and each fault does what it says.
#include "solver/study/bolt_faults.h"

#include "geometry/polygon.h"
#include "solver/run/run.h"
#include "solver/scene/lookup.h"
#include "solver/scene/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>

namespace keyblock {
namespace {

const SceneReading& drift() {
    static const std::vector<std::string> grouted{"bolt_patterns[0].type=rebar-20"};
    static const SceneReading read = readSceneFile(std::filesystem::path(KEYBLOCK_SAMPLES_DIR) / "drift-bolted.json",
                                                   grouted);
    return read;
}

StudyFault faultOf(FaultKind kind, double probability = 1.0) {
    StudyFault fault;
    fault.kind = kind;
    fault.probability = probability;
    return fault;
}

Study studyWithFault(StudyFault fault) {
    Study study;
    fault.name = "fault";
    study.faults.push_back(std::move(fault));
    return study;
}

/// The scene with the faults of a case, read again as a file would be.
SceneReading faulty(const Study& study, long number, std::vector<BoltFault>& faults) {
    faults = faultsOf(study, number, drift());
    SceneReading read = readSceneText(wholeSceneText(withFaults(drift(), faults)), "faulty", {}, std::nullopt);
    for (const Problem& problem : read.problems)
        if (problem.severity == Severity::Error) ADD_FAILURE() << oneLine(problem);
    return read;
}

const Bolt& boltOf(const SceneReading& read, const std::string& name) {
    const std::vector<Bolt>& bolts = read.cut ? read.cut->scene.bolts : read.scene->bolts;
    return *std::ranges::find(bolts, name, &Bolt::name);
}

double bondedLength(const Scene& scene, const Bolt& bolt) {
    double bonded = 0.0;
    for (const Anchor& anchor : anchorsOf(scene, bolt))
        if (!anchor.at) bonded += distanceAlong(anchor.to, lengthOf(bolt)) - distanceAlong(anchor.from, lengthOf(bolt));
    return bonded;
}

TEST(BoltFaults, MissingBoltsOccurWithTheirProbabilityAndAreNeverInstalled) {
    ASSERT_TRUE(drift().scene && drift().cut);
    const std::size_t bolts = drift().cut->scene.bolts.size();
    ASSERT_GE(bolts, 4u);
    const Study study = studyWithFault(faultOf(FaultKind::Missing, 0.3));
    long missing = 0;
    constexpr long cases = 2000;
    for (long number = 1; number <= cases; ++number)
        missing += static_cast<long>(faultsOf(study, number, drift()).size());
    const double n = static_cast<double>(cases) * static_cast<double>(bolts);
    EXPECT_NEAR(static_cast<double>(missing) / n, 0.3, 4.0 * std::sqrt(0.3 * 0.7 / n));

    std::vector<BoltFault> faults;
    long number = 1;
    while (faultsOf(study, number, drift()).empty()) ++number;
    const SceneReading read = faulty(study, number, faults);
    ASSERT_TRUE(read.scene);
    EXPECT_TRUE(read.scene->boltPatterns.empty());
    for (const BoltFault& fault : faults) {
        EXPECT_EQ(std::ranges::count(read.scene->stages.front().remove, fault.bolt), 1);
        for (const Stage& stage : read.scene->stages) EXPECT_EQ(std::ranges::count(stage.install, fault.bolt), 0);
    }
    EXPECT_EQ(faultMeasures(study, faults, drift()), std::vector<double>{static_cast<double>(faults.size())});
}

TEST(BoltFaults, BondIsLostOnItsShareOfTheLength) {
    for (const BondLossPlace where : {BondLossPlace::Anywhere, BondLossPlace::FarEnd, BondLossPlace::Head}) {
        StudyFault fault = faultOf(FaultKind::BondLost);
        fault.share = Point(0.2, 0.6);
        fault.where = where;
        std::vector<BoltFault> faults;
        const SceneReading read = faulty(studyWithFault(fault), 7, faults);
        ASSERT_TRUE(read.scene);
        ASSERT_EQ(faults.size(), drift().cut->scene.bolts.size());
        for (const BoltFault& one : faults) {
            const Bolt& bolt = boltOf(read, one.bolt);
            const double length = lengthOf(bolt);
            EXPECT_GE(one.share, 0.2);
            EXPECT_LE(one.share, 0.6);
            EXPECT_NEAR(one.to - one.from, one.share * length, 1e-12);
            if (where == BondLossPlace::FarEnd) {
                EXPECT_EQ(one.from, 0.0);
            }
            if (where == BondLossPlace::Head) {
                EXPECT_NEAR(one.to, length, 1e-12);
            }
            EXPECT_NEAR(bondedLength(*read.scene, bolt), length - (one.to - one.from), 1e-9);
        }
    }
}

TEST(BoltFaults, MisplacedBoltsKeepTheirLengthAndStartAtTheWall) {
    StudyFault fault = faultOf(FaultKind::Misplaced);
    fault.offsetDeviation = 0.1;
    fault.angleDeviation = 5.0;
    const std::vector<Point> wall = outline(tunnelProfile(shapeOf(drift().scene->tunnels.front())));
    std::vector<BoltFault> faults;
    const SceneReading read = faulty(studyWithFault(fault), 3, faults);
    ASSERT_TRUE(read.scene);
    for (const BoltFault& one : faults) {
        const Bolt &was = boltOf(drift(), one.bolt), &is = boltOf(read, one.bolt);
        EXPECT_NEAR(lengthOf(is), lengthOf(was), 1e-12);
        EXPECT_LT(distanceToBoundary(wall, is.head), 1e-9);
        EXPECT_LE(std::abs(one.offset), 0.3);
        EXPECT_NEAR((is.head - was.head).norm(), std::abs(one.offset), 0.25 * std::abs(one.offset) + 1e-3);
        const Point a = (was.head - was.farEnd).normalized(), b = (is.head - is.farEnd).normalized();
        const double turned = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b)) * 180.0 / std::numbers::pi;
        EXPECT_NEAR(turned, one.angle, 1e-9);
    }
}

TEST(BoltFaults, DrawsDependOnNamesAndNumberOnly) {
    Study one = studyWithFault(faultOf(FaultKind::Missing, 0.5));
    Study two = one;
    two.faults.insert(two.faults.begin(), faultOf(FaultKind::Missing, 0.0));
    two.faults.front().name = "other";
    for (long number = 1; number <= 20; ++number) {
        const std::vector<BoltFault> a = faultsOf(one, number, drift()), b = faultsOf(two, number, drift());
        ASSERT_EQ(a.size(), b.size());
        for (std::size_t i = 0; i < a.size(); ++i) EXPECT_EQ(a[i].bolt, b[i].bolt);
    }
}

}  // namespace
}  // namespace keyblock
