// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stage plan shows what is present in each stage, and clicks change it; the
// model summary has the same counts as the command line.
#include "tests/ui/panels/form_bench.h"

#include "solver/trade/trade.h"
#include "ui/document/selection.h"
#include "ui/edit/edits.h"
#include "ui/look/commands.h"
#include "ui/panels/stages/plan_view.h"
#include "ui/panels/stages/stages_panel.h"
#include "ui/panels/summary/model_summary_panel.h"
#include "ui/panels/summary/model_summary_rows.h"

#include <QLabel>
#include <QToolButton>
#include <QTreeWidget>

#include <algorithm>

namespace keyblock {
namespace {

Stage stageNamed(const char* name) {
    Stage stage;
    stage.name = name;
    return stage;
}

Scene planned() {
    Scene scene = sampleScene("drift-bolted");
    scene.stages = {stageNamed("settle"), stageNamed("dig"), stageNamed("bolt")};
    scene.stages[1].excavate = {scene.tunnels[0].name};
    scene.stages[2].install = {scene.boltPatterns[0].name};
    scene.monitors.clear();
    scene.quantities.clear();
    scene.about.expected.clear();
    return scene;
}

const PlanRow& rowNamed(const std::vector<PlanRow>& rows, const std::string& name) {
    return *std::ranges::find(rows, name, &PlanRow::name);
}

TEST(StagePlan, RockIsExcavatedAndBoltsInstalledByStages) {
    const Scene scene = planned();
    const auto rows = stagePlan(scene);
    const PlanRow& drift = rowNamed(rows, scene.tunnels[0].name);
    EXPECT_TRUE(drift.cells[0].there);
    EXPECT_EQ(drift.cells[1].event, PlanCell::Event::Excavated);
    EXPECT_FALSE(drift.cells[2].there);
    const PlanRow& bolts = rowNamed(rows, scene.boltPatterns[0].name);
    EXPECT_FALSE(bolts.cells[1].there);
    EXPECT_EQ(bolts.cells[2].event, PlanCell::Event::Installed);
}

TEST(StagePlan, ATunnelIsExcavatedInOneStageOnly) {
    const Scene scene = planned();
    const Edit edit = toggled(scene, rowNamed(stagePlan(scene), scene.tunnels[0].name), 0);
    ASSERT_TRUE(edit.done());
    EXPECT_EQ(edit.scene.stages[0].excavate.size(), 1u);
    EXPECT_TRUE(edit.scene.stages[1].excavate.empty());
    const Edit back = toggled(edit.scene, rowNamed(stagePlan(edit.scene), scene.tunnels[0].name), 0);
    EXPECT_TRUE(back.scene.stages[0].excavate.empty());
}

TEST(StagePlan, ClickRemovesAnInstalledBoltAndRestoresIt) {
    Scene scene = planned();
    scene.stages.push_back(stageNamed("later"));
    const std::string name = scene.boltPatterns[0].name;
    const Edit removed = toggled(scene, rowNamed(stagePlan(scene), name), 3);
    EXPECT_EQ(removed.scene.stages[3].remove, std::vector<std::string>{name});
    const Edit back = toggled(removed.scene, rowNamed(stagePlan(removed.scene), name), 3);
    EXPECT_EQ(back.scene, scene);
}

TEST(StagesPanel, ButtonsAddMoveDuplicateAndRemoveStagesWithUndo) {
    NEED_SCREEN();
    Themes themes;
    Display display;
    Document document;
    Selection selection;
    document.startNew(planned());
    const Scene before = *document.scene();
    StagesPanel panel(FormContext{document, display, themes}, selection);
    panel.show();
    const auto press = [&](const char* name) {
        for (QToolButton* button : panel.findChildren<QToolButton*>())
            if (button->accessibleName() == name) return QTest::mouseClick(button, Qt::LeftButton);
        FAIL() << "no button " << name;
    };
    press("Add a dynamic stage");
    ASSERT_EQ(document.scene()->stages.size(), 4u);
    EXPECT_EQ(document.scene()->stages[3].kind, StageKind::Dynamic);
    EXPECT_GT(document.scene()->stages[3].duration, 0.0);  // it can be run as it is
    EXPECT_EQ(selection.pointers(), QStringList{"/stages/3"});
    press("Move the stage earlier");
    EXPECT_EQ(document.scene()->stages[2].kind, StageKind::Dynamic);
    press("Duplicate the stage");
    ASSERT_EQ(document.scene()->stages.size(), 5u);
    EXPECT_EQ(document.scene()->stages[3].kind, StageKind::Dynamic);
    press("Remove the stage");
    press("Remove the stage");
    Q_EMIT panel.plan().cellChosen(0, 2);
    EXPECT_EQ(document.scene()->stages[2].excavate.size(), document.scene()->stages.size() > 2 ? 1u : 0u);
    while (document.undo().canUndo()) document.undo().undo();
    EXPECT_EQ(*document.scene(), before);
}

TEST(ModelSummaryPanel, ShowsTheCountsOfTheModel) {
    NEED_SCREEN();
    Themes themes;
    Commands commands(themes);
    Document document;
    document.startNew(sampleScene("burst-rebar"));
    ModelSummaryPanel panel(document, commands, themes);
    panel.resize(700, 220);
    panel.show();
    ASSERT_TRUE(waitFor([&] { return panel.summary() != nullptr; }));
    const auto& checked = document.checked();
    const Scene& solved = checked.cut ? checked.cut->scene : *checked.scene;
    const ModelSummary direct = *makeModelSummary(solved, checked.cut.get());
    EXPECT_EQ(panel.summary()->counts.unknowns(), direct.counts.unknowns());
    const auto rows = modelSummaryRows(*panel.summary());
    EXPECT_EQ(rows.front().count, Display::number(direct.counts.blocks, 12));
    Scene broken = *document.scene();
    broken.domain->material = "nothing";
    document.apply("break", broken);
    EXPECT_FALSE(panel.summary());
    ASSERT_TRUE(waitFor([&] { return document.checkIsCurrent(); }));
    const auto isRefused = [&] {
        const QList<QLabel*> labels = panel.findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(),
                           [](const QLabel* label) { return label->text().startsWith("Fix the errors"); });
    };
    ASSERT_TRUE(waitFor(isRefused));
    settle();
    EXPECT_FALSE(panel.summary());
}

/// A trade that was measured in the window is quoted while the scene is the one that was measured.
TEST(ModelSummaryPanel, QuotesATradeOfTheSceneThatWasMeasured) {
    NEED_SCREEN();
    Themes themes;
    Commands commands(themes);
    Document document;
    Scene scene = sampleScene("burst-rebar");
    scene.bolts.front().divisions = 120;
    document.startNew(scene);
    ModelSummaryPanel panel(document, commands, themes);
    panel.resize(700, 220);
    panel.show();
    const auto pointOf = [](const std::string& axis, const std::string& setting, double seconds, double value) {
        TradePoint point;
        point.axis = axis, point.setting = setting, point.seconds = seconds;
        point.unknowns = static_cast<int>(100.0 * seconds);
        point.values = {Measurement{value, {}, {}}};
        return point;
    };
    const auto quoted = [&] {
        for (const ModelSummaryRow& row : modelSummaryRows(*panel.summary()))
            if (row.next && row.why.contains("measured by 'trade'")) return row.what + ": " + row.why;
        return QString();
    };
    ASSERT_TRUE(waitFor([&] { return panel.summary() != nullptr; }));
    EXPECT_EQ(quoted(), QString());
    panel.setTrade({document.committed(),
                    {"max B.axial_force"},
                    {pointOf(ownPoint, "", 10.0, 100.0), pointOf("divisions", "60", 5.5, 100.4)}});
    ASSERT_TRUE(waitFor([&] { return panel.summary() != nullptr; }));
    const QString text = quoted();
    EXPECT_TRUE(text.startsWith("divisions 120 → 60") && text.contains("0.4 % in max B.axial_force") &&
                text.contains("45 % of the time"))
        << text.toStdString();
    panel.resize(480, 220);  // no room for a column of remarks
    const auto isShown = [&] {
        const QList<QLabel*> labels = panel.findChildren<QLabel*>();
        return std::any_of(labels.begin(), labels.end(),
                           [](const QLabel* label) { return label->text().contains("saves 45 % of the time"); });
    };
    EXPECT_TRUE(waitFor(isShown, 1000));
    scene.bolts.front().divisions = 90;
    document.apply("divisions", scene);
    ASSERT_TRUE(waitFor([&] { return panel.summary() != nullptr; }));
    EXPECT_EQ(quoted(), QString()) << "another scene";
    document.undo().undo();
    ASSERT_TRUE(waitFor([&] { return panel.summary() != nullptr; }));
    EXPECT_EQ(quoted(), text);
}

TEST(ModelSummaryRows, TimesAndMemoryAreRounded) {
    EXPECT_EQ(costText(0.3), "< 1 s");
    EXPECT_EQ(costText(42.0), "42 s");
    EXPECT_EQ(costText(110.0), "1 min 50 s");
    EXPECT_EQ(costText(119.0), "2 min");
    EXPECT_EQ(costText(7200.0), "2 h");
    EXPECT_EQ(memoryText(214e6), "210 MB");
}

}  // namespace
}  // namespace keyblock
