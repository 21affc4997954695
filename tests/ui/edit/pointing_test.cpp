// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Shapes, hits, boxes, snaps and walls in a drift with known coordinates.
#include "sample_scenes.h"
#include "solver/scene/lookup.h"
#include "solver/scene/shapes.h"
#include "ui/edit/edits.h"
#include "ui/edit/hit.h"
#include "ui/edit/locate.h"
#include "ui/edit/scene_objects.h"
#include "ui/edit/snap.h"
#include "ui/edit/wall_at.h"

#include <algorithm>

namespace {

using namespace keyblock;

Scene crossed() {
    Scene scene = withDomain(newScene(), {{0, 0}, {20, 0}, {20, 10}, {0, 10}}).scene;
    scene.joints = {{"J1", {{2, 2}, {8, 2}}, {}}, {"J2", {{5, 0.5}, {5, 6}}, {}}, {"J12", {{12, 3}, {18, 3}}, {}}};
    SceneTunnel tunnel;
    tunnel.name = "drift", tunnel.profile = ProfileKind::DShape, tunnel.center = {15, 7}, tunnel.width = 4, tunnel.height = 4;
    return withTunnel(scene, tunnel).scene;
}

std::optional<Snap> snapAt(const Scene& scene, const Point& place, SnapWish wish = {.radius = 0.3}) {
    return SnapIndex(objectsOf(scene)).at(place, wish);
}

TEST(Objects, EverySampleHasPointersAndShapes) {
    for (const std::string& name : sampleNames()) {
        const Scene scene = sampleScene(name);
        const std::vector<SceneObject> objects = objectsOf(scene);
        EXPECT_FALSE(objects.empty()) << name;
        for (const SceneObject& object : objects) {
            EXPECT_TRUE(locate(scene, object.pointer)->isObject()) << name << object.pointer;
            EXPECT_FALSE(object.title.empty());
            EXPECT_FALSE(object.lines.empty() && object.marks.empty()) << object.title;
            for (const ObjectLine& line : object.lines) EXPECT_GE(line.points.size(), 2u) << object.title;
        }
    }
}

TEST(Objects, SetsAndPatternsEqualThoseOfTheCut) {
    const Scene scene = sampleScene("drift-bolted");
    std::size_t traces = 0;
    for (const CutTrace& trace : tracesOf(scene).traces) traces += trace.source < 2;
    std::size_t shown = 0, bolts = 0;
    for (const SceneObject& object : objectsOf(scene)) {
        if (object.kind == ObjectKind::JointSet) shown += object.lines.size();
        if (object.kind == ObjectKind::Pattern) bolts += object.lines.size();
    }
    EXPECT_EQ(shown, traces);
    const Scene cut = cutScene(scene).scene;
    ASSERT_EQ(bolts, cut.bolts.size());
    EXPECT_EQ(boltsOfPattern(scene, scene.boltPatterns[0])[0].points[0], cut.bolts[0].head);
}

TEST(Objects, AcceptBrokenScenes) {
    Scene scene = crossed();
    scene.domain->boundary = {{0, 0}, {1, 1}, {1, 0}, {0, 1}};
    scene.jointSets.resize(2);
    scene.jointSets[1].spacing = 1e-9;
    scene.boltPatterns.resize(1);
    scene.joints[0].points = {{std::nan(""), 0}, {1, 1}};
    scene.tunnels[0].width = -1;
    scene.voronoi.emplace();
    scene.blocks.resize(1);
    scene.supports.resize(5);
    const std::vector<SceneObject> objects = objectsOf(scene);
    SnapIndex(objects).at({0, 0}, {.radius = 1});
    objectsAt(objects, {0, 0}, 1);
    EXPECT_FALSE(wallAt(scene, {0, 0}, -1));
    EXPECT_FALSE(wallOfTunnel(scene, 0, {0, 0}));
    EXPECT_FALSE(wallOfTunnel(scene, 7, {0, 0}));
    scene.voronoi->size = 1.0;
    scene.domain->boundary = {{3, 3}, {3, 3}, {3, 3}};
    for (const SceneObject& object : objectsOf(scene)) EXPECT_NE(object.kind, ObjectKind::Voronoi) << "no area";
    scene.domain->boundary = {{0, 0}, {1000, 0}, {1000, 1000}};
    const std::vector<SceneObject> repaired = objectsOf(scene);
    const auto huge = std::find_if(repaired.begin(), repaired.end(),
                                   [](const SceneObject& object) { return object.pointer == "/joint_sets/1"; });
    ASSERT_NE(huge, repaired.end());
    EXPECT_EQ(huge->lines.size(), 1u) << "a symbol represents it";
}

TEST(Hit, PrefersSmallObjects) {
    const Scene scene = crossed();
    const std::vector<SceneObject> objects = objectsOf(scene);
    const auto first = [&](const Point& place) {
        const auto found = objectsAt(objects, place, 0.3);
        return found.empty() ? std::string() : objects[found.front()].pointer;
    };
    EXPECT_EQ(first({3, 2.1}), "/joints/0");
    EXPECT_EQ(first({15, 7}), "/tunnels/0") << "its interior";
    EXPECT_EQ(first({10, 8}), "") << "rock is not an object";
    EXPECT_EQ(first({10, 9.9}), "/domain");
    EXPECT_EQ(first({0.1, 5}), "/supports/1") << "on the supported side";
    EXPECT_EQ(objectsAt(objects, {0.1, 5}, 0.3).size(), 2u);
}

TEST(Hit, BoxEnclosesOrCrosses) {
    const Scene scene = crossed();
    const std::vector<SceneObject> objects = objectsOf(scene);
    const Box box{{1, 1}, {9, 4}};
    const auto enclosed = objectsIn(objects, box, BoxRule::Encloses);
    ASSERT_EQ(enclosed.size(), 1u);
    EXPECT_EQ(objects[enclosed[0]].title, "joint J1");
    EXPECT_EQ(objectsIn(objects, box, BoxRule::Crosses).size(), 2u);
    EXPECT_EQ(objectsIn(objects, Box{{4, 3}, {6, 4}}, BoxRule::Crosses).size(), 1u) << "it only crosses the box";
    EXPECT_TRUE(objectsIn(objects, Box{{9, 4}, {10, 5}}, BoxRule::Crosses).empty());
    EXPECT_EQ(objectsIn(objects, Box{{-1, -1}, {30, 30}}, BoxRule::Encloses).size(), objects.size());
}

TEST(Snap, PrefersPointsToNearerLines) {
    const Scene scene = crossed();
    const auto end = snapAt(scene, {11.8, 3.05});
    ASSERT_TRUE(end);
    EXPECT_EQ(end->kind, SnapKind::End);
    EXPECT_EQ(end->name, "end of joint J12");
    EXPECT_EQ(end->place, Point(12, 3));
    const auto meeting = snapAt(scene, {5.1, 2.1});
    EXPECT_EQ(meeting->kind, SnapKind::Intersection);
    EXPECT_EQ(meeting->name, "intersection of joint J1 and joint J2");
    EXPECT_EQ(meeting->place, Point(5, 2));
    const auto middle = snapAt(scene, {15.2, 3.1});
    EXPECT_EQ(middle->kind, SnapKind::Middle);
    EXPECT_EQ(middle->place, Point(15, 3));
    const auto on = snapAt(scene, {13.2, 3.1});
    EXPECT_EQ(on->kind, SnapKind::OnLine);
    EXPECT_EQ(on->name, "on joint J12");
    const auto foot = snapAt(scene, {13.2, 3.02}, {.radius = 0.3, .previous = Point(13.35, 6)});
    EXPECT_EQ(foot->kind, SnapKind::Foot) << "a point takes precedence over the line under the mouse";
    EXPECT_NEAR(foot->place.x(), 13.35, 1e-12);
    EXPECT_FALSE(snapAt(scene, {10, 5.5}));
    const auto grid = snapAt(scene, {10.2, 5.4}, {.radius = 0.3, .grid = 0.5});
    EXPECT_EQ(grid->kind, SnapKind::Grid);
    EXPECT_EQ(grid->place, Point(10, 5.5));
    EXPECT_EQ(snapAt(scene, {13.2, 3.1}, {.radius = 0.3, .grid = 0.1})->kind, SnapKind::OnLine);
    EXPECT_EQ(snapAt(scene, {13.2, 3.1}, {.radius = 0.3, .objects = false, .grid = 0.5})->kind, SnapKind::Grid);
    EXPECT_FALSE(snapAt(scene, {13.2, 3.1}, {.radius = 0.3, .except = {"/joints/2"}}));
    EXPECT_FALSE(snapAt(scene, {std::nan(""), 3.1}));
    EXPECT_FALSE(snapAt({}, {0, 0}));
}

TEST(Snap, FindsCornersOfTunnelsButNotPointsOfArcs) {
    const Scene scene = crossed();
    EXPECT_EQ(snapAt(scene, {13.1, 5.1})->name, "corner of tunnel drift");
    EXPECT_EQ(snapAt(scene, {15.1, 7.1})->name, "centre of tunnel drift");
    const auto crown = snapAt(scene, {15.3, 9.0});
    EXPECT_EQ(crown->kind, SnapKind::OnLine) << "edges of an arc have no ends";
    EXPECT_EQ(snapAt(scene, {0.1, 0.1})->name, "corner of domain");
}

TEST(Snap, SnapAndHitIgnoreJointsInOpenings) {
    Scene scene = crossed();
    scene.joints.push_back({"through", {{10, 7}, {19, 7}}, {}});
    EXPECT_FALSE(snapAt(scene, {14.0, 7.05}));
    EXPECT_EQ(snapAt(scene, {12.0, 7.05})->name, "on joint through");
    EXPECT_EQ(snapAt(scene, {13.1, 7.05})->kind, SnapKind::End) << "where the wall begins its arc";
    const std::vector<SceneObject> objects = objectsOf(scene);
    EXPECT_EQ(objects[objectsAt(objects, {14.0, 7.05}, 0.3).front()].pointer, "/tunnels/0");
    EXPECT_EQ(objects[objectsAt(objects, {12.0, 7.05}, 0.3).front()].pointer, "/joints/3");
}

TEST(Snap, ComparesFewOfFiveThousandTraces) {
    Scene scene = withDomain(newScene(), {{0, 0}, {100, 0}, {100, 100}, {0, 100}}).scene;
    for (const double dip : {20.0, 110.0}) {
        SceneJointSet& set = scene.jointSets.emplace_back();
        set.name = "S" + std::to_string(scene.jointSets.size());
        set.dip = dip, set.spacing = 0.7, set.traceLength = 5.0, set.bridge = 1.0, set.traceLengthDeviation = 1.0;
        set.origin = {50, 50};
    }
    const std::vector<SceneObject> objects = objectsOf(scene);
    std::size_t traces = 0;
    for (const SceneObject& object : objects) traces += object.lines.size();
    ASSERT_GT(traces, 4500u);
    const SnapIndex index(objects);
    int found = 0;
    std::size_t most = 0;
    for (int i = 0; i < 1000; ++i) {
        const Point mouse(0.1 * i, 50.0 + 0.03 * i);
        found += index.at(mouse, {.radius = 0.5, .previous = Point(1, 1)}).has_value();
        most = std::max(most, index.compared(mouse, 0.5));
    }
    EXPECT_GT(found, 300);
    RecordProperty("compared", static_cast<int>(most));
    EXPECT_LT(most, traces / 10) << "a mouse moves a hundred times a second";
}

TEST(Wall, NormalPointsIntoTheRock) {
    const Scene scene = crossed();
    const auto side = wallAt(scene, {12.9, 6.0}, 0.5);
    ASSERT_TRUE(side);
    EXPECT_EQ(side->name, "wall of tunnel drift");
    EXPECT_NEAR((side->place - Point(13, 6)).norm(), 0.0, 1e-12);
    EXPECT_NEAR((side->inward - Point(-1, 0)).norm(), 0.0, 1e-12);
    const auto crown = wallAt(scene, {15, 8.8}, 0.5);
    EXPECT_NEAR((crown->inward - Point(0, 1)).norm(), 0.0, 1e-12);
    const auto border = wallAt(scene, {10, 0.2}, 0.5);
    EXPECT_EQ(border->name, "face of the domain");
    EXPECT_EQ(border->inward, Point(0, 1));
    EXPECT_FALSE(wallAt(scene, {10, 5}, 0.5));
}

TEST(Wall, LengthDependsOnTheDirection) {
    const Scene scene = crossed();
    const SceneTunnel& tunnel = scene.tunnels[0];
    const double left = wallOfTunnel(scene, 0, {13, 7})->along, right = wallOfTunnel(scene, 0, {17, 7})->along;
    const double over = runAlong(tunnel, right, left, Way::CounterClockwise);
    EXPECT_NEAR(over, 2 * 3.14159265358979, 1e-9);
    const double all = runAlong(tunnel, left, left, Way::Clockwise);
    EXPECT_NEAR(over + runAlong(tunnel, right, left, Way::Clockwise), all, 1e-9);
    const std::vector<Point> line = wallBetween(tunnel, right, left, Way::CounterClockwise);
    EXPECT_NEAR((line.front() - Point(17, 7)).norm(), 0.0, 1e-9);
    EXPECT_NEAR((line.back() - Point(13, 7)).norm(), 0.0, 1e-9);
    EXPECT_GT(line.size(), 8u);
    for (const Point& p : line) EXPECT_GE(p.y(), 7.0 - 1e-9);
}

}  // namespace
