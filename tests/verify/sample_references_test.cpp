// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The numbers that the samples of the paper's bolts say they give, worked out
// again by the independent calculation with the samples' own rock of 60 GPa, and
// the order in which their nodes let go.
#include "solver/files/scene_file.h"
#include "solver/run/run.h"
#include "tests/verify/reference/bolts.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace keyblock {
namespace {

using namespace reference;

Scene sample(const std::string& name) {
    const SceneReading reading = readSceneFile(std::string(KEYBLOCK_SAMPLES_DIR) + "/" + name + ".json");
    EXPECT_TRUE(reading.scene) << name;
    return reading.scene.value_or(Scene{});
}

double expectedOf(const Scene& scene, const std::string& quantity) {
    for (const Expected& expected : scene.about.expected)
        if (expected.quantity == quantity) return expected.value;
    ADD_FAILURE() << "no " << quantity;
    return 0.0;
}

BarProblem inRock(BarProblem problem) {
    makeRockElastic(problem, rockStiffness);
    return problem;
}

struct RebarSample {
    const char* name;
    double youngsModulus, peak;
};

constexpr RebarSample rebarSamples[]{{"rebar-stated", 213.043e9, 24.56e3},
                                     {"rebar-reading-a", 177e9, 24.56e3},
                                     {"rebar-reading-b", 215.8e9, 22.32e3}};

BarResult pulled(const RebarSample& s) {
    return pullTo(inRock(paperRebar(s.youngsModulus, s.peak, Mesh::JointInElement)), 6e-3);
}

TEST(SampleReference, RebarsExpectTheReference) {
    for (const RebarSample& s : rebarSamples) {
        SCOPED_TRACE(s.name);
        const Scene scene = sample(s.name);
        const BarResult result = pulled(s);
        EXPECT_NEAR(expectedOf(scene, "first debonding joint force"), result.releases().front().load, 0.1);
        EXPECT_NEAR(expectedOf(scene, "first debonding dilation"), result.releases().front().opening, 1e-10);
        EXPECT_NEAR(expectedOf(scene, "max joint force"), result.largestLoad(), 0.1);
        EXPECT_NEAR(expectedOf(scene, "last joint force"), result.path.back().second, 0.1);
    }
}

/// The fixed block is rigid and the other is not, so that the two sides are not alike: the first twelve releases and
/// their number are compared.
TEST(SampleReference, RebarsLetGoInTheReferencesOrder) {
    for (const RebarSample& s : rebarSamples) {
        SCOPED_TRACE(s.name);
        std::vector<int> expected, found;
        for (const BarEvent& event : pulled(s).releases()) expected.push_back(event.node);
        for (const Event& event : runInMemory(sample(s.name)).events)
            if (event.kind == EventKind::Debonding) found.push_back(event.node);
        EXPECT_EQ(found.size(), expected.size());
        ASSERT_GE(found.size(), 12u);
        EXPECT_TRUE(std::equal(found.begin(), found.begin() + 12, expected.begin()));
    }
}

TEST(SampleReference, DBoltsExpectTheReference) {
    for (const bool table : {false, true}) {
        const Scene scene = sample(table ? "dbolt-table-steel" : "dbolt-text-steel");
        const BarResult result = pullTo(inRock(paperDBolt(table ? tableSteel : textSteel, true)), 0.3);
        const auto yield = result.first(BarEventKind::Corner), rupture = result.first(BarEventKind::Rupture);
        ASSERT_TRUE(yield && rupture);
        EXPECT_NEAR(expectedOf(scene, "first yield joint force"), yield->load, 0.1);
        EXPECT_NEAR(expectedOf(scene, "first yield dilation"), yield->opening, 1e-9);
        EXPECT_NEAR(expectedOf(scene, "first tensile-rupture joint force"), rupture->load, 0.1);
        EXPECT_NEAR(expectedOf(scene, "first tensile-rupture dilation"), rupture->opening, 1e-7);
    }
}

TEST(SampleReference, ElasticRebarsExpectTheReference) {
    const std::pair<const char*, double> pairs[]{
        {"rebar-elastic-20", 20e6}, {"rebar-elastic-85", 84.78e6}, {"rebar-elastic-300", 300e6}};
    for (const auto& [name, stiffness] : pairs) {
        SCOPED_TRACE(name);
        const Scene scene = sample(name);
        const BarResult result = loadTo(inRock(elasticRebar(stiffness, 1e9)), 200e3);
        EXPECT_NEAR(expectedOf(scene, "last dilation"), result.path.back().first, 1e-9);
        EXPECT_NEAR(expectedOf(scene, "last B.plate_force"), result.springForce.back(), 0.01);
        EXPECT_NEAR(expectedOf(scene, "last force at 0.683 m"), result.elementForce[20], 0.1);
    }
}

}  // namespace
}  // namespace keyblock
