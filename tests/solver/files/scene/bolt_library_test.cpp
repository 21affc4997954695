// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The built-in types are complete, sound, and hold the numbers they are known for.
#include "solver/files/scene/bolt_library.h"

#include "solver/scene/check.h"
#include "solver/scene/field.h"

#include <gtest/gtest.h>

namespace keyblock {
namespace {

TEST(BoltLibrary, HoldsTheTypesOfTheFormat) {
    std::vector<std::string> names;
    for (const BoltType& type : builtInBoltTypes())
        names.push_back(type.name);
    EXPECT_EQ(names, (std::vector<std::string>{"cone-bolt-17", "d-bolt-20", "d-bolt-20-table-steel", "d-bolt-22",
                                               "expansion-shell-17", "garford-20", "rebar-20", "rebar-20-paper",
                                               "rebar-20-paper-a", "rebar-20-paper-b", "roofex-rx8", "split-set-47",
                                               "swellex-12t"}));
}

TEST(BoltLibrary, IsWithoutProblems) {
    Scene scene;
    scene.boltTypes = builtInBoltTypes();
    for (const Problem& problem : checkScene(scene))
        EXPECT_NE(problem.severity, Severity::Error) << oneLine(problem);
}

TEST(BoltLibrary, GivesASourceForEveryNumberThatIsNotTheDefault) {
    const Structure& structure = boltTypeStructure();
    for (const BoltType& type : builtInBoltTypes()) {
        EXPECT_TRUE(type.builtIn);
        EXPECT_FALSE(type.source.empty()) << type.name;
        for (const std::string key : {"diameter", "area", "steel", "youngs_modulus", "anchors", "dynamic_factor",
                                      "steel_dynamic_factor", "plate_dynamic_factor"}) {
            const Field* field = findField(structure, key);
            ASSERT_NE(field, nullptr);
            const bool isGiven = !sameValue(*field, &type, structure.defaults);
            EXPECT_TRUE(!isGiven || type.sources.contains(key)) << type.name << "." << key;
        }
        EXPECT_TRUE(!type.plate.normalStrength || type.sources.contains("plate.normal_strength")) << type.name;
    }
}

TEST(BoltLibrary, SourcesNameFieldsThatExist) {
    for (const BoltType& type : builtInBoltTypes())
        for (const auto& [key, source] : type.sources) {
            EXPECT_NE(findField(boltTypeStructure(), key.substr(0, key.find('.'))), nullptr) << type.name << "." << key;
            EXPECT_FALSE(source.empty()) << type.name << "." << key;
        }
}

TEST(BoltLibrary, HoldsThePublishedRebar) {
    const BoltType* stated = findBuiltInBoltType("rebar-20-paper");
    ASSERT_NE(stated, nullptr);
    EXPECT_DOUBLE_EQ(*stated->youngsModulus, 213.043e9);
    EXPECT_TRUE(stated->steel.empty());
    ASSERT_EQ(stated->anchors.size(), 1u);
    EXPECT_EQ(stated->anchors[0].per, Per::Node);
    EXPECT_DOUBLE_EQ(stated->anchors[0].stiffness, 84.78e6);
    EXPECT_DOUBLE_EQ(*stated->anchors[0].strength, 24.56e3);
    EXPECT_DOUBLE_EQ(stated->anchors[0].residual, 2.24e3);
    EXPECT_FALSE(stated->anchors[0].restick);
    EXPECT_DOUBLE_EQ(*findBuiltInBoltType("rebar-20-paper-a")->youngsModulus, 177e9);
    EXPECT_DOUBLE_EQ(*findBuiltInBoltType("rebar-20-paper-b")->anchors[0].strength, 22.32e3);
}

TEST(BoltLibrary, FollowsLike) {
    const BoltType* text = findBuiltInBoltType("d-bolt-20");
    const BoltType* table = findBuiltInBoltType("d-bolt-20-table-steel");
    ASSERT_TRUE(text && table);
    EXPECT_EQ(table->anchors, text->anchors);
    EXPECT_EQ(table->boltClass, BoltClass::DMC);
    EXPECT_DOUBLE_EQ(table->steel.back().first, 0.24);
    EXPECT_FALSE(table->plate.normalStrength) << "never lost";
    EXPECT_NE(table->sources.at("steel"), text->sources.at("steel"));
    EXPECT_EQ(table->sources.at("anchors"), text->sources.at("anchors"));
}

TEST(BoltLibrary, SlipForcesOfYieldingAnchorsAreThoseOfTheWholeAnchor) {
    for (const auto& [name, force] : {std::pair{"roofex-rx8", 80e3}, std::pair{"garford-20", 120e3}}) {
        const Anchor& anchor = findBuiltInBoltType(name)->anchors.at(0);
        EXPECT_NEAR(anchor.curve[1].second * anchor.to.s, force, 1e-8 * force) << "as many digits as the file gives";
    }
}

TEST(BoltLibrary, AddsOnlyWhatAScenesBoltsUse) {
    Scene scene;
    scene.boltTypes.resize(1);
    scene.boltTypes[0].name = "d-bolt-20";
    scene.bolts.resize(3);
    scene.bolts[0].type = "d-bolt-20";
    scene.bolts[1].type = "roofex-rx8";
    scene.bolts[2].type = "roofex-rx8";
    addUsedBuiltInBoltTypes(scene);
    ASSERT_EQ(scene.boltTypes.size(), 2u);
    EXPECT_FALSE(scene.boltTypes[0].builtIn) << "the scene's own comes first";
    EXPECT_EQ(scene.boltTypes[1].name, "roofex-rx8");
}

}  // namespace
}  // namespace keyblock
