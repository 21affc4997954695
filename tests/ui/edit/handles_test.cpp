// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "sample_scenes.h"
#include "ui/edit/edits.h"
#include "ui/edit/handles.h"
#include "ui/edit/scene_objects.h"
#include "ui/edit/wall_at.h"

namespace {

using namespace keyblock;

TEST(Handles, HandlesOfEverySampleMoveTheirValue) {
    for (const std::string& name : sampleNames()) {
        const Scene scene = sampleScene(name);
        for (const SceneObject& object : objectsOf(scene)) {
            const std::vector<Handle> handles = handlesOf(scene, object.pointer);
            for (std::size_t i = 0; i < handles.size(); ++i) {
                const Point aim = handles[i].place + Point(0.01, 0.02);
                const Edit edit = dragHandle(scene, object.pointer, i, aim, 0.0);
                ASSERT_TRUE(edit.done()) << name << object.pointer << handles[i].name << edit.refusal;
                EXPECT_EQ(handlesOf(edit.scene, object.pointer).size(), handles.size());
            }
        }
    }
}

TEST(Handles, TunnelKeepsItsFloorAndItsCentreLine) {
    const Scene scene = sampleScene("drift-bolted");  // 4.5 by 4.5 around the origin
    const std::vector<Handle> handles = handlesOf(scene, "/tunnels/0");
    ASSERT_EQ(handles.size(), 3u);
    EXPECT_EQ(handles[1].name, "width");
    EXPECT_NEAR((handles[1].place - Point(2.25, 0.0)).norm(), 0.0, 1e-12);
    const Edit wide = dragHandle(scene, "/tunnels/0", 1, {3.0, 1.0}, 0.0);
    EXPECT_DOUBLE_EQ(wide.scene.tunnels[0].width, 6.0);
    EXPECT_EQ(wide.scene.tunnels[0].center, Point(0, 0));
    const Edit high = dragHandle(scene, "/tunnels/0", 2, {0.7, 3.25}, 0.0);
    EXPECT_DOUBLE_EQ(high.scene.tunnels[0].height, 5.5);
    EXPECT_DOUBLE_EQ(high.scene.tunnels[0].center.y() - 0.5 * 5.5, -2.25);
    EXPECT_TRUE(dragHandle(scene, "/tunnels/0", 2, {0, -9}, 0.0).done()) << "never turned inside out";
    EXPECT_FALSE(dragHandle(scene, "/tunnels/0", 9, {0, 0}, 0.0).done());
}

TEST(Handles, PatternsAndBoltsStayOnTheWall) {
    Scene scene = sampleScene("drift-bolted");
    scene.bolts.push_back(
        {"B1", "d-bolt-20", {-4.65, 0}, {-2.25, 0}, {}, PlateKind::Spring, {}, 0.0, {}, {}, {}, {}, -1});
    const Edit pattern = dragHandle(scene, "/bolt_patterns/0", 0, {2.4, -1.0}, 0.0);
    EXPECT_NEAR((pattern.scene.boltPatterns[0].from - Point(2.25, -1.0)).norm(), 0.0, 1e-12);
    const std::vector<Handle> handles = handlesOf(scene, "/bolts/0");
    ASSERT_EQ(handles.size(), 2u);
    ASSERT_EQ(handles[1].name, "head");
    const Edit slid = dragHandle(scene, "/bolts/0", 1, {-2.2, -1.0}, 0.5);
    EXPECT_NEAR((slid.scene.bolts[0].head - Point(-2.25, -1.0)).norm(), 0.0, 1e-12);
    EXPECT_NEAR((slid.scene.bolts[0].farEnd - Point(-4.65, -1.0)).norm(), 0.0, 1e-12);
}

TEST(Handles, CornersAreInsertedAndDeleted) {
    const Scene scene = sampleScene("drift-bolted");
    const Edit more = withCorner(scene, "/domain", {14.3, 1.0});
    ASSERT_TRUE(more.done());
    EXPECT_EQ(more.made, "/domain/boundary/2");
    EXPECT_EQ(more.scene.domain->boundary[2], Point(14, 1));
    EXPECT_EQ(removeAt(more.scene, more.made).scene, scene);
    EXPECT_FALSE(withCorner(scene, "/tunnels/0", {0, 0}).done());
    EXPECT_FALSE(withCorner(scene, "/nothing", {0, 0}).done());
    EXPECT_TRUE(handlesOf(scene, "/materials/granite").empty());
}

}  // namespace
