// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the field table gives as the automatic value of a field is what a run uses
// where the scene says null.
#include "solver/scene/automatic.h"

#include "solver/engine/setup/make_model.h"
#include "solver/files/scene/bolt_library.h"
#include "solver/run/stage_settings.h"
#include "solver/scene/field.h"
#include "solver/scene/lookup.h"
#include "solver/scene/scene_cut.h"
#include "solver/verify/scenes.h"

#include <gtest/gtest.h>

#include <stdexcept>

namespace keyblock {
namespace {

FieldValue valueOf(std::string_view structure, std::string_view key, const Scene& scene, const void* object,
                   const SceneCut* cut = nullptr) {
    for (const Structure* one : allStructures())
        if (one->name == structure) return automaticOf(*findField(*one, key), scene, cut, object);
    throw std::invalid_argument(std::string(structure));
}

double numberOf(std::string_view structure, std::string_view key, const Scene& scene, const void* object,
                const SceneCut* cut = nullptr) {
    return std::get<double>(valueOf(structure, key, scene, object, cut));
}

Scene boltedScene(BoltType type) {
    type.builtIn = false;
    Scene scene = twoBlocks(rigidRock, 1.0, 2.0);
    addBolt(scene, type, 0.1, 1.9, 20, PlateKind::Spring);
    return scene;
}

TEST(Automatic, StopCriteriaAreThoseOfTheRun) {
    Scene scene;
    const Stage stage;
    for (const double tolerance : {1e-3, 1e-6}) {
        scene.analysis.tolerance = tolerance;
        const StaticSettings settings = staticSettings(scene, stage);
        EXPECT_EQ(numberOf("until", "unbalanced", scene, &stage.until), settings.unbalanced);
        EXPECT_EQ(numberOf("until", "body", scene, &stage.until), settings.body);
        EXPECT_EQ(numberOf("until", "smallest", scene, &stage.until), settings.smallest);
        EXPECT_EQ(numberOf("until", "max_steps", scene, &stage.until), settings.maxSteps);
    }
    EXPECT_EQ(numberOf("limits", "iterations", scene, &scene.limits), staticSettings(scene, stage).maxSteps);
    scene.limits.iterations = 300;
    EXPECT_EQ(numberOf("until", "max_steps", scene, &stage.until), staticSettings(scene, stage).maxSteps);
}

TEST(Automatic, TimeIntegrationIsThatOfTheRun) {
    Scene scene;
    scene.analysis.rhoInf = 0.6;
    scene.analysis.integration = Integration::Newmark;
    Stage stage;
    stage.kind = StageKind::Dynamic;
    EXPECT_EQ(valueOf("stage", "time_step", scene, &stage), FieldValue()) << "it follows from the duration";
    for (const double duration : {0.01, 5.0}) {
        stage.duration = duration;
        EXPECT_EQ(numberOf("stage", "time_step", scene, &stage), dynamicSettings(scene, stage).timeStep);
    }
    EXPECT_EQ(numberOf("stage", "rho_inf", scene, &stage), dynamicSettings(scene, stage).rhoInf);
    EXPECT_EQ(valueOf("stage", "integration", scene, &stage), FieldValue(std::string("newmark")));
    EXPECT_EQ(dynamicSettings(scene, stage).scheme, Inertia::Newmark);
}

TEST(Automatic, SteelIsThatOfTheModel) {
    for (BoltType type : builtInBoltTypes()) {
        type.area = type.secondMoment = type.plasticModulus = type.youngsModulus = type.tensileStrength = std::nullopt;
        Scene scene = boltedScene(type);
        const Model model = makeModel(scene);
        const BoltModel& bolt = model.bolts.front();
        const BoltType& used = scene.boltTypes.front();
        EXPECT_EQ(numberOf("bolt type", "area", scene, &used), bolt.section.area) << type.name;
        EXPECT_EQ(numberOf("bolt type", "second_moment", scene, &used), bolt.section.secondMoment) << type.name;
        EXPECT_EQ(numberOf("bolt type", "plastic_modulus", scene, &used), bolt.plasticModulus) << type.name;
        EXPECT_EQ(numberOf("bolt type", "youngs_modulus", scene, &used), bolt.section.youngsModulus) << type.name;
        const FieldValue strength = valueOf("bolt type", "tensile_strength", scene, &used);
        const auto* number = std::get_if<double>(&strength);
        EXPECT_NEAR(number ? *number * bolt.section.area : 0.0, bolt.tensileStrength, 1e-12 * bolt.tensileStrength)
            << type.name;
    }
}

TEST(Automatic, FactorsAndSpacingOfABoltAreThoseOfItsModel) {
    BoltType type = builtInBoltTypes().front();
    type.dynamicFactor = 1.1;
    type.steelDynamicFactor = 1.2;
    type.plateDynamicFactor = 1.3;
    Scene scene = boltedScene(type);
    scene.analysis.thickness = 1.5;
    const Bolt& bolt = scene.bolts.front();
    const Model model = makeModel(scene);
    const BoltModel& made = model.bolts.front();
    EXPECT_EQ(numberOf("bolt", "dynamic_factor", scene, &bolt), made.dynamicFactors.bond);
    EXPECT_EQ(numberOf("bolt", "steel_dynamic_factor", scene, &bolt), made.dynamicFactors.steel);
    EXPECT_EQ(numberOf("bolt", "plate_dynamic_factor", scene, &bolt), made.dynamicFactors.plate);
    EXPECT_EQ(model.thickness / numberOf("bolt", "spacing_out_of_plane", scene, &bolt), made.share);
}

TEST(Automatic, JointMaterialsAreThoseOfTheCutFaces) {
    Scene scene;
    scene.materials = {{"rock", {2700, 60e9, 0.17}}};
    scene.jointMaterials = {{"first", {}}, {"second", {}}};
    scene.domain.emplace();
    scene.domain->boundary = {{0, 0}, {4, 0}, {4, 4}, {0, 4}};
    scene.domain->material = "rock";
    SceneJoint& joint = scene.joints.emplace_back();
    joint.name = "J";
    joint.points = {{-1, 2}, {5, 2.5}};
    for (const char* ofDomain : {"", "second"}) {
        if (*ofDomain) scene.domain->jointMaterial = ofDomain;
        const std::string name = std::get<std::string>(valueOf("joint", "joint_material", scene, &joint));
        EXPECT_EQ(name, *ofDomain ? ofDomain : "first");
        const SceneCut cut = cutScene(scene);
        ASSERT_EQ(cut.blocks, 2);
        EXPECT_EQ(numberOf("cutting", "tolerance", scene, &scene.cutting, &cut), cut.tolerance);
        EXPECT_EQ(numberOf("cutting", "min_area", scene, &scene.cutting, &cut), cut.minArea);
        const int traced = traceSource(scene, "J");
        bool found = false;
        for (const Block& block : cut.scene.blocks)
            for (const CutFace& face : block.faces)
                if (face.source == traced) {
                    found = true;
                    EXPECT_EQ(cut.scene.jointMaterials.at(static_cast<std::size_t>(face.joint)).first, name);
                }
        EXPECT_TRUE(found);
    }
}

TEST(Automatic, NullIsEitherAValueOrAText) {
    for (const Structure* structure : allStructures())
        for (const Field& field : structure->fields) {
            EXPECT_FALSE(field.automatic && !field.nullText.empty()) << structure->name << '/' << field.key;
            EXPECT_TRUE(field.nullable || (!field.automatic && field.nullText.empty()))
                << structure->name << '/' << field.key;
        }
}

}  // namespace
}  // namespace keyblock
