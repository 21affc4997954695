// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Anchored points set by hand become entries that give the same nodes again; the
// library shows the values of bolt types and makes editable copies.
#include "tests/ui/panels/form_bench.h"

#include "solver/files/scene/bolt_library.h"
#include "ui/document/selection.h"
#include "ui/edit/anchor_edit.h"
#include "ui/edit/edits.h"
#include "ui/panels/editors/anchor_strip.h"
#include "ui/panels/library/library_panel.h"

#include <algorithm>
#include <random>

namespace keyblock {
namespace {

std::vector<Anchor> anchorsOfType(const char* name) { return findBuiltInBoltType(name)->anchors; }

TEST(AnchorEdit, RangeIsSplitAroundRemovedNodes) {
    const auto nodes = evenNodes(2.0, 20);
    const auto anchors = anchorsOfType("rebar-20");
    EXPECT_EQ(std::ranges::count(realNodes(anchors, nodes), true), 21);
    const auto split = withNodes(anchors, nodes, 5, 7, false, anchors.front());
    ASSERT_EQ(split.size(), 2u);
    EXPECT_NEAR(split[0].to.s, 0.45, 1e-12);
    EXPECT_NEAR(split[1].from.s, 0.75, 1e-12);
    EXPECT_TRUE(split[1].to.head);
    const auto real = realNodes(split, nodes);
    for (std::size_t i = 0; i < nodes.size(); ++i) EXPECT_EQ(real[i], i < 5 || i > 7) << i;
}

TEST(AnchorEdit, SingleAnchorsAreAddedAndRemovedAtTheirNodes) {
    const auto nodes = evenNodes(2.0, 60);
    const auto anchors = anchorsOfType("d-bolt-20");
    const auto before = realNodes(anchors, nodes);
    EXPECT_EQ(std::ranges::count(before, true), 4);
    const auto more = withNodes(anchors, nodes, 30, 30, true, anchors.front());
    EXPECT_TRUE(realNodes(more, nodes)[30]);
    EXPECT_EQ(more.back().stiffness, anchors.front().stiffness);
    EXPECT_EQ(realNodes(withNodes(more, nodes, 30, 30, false, anchors.front()), nodes), before);
}

TEST(AnchorEdit, AnyRequestedSetOfNodesIsTheResult) {
    std::mt19937 random(7);
    for (const char* type :
         {"rebar-20", "d-bolt-20", "split-set-47", "expansion-shell-17", "cone-bolt-17", "roofex-rx8"}) {
        const auto nodes = evenNodes(2.4, 24);
        std::vector<Anchor> anchors = anchorsOfType(type);
        const Anchor otherwise = anchors.front();
        for (int i = 0; i < 200; ++i) {
            const std::size_t first = random() % nodes.size(), last = first + random() % (nodes.size() - first);
            const bool real = random() % 2 == 0;
            auto wanted = realNodes(anchors, nodes);
            anchors = withNodes(anchors, nodes, first, last, real, otherwise);
            for (std::size_t n = first; n <= last; ++n) wanted[n] = real;
            ASSERT_EQ(realNodes(anchors, nodes), wanted) << type << ' ' << i;
        }
    }
}

TEST(AnchorStrip, ClickUnbondsANodeAndUndoBondsItAgain) {
    NEED_SCREEN();
    Themes themes;
    Display display;
    Document document;
    document.startNew(sampleScene("burst-rebar"));
    const Scene before = *document.scene();
    AnchorStrip strip(FormContext{document, display, themes}, nullptr);
    strip.resize(300, 120);
    strip.setObject("/bolts/0");
    strip.show();
    ASSERT_TRUE(waitFor([&] { return document.checkIsCurrent(); }));
    strip.refresh();
    AnchorLine& line = strip.line();
    ASSERT_GT(line.nodes().size(), 10u);
    EXPECT_TRUE(line.real()[6]);
    QTest::mouseClick(&line, Qt::LeftButton, {}, line.placeOf(6).toPoint());
    ASSERT_TRUE(document.scene()->bolts[0].anchors);
    EXPECT_EQ(std::ranges::count(strip.line().real(), false), 1);
    EXPECT_TRUE(document.undo().undoText().startsWith("Set nodes of"));
    ASSERT_TRUE(waitFor([&] { return document.checkIsCurrent(); }));
    EXPECT_FALSE(hasErrors(document.checked().problems));
    document.undo().undo();
    EXPECT_EQ(*document.scene(), before);
}

TEST(Library, EveryBuiltInTypeShowsItsValuesAndCurves) {
    NEED_SCREEN();
    Display display;
    const auto entries = libraryEntries(Scene{}, display, {});
    EXPECT_EQ(entries.size(), builtInBoltTypes().size());
    for (const LibraryEntry& entry : entries) {
        const auto numbers = libraryNumbers(entry.type, display);
        EXPECT_GT(numbers.size(), 10u) << entry.type.name;
        EXPECT_TRUE(std::ranges::any_of(numbers, [](const LibraryNumber& n) { return !n.source.isEmpty(); }))
            << entry.type.name;
        EXPECT_EQ(steelCurve(entry.type, display).points.empty(), entry.type.steel.empty()) << entry.type.name;
        for (const ShownCurve& curve : bondCurves(entry.type, display))
            EXPECT_GT(curve.points.size(), 1u) << entry.type.name;
        EXPECT_FALSE(bondCurves(entry.type, display).empty()) << entry.type.name;
    }
    EXPECT_EQ(libraryEntries(Scene{}, display, "split-set").size(), 1u);
}

TEST(Library, TensileStrengthOfTheTypeReplacesTheLargestStress) {
    NEED_SCREEN();
    Display display;
    Scene scene;
    BoltType& type = scene.boltTypes.emplace_back();
    type.name = "bar";
    type.diameter = 0.02;
    type.area = 2e-4;
    type.steel = {{0.0, 0.0}, {0.002, 400e6}, {0.1, 600e6}};
    EXPECT_TRUE(libraryEntries(scene, display, {}).front().detail.endsWith("80 / 120 kN"));
    type.tensileStrength = 500e6;
    EXPECT_TRUE(libraryEntries(scene, display, {}).front().detail.endsWith("80 / 100 kN"));
}

TEST(Library, BondCurvesHavePeakAndResidualStrength) {
    const Anchor bond = anchorsOfType("rebar-20").front();
    const Table curve = bondCurve(bond, 0.002);
    EXPECT_NEAR(curve[1].second, *bond.strength, 1e-9);
    EXPECT_NEAR(curve[1].first, *bond.strength / bond.stiffness, 1e-12);
    EXPECT_EQ(curve.back().second, bond.residual);
}

TEST(AnchorLine, DragEndsWhenTheNodesChange) {
    NEED_SCREEN();
    Themes themes;
    AnchorLine line(themes, nullptr);
    line.resize(300, 56);
    line.show();
    line.present(evenNodes(2.0, 60), std::vector<bool>(61, true), true, true);
    int painted = 0;
    QObject::connect(&line, &AnchorLine::painted, [&] { ++painted; });
    QTest::mousePress(&line, Qt::LeftButton, {}, line.placeOf(55).toPoint());
    line.present(evenNodes(2.0, 10), std::vector<bool>(11, true), true, true);
    line.repaint();
    QTest::mouseMove(&line, {20, 26});
    QTest::mouseRelease(&line, Qt::LeftButton, {}, {20, 26});
    EXPECT_EQ(painted, 0);
}

TEST(Library, CopyOfATypeCanBeEditedAndAssigned) {
    NEED_SCREEN();
    Themes themes;
    Display display;
    Document document;
    Selection selection;
    document.startNew(sampleScene("drift-bolted"));
    const Scene before = *document.scene();
    LibraryPanel panel(FormContext{document, display, themes}, selection);
    panel.show();
    panel.choose("rebar-20");
    panel.copyIntoScene();
    ASSERT_EQ(selection.pointers().size(), 1);
    const std::string pointer = selection.pointers().front().toStdString();
    const Edit thicker = setValueAt(*document.scene(), pointer + "/diameter", 0.025);
    ASSERT_TRUE(thicker.done()) << thicker.refusal;
    document.apply("thicker", thicker.scene);
    const std::string name = panel.chosen().toStdString();
    selection.set({"/bolt_patterns/0"});
    panel.assign();
    EXPECT_EQ(document.scene()->boltPatterns[0].type, name);
    ASSERT_TRUE(waitFor([&] { return document.checkIsCurrent(); }));
    EXPECT_FALSE(hasErrors(document.checked().problems));
    const SceneReading again = readSceneText(sceneText(*document.scene()), "again");
    ASSERT_TRUE(again.scene);
    EXPECT_EQ(sceneText(*again.scene), sceneText(*document.scene()));
    while (document.undo().canUndo()) document.undo().undo();
    EXPECT_EQ(*document.scene(), before);
}

}  // namespace
}  // namespace keyblock
