// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The Problems panel shows what is wrong and where; its links fix or show it.
#include "tests/ui/panels/form_bench.h"

#include "ui/document/selection.h"
#include "ui/edit/edits.h"
#include "ui/panels/problems/problems_panel.h"

namespace keyblock {
namespace {

struct ProblemsBench {
    Themes themes;
    Display display;
    Document document;
    Selection selection;
    ProblemsPanel panel{document, selection, display, themes};

    explicit ProblemsBench(Scene scene) {
        document.startNew(std::move(scene));
        panel.resize(800, 200);
        panel.show();
        settle();
    }

    void settle() {
        ASSERT_TRUE(waitFor([this] { return document.checkIsCurrent(); }));
        panel.refresh();
    }

    int rowWith(const QString& text) const {
        for (std::size_t i = 0; i < panel.list().rows().size(); ++i)
            if (panel.list().rows()[i].title.contains(text)) return static_cast<int>(i);
        return -1;
    }
};

TEST(Problems, LinkAddsTheMissingMaterial) {
    NEED_SCREEN();
    Scene scene = sampleScene("drift-bolted");
    scene.domain->material = "marble";
    ProblemsBench bench(std::move(scene));
    const int row = bench.rowWith("marble");
    ASSERT_GE(row, 0);
    EXPECT_EQ(bench.panel.list().rowAt(row).link, "Add marble");
    EXPECT_GE(bench.panel.urgent(), 1);
    bench.panel.follow(row);
    bench.settle();
    EXPECT_EQ(bench.document.scene()->materials.back().first, "marble");
    EXPECT_LT(bench.rowWith("marble"), 0);
    bench.document.undo().undo();
    EXPECT_EQ(bench.document.scene()->materials.size(), 1u);
}

TEST(Problems, LinkMergesTheSliversThatWereKept) {
    NEED_SCREEN();
    Scene scene = sampleScene("drift-bolted");
    scene.cutting.minArea = scene.cutting.minWidth = 0.0;
    scene.joints.push_back({"fault", {{-20.0, 1.0}, {3.0, 2.6}}, {}});
    ProblemsBench bench(std::move(scene));
    const int row = bench.rowWith("sliver");
    ASSERT_GE(row, 0);
    EXPECT_TRUE(bench.panel.list().rowAt(row).box);
    bench.panel.follow(row);
    bench.settle();
    EXPECT_FALSE(bench.document.scene()->cutting.minArea);
    EXPECT_LT(bench.rowWith("sliver"), 0);
}

TEST(Problems, ShowSelectsTheObjectAndZoomsToIt) {
    NEED_SCREEN();
    Scene scene = sampleScene("drift-bolted");
    scene.jointSets[1].spacing = -1.0;
    scene.tunnels[0].width = -2.0;
    ProblemsBench bench(std::move(scene));
    const int row = bench.rowWith("Joint set");
    ASSERT_GE(row, 0);
    QString field;
    QObject::connect(&bench.panel, &ProblemsPanel::fieldAsked, [&](const QString& pointer) { field = pointer; });
    bench.panel.showRow(row);
    EXPECT_EQ(bench.selection.pointers(), QStringList{"/joint_sets/1"});
    EXPECT_EQ(field, "/joint_sets/1/spacing");
}

TEST(Problems, CutReportListsItsNotes) {
    NEED_SCREEN();
    ProblemsBench bench(sampleScene("drift-bolted"));
    const int report = bench.rowWith("Cut report");
    ASSERT_GE(report, 0);
    const std::size_t notes = bench.document.checked().cut->notes.size();
    const std::size_t rows = bench.panel.list().rows().size();
    ASSERT_GT(notes, 0u);
    bench.panel.follow(report);
    EXPECT_GT(bench.panel.list().rows().size(), rows);
    bench.panel.follow(report);
    EXPECT_EQ(bench.panel.list().rows().size(), rows);
}

TEST(Problems, LinkRenamesAnObjectWithADuplicateName) {
    NEED_SCREEN();
    Scene scene = sampleScene("drift-bolted");
    scene.jointSets[1].name = scene.jointSets[0].name;
    ProblemsBench bench(std::move(scene));
    const int row = bench.rowWith("is already used");
    ASSERT_GE(row, 0);
    bench.panel.follow(row);
    EXPECT_NE(bench.document.scene()->jointSets[1].name, bench.document.scene()->jointSets[0].name);
}

/// Follows the link of the problem with that title; false if the problem is still there afterwards.
bool isSolvedByLink(ProblemsBench& bench, const QString& title, const QString& link) {
    const int row = bench.rowWith(title);
    if (row < 0 || bench.panel.list().rowAt(row).link != link) return false;
    bench.panel.follow(row);
    bench.settle();
    return bench.rowWith(title) < 0;
}

TEST(Problems, LinkOmitsARepeatedCorner) {
    NEED_SCREEN();
    Scene scene = sampleScene("drift-bolted");
    scene.domain->boundary.push_back(scene.domain->boundary.front());
    const std::size_t corners = scene.domain->boundary.size();
    ProblemsBench bench(std::move(scene));
    EXPECT_TRUE(isSolvedByLink(bench, "the last corner repeats the first", "Remove the corner"));
    EXPECT_EQ(bench.document.scene()->domain->boundary.size(), corners - 1);
}

TEST(Problems, LinkLeavesTheTimeStepToTheProgram) {
    NEED_SCREEN();
    Scene scene = sampleScene("drift-bolted");
    Stage& stage = scene.stages.emplace_back();
    stage.name = "burst";
    stage.kind = StageKind::Dynamic;
    stage.duration = 0.1;
    stage.timeStep = 0.2;
    ProblemsBench bench(std::move(scene));
    EXPECT_TRUE(isSolvedByLink(bench, "the time step is longer than the stage", "Use automatic value"));
    EXPECT_FALSE(bench.document.scene()->stages.back().timeStep);
}

TEST(Problems, LinkAddsAStage) {
    NEED_SCREEN();
    Scene scene = sampleScene("drift-bolted");
    scene.stages.clear();
    ProblemsBench bench(std::move(scene));
    EXPECT_TRUE(isSolvedByLink(bench, "The scene has no stages", "Add a stage"));
    EXPECT_EQ(bench.document.scene()->stages.size(), 1u);
}

}  // namespace
}  // namespace keyblock
