// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Names and pointers follow edits, dependent objects are deleted along; every edit
// leaves the given scene unchanged.
#include "sample_scenes.h"
#include "solver/scene/check.h"
#include "solver/scene/lookup.h"
#include "solver/scene/pointer.h"
#include "ui/edit/edits.h"

namespace {

using namespace keyblock;

Scene drawn() {
    Scene scene = sampleScene("drift-bolted");
    scene.joints.push_back({"fault", {{-14, 3}, {14, 6}}, "joint"});
    scene.bolts.push_back({"B1", "rebar-20", {6, 6}, {6, 8}, {}, PlateKind::None, {}, 0.0, {}, {}, {}, {}, -1});
    scene.stages[2].install.push_back("B1");
    scene.stages[4].dilations.push_back({"fault", 1e-3, -1});
    scene.stages[4].set.push_back({"joint", 25.0, {}, {}, {}});
    scene.monitors.push_back({"B1 force", {}, {}, {1, 0}, "B1", BoltQuantity::AxialForce, {}, {}, {}});
    scene.quantities = {"max B1.axial_force", "first debonding key", "last key.uy", "max roof.3.slip",
                        "count debonding"};
    settle(scene);
    return scene;
}

TEST(Rename, UpdatesAllReferences) {
    const Scene scene = drawn();
    const Edit material = renameAt(scene, "/joint_materials/joint", "rough");
    ASSERT_TRUE(material.done()) << material.refusal;
    EXPECT_EQ(material.scene.domain->jointMaterial, "rough");
    EXPECT_EQ(material.scene.jointSets[1].jointMaterial, "rough");
    EXPECT_EQ(material.scene.joints[0].jointMaterial, "rough");
    EXPECT_EQ(material.scene.stages[4].set[0].jointMaterial, "rough");
    EXPECT_EQ(material.made, "/joint_materials/rough");
    EXPECT_EQ(material.pointers.now("/joint_materials/joint/cohesion"), "/joint_materials/rough/cohesion");
    EXPECT_EQ(renameAt(material.scene, "/joint_materials/rough", "joint").scene, scene);

    const Edit pattern = renameAt(scene, "/bolt_patterns/0", "crown");
    ASSERT_TRUE(pattern.done());
    EXPECT_EQ(pattern.scene.stages[2].install[0], "crown");
    EXPECT_EQ(pattern.scene.monitors[3].bolt, "crown.3");
    EXPECT_EQ(pattern.scene.quantities[3], "max crown.3.slip");

    const Edit bolt = setValueAt(scene, "/bolts/0/name", std::string("B7"));
    ASSERT_TRUE(bolt.done());
    EXPECT_EQ(bolt.scene.quantities[0], "max B7.axial_force");
    EXPECT_EQ(bolt.scene.monitors.back().bolt, "B7");

    const Edit monitor = renameAt(scene, "/monitors/0", "key block");
    EXPECT_EQ(monitor.scene.quantities[1], "first debonding key block");
    EXPECT_EQ(monitor.scene.quantities[2], "last key block.uy");
    EXPECT_EQ(monitor.scene.about.expected[0].quantity, "last key block.uy");
    EXPECT_EQ(monitor.scene.about.expected[3].quantity, "last key bolt") << "another monitor";

    const Edit tunnel = renameAt(scene, "/tunnels/0", "D");
    EXPECT_EQ(tunnel.scene.boltPatterns[0].tunnel, "D");
    EXPECT_EQ(tunnel.scene.stages[1].excavate[0], "D");
    const Edit joint = renameAt(scene, "/joints/0", "F1");
    EXPECT_EQ(joint.scene.stages[4].dilations[0].joint, "F1");
    for (const Edit* edit : {&material, &pattern, &bolt, &monitor, &tunnel, &joint})
        EXPECT_FALSE(hasErrors(checkValues(edit->scene)));
}

TEST(Rename, RefusesAmbiguousNames) {
    const Scene scene = drawn();
    EXPECT_NE(renameAt(scene, "/joint_sets/0", "J2").refusal.find("A free name is 'J3'"), std::string::npos);
    EXPECT_FALSE(renameAt(scene, "/joint_sets/0", "fault").done()) << "a dilation could mean either";
    EXPECT_FALSE(renameAt(scene, "/bolts/0", "roof").done());
    EXPECT_FALSE(renameAt(scene, "/bolts/0", "").done());
    EXPECT_FALSE(renameAt(scene, "/domain", "x").done());
    EXPECT_FALSE(renameAt(scene, "/bolt_types/rebar-20", "mine").done());
    EXPECT_FALSE(renameAt(scene, "/supports/0", "x").done());
    EXPECT_TRUE(renameAt(scene, "/bolts/0", "B1").done()) << "the same name again";
}

TEST(Remove, DeletesDependentObjects) {
    const Scene scene = drawn();
    const Edit edit = removeAt(scene, "/tunnels/0");
    ASSERT_TRUE(edit.done());
    EXPECT_TRUE(edit.scene.boltPatterns.empty());
    EXPECT_TRUE(edit.scene.stages[1].excavate.empty());
    EXPECT_EQ(edit.scene.stages[2].install, std::vector<std::string>{"B1"});
    ASSERT_EQ(edit.scene.monitors.size(), 4u) << "the monitor of roof.3 had no bolt any more";
    EXPECT_EQ(edit.scene.monitors.back().name, "B1 force");
    EXPECT_EQ(edit.scene.quantities.size(), 4u);
    EXPECT_EQ(edit.scene.quantities.back(), "count debonding") << "names nothing";
    EXPECT_EQ(edit.scene.about.expected.size(), 4u);
    EXPECT_EQ(edit.pointers.now("/monitors/4"), "/monitors/3");
    EXPECT_FALSE(edit.pointers.now("/monitors/3"));
    EXPECT_FALSE(edit.pointers.now("/bolt_patterns/0/spacing"));
    EXPECT_FALSE(edit.notes.empty());
    EXPECT_FALSE(findBoltType(edit.scene, "d-bolt-20"));
    EXPECT_TRUE(findBoltType(edit.scene, "rebar-20"));
}

TEST(Remove, ClearsOptionalReferences) {
    Scene scene = drawn();
    scene.regions.push_back({"top", {{-5, 0}, {5, 0}, {5, 8}}});
    scene.jointSets[0].region = "top";
    const Edit region = removeAt(scene, "/regions/0");
    ASSERT_TRUE(region.done());
    EXPECT_FALSE(region.scene.jointSets[0].region);
    ASSERT_EQ(region.notes.size(), 1u);
    EXPECT_EQ(region.notes[0], "The joint set J1 no longer refers to the region top.");
    const Edit material = removeAt(scene, "/joint_materials/joint");
    EXPECT_FALSE(material.scene.domain->jointMaterial);
    EXPECT_TRUE(material.scene.stages[4].set.empty());
    const Edit rock = removeAt(scene, "/materials/granite");
    ASSERT_TRUE(rock.done());
    EXPECT_EQ(rock.scene.domain->material, "granite");
    EXPECT_TRUE(hasErrors(checkScene(rock.scene)));
    EXPECT_EQ(rock.notes.at(0), "The domain still refers to the material granite. Choose another one.");
}

TEST(Remove, SeveralObjectsAtOnceUpdatePointers) {
    const Scene scene = drawn();
    const Edit edit = removeAll(scene, {"/stages/1", "/stages/3", "/joint_sets/0", "/nothing/5"});
    ASSERT_TRUE(edit.done());
    ASSERT_EQ(edit.scene.stages.size(), 3u);
    EXPECT_EQ(edit.scene.stages[1].name, "bolt");
    EXPECT_EQ(edit.pointers.now("/stages/4/loads/0"), "/stages/2/loads/0");
    EXPECT_FALSE(edit.pointers.now("/stages/3/duration"));
    EXPECT_EQ(edit.pointers.now("/joint_sets/1"), "/joint_sets/0");
    for (const char* pointer : {"/stages/0", "/stages/4/loads/0", "/joint_sets/1", "/domain"})
        EXPECT_EQ(edit.pointers.reversed().now(*edit.pointers.now(pointer)), pointer) << "undo maps the pointers back";
    EXPECT_FALSE(removeAll(scene, {"/nothing/5"}).done());
    EXPECT_FALSE(removeAll(scene, {}).done());
    EXPECT_FALSE(removeAt(scene, "/bolt_types/d-bolt-20").done());
    EXPECT_TRUE(removeAt(scene, "/domain").done());
}

TEST(Remove, EveryObjectOfEverySampleCanBeDeleted) {
    for (const std::string& name : sampleNames()) {
        const Scene scene = sampleScene(name);
        for (const Field& field : sceneStructure().fields) {
            if (field.kind != FieldKind::List) continue;
            const std::size_t count = field.children.count(&scene);
            for (std::size_t i = 0; i < std::min<std::size_t>(count, 6); ++i) {
                const Edit edit = removeAt(scene, under(under("", field.key), i));
                ASSERT_TRUE(edit.done()) << name << field.key << i << edit.refusal;
                EXPECT_EQ(field.children.count(&edit.scene), count - 1) << name << field.key;
                checkScene(edit.scene);
            }
        }
    }
}

TEST(Move, ShiftsPointsAndPatternsMoveWithTheirTunnel) {
    const Scene scene = drawn();
    const Point offset(1.5, -0.25);
    const Edit edit = moveAll(scene, {"/tunnels/0", "/joints/0", "/joint_sets/0", "/monitors/0", "/bolts/0"}, offset);
    ASSERT_TRUE(edit.done());
    EXPECT_EQ(edit.scene.tunnels[0].center, scene.tunnels[0].center + offset);
    EXPECT_EQ(edit.scene.boltPatterns[0].from, scene.boltPatterns[0].from + offset);
    EXPECT_EQ(edit.scene.joints[0].points[1], scene.joints[0].points[1] + offset);
    EXPECT_EQ(edit.scene.jointSets[0].origin, scene.jointSets[0].origin + offset);
    EXPECT_EQ(edit.scene.jointSets[1].origin, scene.jointSets[1].origin);
    EXPECT_EQ(edit.scene.monitors[0].point, *scene.monitors[0].point + offset);
    EXPECT_EQ(edit.scene.monitors[0].axis, scene.monitors[0].axis);
    EXPECT_EQ(edit.scene.bolts[0].head, scene.bolts[0].head + offset);
    const Edit once = moveAll(scene, {"/tunnels/0", "/bolt_patterns/0"}, offset);
    EXPECT_EQ(once.scene.boltPatterns[0].to, scene.boltPatterns[0].to + offset) << "not twice";
    const Edit corner = moveAll(scene, {"/domain/boundary/2"}, offset);
    EXPECT_EQ(corner.scene.domain->boundary[2], scene.domain->boundary[2] + offset);
    EXPECT_EQ(corner.scene.domain->boundary[1], scene.domain->boundary[1]);
    EXPECT_EQ(moveAll(scene, {"/tunnels/0"}, {0, 0}).scene, scene);
    EXPECT_FALSE(moveAll(scene, {"/tunnels/0"}, {1e10, 0}).done());
    EXPECT_FALSE(moveAll(scene, {"/tunnels/0"}, {std::nan(""), 0}).done());
    EXPECT_FALSE(moveAll(scene, {"/materials/granite"}, offset).done());
}

TEST(Copy, GetsNewNamesAndTheStagesOfItsOriginal) {
    const Scene scene = drawn();
    std::vector<std::string> made;
    const Edit edit = copyAll(scene, scene, {"/tunnels/0", "/bolt_patterns/0", "/bolts/0", "/domain"}, {8, 0}, made);
    ASSERT_TRUE(edit.done()) << edit.refusal;
    ASSERT_EQ(made.size(), 3u);
    EXPECT_EQ(edit.scene.tunnels[1].name, "drift 2");
    EXPECT_EQ(edit.scene.boltPatterns[1].name, "roof 2");
    EXPECT_EQ(edit.scene.boltPatterns[1].tunnel, "drift 2");
    EXPECT_EQ(edit.scene.boltPatterns[1].from, scene.boltPatterns[0].from + Point(8, 0));
    EXPECT_EQ(edit.scene.bolts[1].name, "B2");
    EXPECT_EQ(edit.scene.stages[1].excavate, (std::vector<std::string>{"drift", "drift 2"}));
    EXPECT_EQ(edit.scene.stages[2].install.size(), 4u);
    EXPECT_EQ(edit.notes.size(), 1u) << "a scene has one domain";
    EXPECT_FALSE(copyAll(scene, scene, {"/domain"}, {1, 0}, made).done());
}

TEST(Copy, AddsMaterialsAndTypesMissingInTheScene) {
    const Scene scene = newScene();
    const Scene source = drawn();
    std::vector<std::string> made;
    const Edit edit = copyAll(scene, source, {"/bolts/0", "/joints/0"}, {0, 0}, made);
    ASSERT_TRUE(edit.done());
    EXPECT_TRUE(findBoltType(edit.scene, "rebar-20"));
    EXPECT_EQ(edit.scene.jointMaterials.size(), 1u);
    const Edit again = copyAll(edit.scene, source, {"/joints/0"}, {0, 0}, made);
    EXPECT_EQ(again.scene.joints[1].name, "fault 2");
}

TEST(Names, NewNamesAreFree) {
    EXPECT_EQ(freeName("J", {"J1", "J12", "joint"}), "J13");
    EXPECT_EQ(freeName("B", {}), "B1");
    const Scene scene = drawn();
    EXPECT_EQ(newName(scene, "/bolts"), "B2");
    EXPECT_EQ(newName(scene, "/stages"), "stage " + std::to_string(scene.stages.size() + 1));
    EXPECT_EQ(newName(scene, "/supports"), "");
    EXPECT_EQ(nameOfCopy(scene, "/tunnels", "drift"), "drift 2");
    EXPECT_EQ(nameOfCopy(scene, "/joints", "J1"), "J3") << "joint sets have J1 and J2";
    EXPECT_EQ(titleAt(scene, "/joints/0/points/1"), "joint fault");
    EXPECT_EQ(titleAt(scene, "/supports/0"), "bottom support");
    EXPECT_EQ(titleAt(scene, "/stages/4/loads/0"), "load 1 of stage load");
    EXPECT_EQ(titleAt(scene, "/domain/boundary"), "domain");
    EXPECT_EQ(titleAt(scene, "/materials/granite/density"), "material granite");
    EXPECT_EQ(titleAt(scene, "/analysis/gravity"), "analysis");
    EXPECT_EQ(titleAt(scene, ""), "scene");
}

/// A null field has no list to append to until one is created.
TEST(Append, CreatesTheAnchorListOfABolt) {
    Scene scene;
    scene.bolts.resize(1);
    scene.bolts[0].anchors.emplace(3);
    scene.bolts[0].anchors.reset();
    for (const std::size_t count : {1u, 2u}) {
        Edit edit = appendAt(scene, "/bolts/0/anchors");
        ASSERT_TRUE(edit.done()) << edit.refusal;
        ASSERT_TRUE(edit.scene.bolts[0].anchors);
        EXPECT_EQ(edit.scene.bolts[0].anchors->size(), count);
        scene = std::move(edit.scene);
    }
}

TEST(NewScene, IsReadyForDrawing) {
    Edit edit = withDomain(newScene(), {{-15, -12}, {15, -12}, {15, 15}, {-15, 15}});
    ASSERT_TRUE(edit.done());
    EXPECT_EQ(edit.scene.supports.size(), 3u);
    edit = appendAt(edit.scene, "/joint_sets");
    edit = appendAt(edit.scene, "/joint_sets");
    SceneTunnel tunnel;
    tunnel.profile = ProfileKind::DShape;
    tunnel.width = tunnel.height = 5.0;
    edit = withTunnel(edit.scene, tunnel);
    ASSERT_TRUE(edit.done());
    EXPECT_EQ(edit.scene.stages[1].excavate, std::vector<std::string>{"tunnel 1"});
    ScenePattern pattern;
    pattern.type = "d-bolt-20", pattern.tunnel = "tunnel 1", pattern.from = {2.5, 0.1}, pattern.to = {-2.5, 0.1};
    pattern.spacing = 1.0, pattern.length = 2.4;
    edit = withPattern(edit.scene, pattern);
    ASSERT_TRUE(edit.done());
    ASSERT_EQ(edit.scene.stages.size(), 3u);
    EXPECT_EQ(edit.scene.stages[2].install, std::vector<std::string>{"P1"});
    EXPECT_EQ(edit.scene.stages[1].relaxation, 0.5);
    EXPECT_EQ(edit.notes.size(), 2u);
    const std::vector<Problem> problems = checkScene(edit.scene);
    for (const Problem& problem : problems) EXPECT_NE(problem.severity, Severity::Error) << oneLine(problem);
    const Edit second = withPattern(edit.scene, pattern);
    EXPECT_EQ(second.scene.stages.size(), 3u);
    EXPECT_EQ(second.scene.stages[2].install, (std::vector<std::string>{"P1", "P2"}));
}

TEST(NewScene, RefusesInvalidShapes) {
    const Scene scene = newScene();
    EXPECT_FALSE(withDomain(scene, {{0, 0}, {1, 0}}).done());
    EXPECT_FALSE(withDomain(scene, {{0, 0}, {1, 0}, {2, 0}}).done());
    EXPECT_FALSE(withDomain(scene, {{0, 0}, {1, 1}, {1, 0}, {0, 1}}).done());
    EXPECT_FALSE(withDomain(scene, {{0, 0}, {1, std::nan("")}, {1, 0}}).done());
    EXPECT_FALSE(withTunnel(scene, {}).done());
    EXPECT_FALSE(withPattern(scene, {}).done());
    EXPECT_FALSE(withBolt(scene, {}).done());
}

}  // namespace
