// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tree shows the objects of the scene and keeps rows open; tree and selection
// follow each other; hidden objects are not drawn.
#include "tests/ui/panels/form_bench.h"

#include "ui/document/selection.h"
#include "ui/document/visibility.h"
#include "ui/document/visible_picture.h"
#include "ui/edit/edits.h"
#include "ui/look/commands.h"
#include "ui/panels/tree/scene_tree.h"
#include "ui/panels/tree/tree_model.h"
#include "ui/panels/tree/tree_nodes.h"
#include "ui/panels/tree/tree_view.h"
#include "ui/picture/section/section.h"

#include <QItemSelectionModel>

#include <algorithm>

namespace keyblock {
namespace {

struct TreeBench {
    Themes themes;
    Display display;
    Commands commands{themes};
    Document document;
    Selection selection;
    Visibility visibility{document};
    SceneTree tree{document, selection, visibility, display, commands, themes};

    explicit TreeBench(Scene scene) {
        selection.follow(document);
        document.startNew(std::move(scene));
        tree.resize(236, 700);
        tree.show();
        tree.refresh();
    }

    TreeModel& model() { return *static_cast<TreeModel*>(tree.view().model()); }
    QModelIndex at(const QString& id) { return model().indexOf(id); }
};

std::size_t rowsUnder(const TreeNode& node) {
    std::size_t rows = node.children.size();
    for (const auto& child : node.children) rows += rowsUnder(*child);
    return rows;
}

Scene wall(int columns, int rows) {
    Scene scene = sampleScene("drift-bolted");
    scene.domain.reset();
    scene.joints.clear();
    scene.jointSets.clear();
    scene.tunnels.clear();
    scene.boltPatterns.clear();
    scene.stages.clear();
    for (int j = 0; j < rows; ++j)
        for (int i = 0; i < columns; ++i) {
            Block block;
            block.name = std::to_string(i) + "-" + std::to_string(j);
            block.points = {Point(i, j), Point(i + 1, j), Point(i + 1, j + 1), Point(i, j + 1)};
            block.material = scene.materials[0].first;
            scene.blocks.push_back(block);
        }
    return scene;
}

TEST(SceneTree, TreeAndSelectionFollowEachOther) {
    NEED_SCREEN();
    TreeBench bench(sampleScene("drift-bolted"));
    ASSERT_TRUE(bench.at("/joint_sets/1").isValid());
    bench.tree.view().setCurrentIndex(bench.at("/joint_sets/1"));
    EXPECT_EQ(bench.selection.pointers(), QStringList{"/joint_sets/1"});
    bench.selection.set({"/tunnels/0"});
    EXPECT_TRUE(bench.tree.view().selectionModel()->isSelected(bench.at("/tunnels/0")));
    EXPECT_FALSE(bench.tree.view().selectionModel()->isSelected(bench.at("/joint_sets/1")));
}

TEST(SceneTree, InSituStressIsAddedOnceAndSelected) {
    NEED_SCREEN();
    Scene scene = sampleScene("drift-bolted");
    scene.inSituStress.reset();
    TreeBench bench(scene);
    bench.tree.addInSituStress();
    ASSERT_TRUE(bench.document.scene()->inSituStress);
    EXPECT_EQ(bench.selection.pointers(), QStringList{"/in_situ_stress"});
    bench.selection.set({});
    bench.tree.addInSituStress();
    EXPECT_EQ(bench.selection.pointers(), QStringList{"/in_situ_stress"});
    EXPECT_EQ(bench.document.undo().count(), 1);
}

TEST(SceneTree, FiveThousandBlocksAreListedOnlyWhenOpened) {
    NEED_SCREEN();
    TreeBench bench(wall(100, 50));
    const QModelIndex blocks = bench.at("/blocks");
    ASSERT_TRUE(blocks.isValid());
    EXPECT_EQ(bench.model().rowCount(blocks), 0);
    EXPECT_TRUE(bench.model().hasChildren(blocks));
    const std::vector<RunRow> noRuns;
    EXPECT_LT(rowsUnder(*makeTree({bench.document, bench.display, noRuns, {}})), 100u) << "a refresh makes these rows";
    bench.tree.refresh();
    EXPECT_EQ(bench.model().rowCount(bench.at("/blocks")), 0);
    bench.selection.set({"/blocks/4321"});  // opens the lists above it
    EXPECT_EQ(bench.model().rowCount(bench.at("/blocks")), 5000);
    EXPECT_TRUE(bench.tree.view().selectionModel()->isSelected(bench.at("/blocks/4321")));
}

TEST(SceneTree, OpenListsStayOpenWhenObjectsAreAdded) {
    NEED_SCREEN();
    TreeBench bench(sampleScene("drift-bolted"));
    bench.tree.view().expand(bench.at("/stages"));
    bench.tree.view().collapse(bench.at("/joint_sets"));
    bench.document.apply("add", appendAt(*bench.document.scene(), "/materials").scene);
    bench.tree.refresh();
    EXPECT_TRUE(bench.tree.view().isExpanded(bench.at("/stages")));
    EXPECT_FALSE(bench.tree.view().isExpanded(bench.at("/joint_sets")));
}

TEST(SceneTree, RenamingInTheTreeUpdatesReferences) {
    NEED_SCREEN();
    TreeBench bench(sampleScene("drift-bolted"));
    const QString pointer = QString::fromStdString("/materials/" + bench.document.scene()->materials[0].first);
    ASSERT_TRUE(bench.model().setData(bench.at(pointer), "gneiss", Qt::EditRole));
    EXPECT_EQ(bench.document.scene()->domain->material, "gneiss");
    bench.tree.refresh();
    EXPECT_TRUE(bench.at("/materials/gneiss").isValid());
}

TEST(SceneTree, RefusedNameIsReported) {
    NEED_SCREEN();
    TreeBench bench(sampleScene("drift-bolted"));
    QString said;
    QObject::connect(&bench.document, &Document::reported, [&](const QString& text) { said = text; });
    const QString taken = QString::fromStdString(bench.document.scene()->jointSets[0].name);
    bench.model().setData(bench.at("/joint_sets/1"), taken, Qt::EditRole);
    EXPECT_TRUE(said.contains("is already used")) << said.toStdString();
    EXPECT_EQ(bench.document.undo().count(), 0);
}

TEST(SceneTree, SelectionKeepsItsObjectsThroughUndo) {
    NEED_SCREEN();
    TreeBench bench(sampleScene("drift-bolted"));
    const std::string second = bench.document.scene()->jointSets[1].name;
    bench.selection.set({"/joint_sets/1"});
    bench.document.apply("remove", removeAt(*bench.document.scene(), "/joint_sets/0"));
    EXPECT_EQ(bench.selection.pointers(), QStringList{"/joint_sets/0"});
    EXPECT_EQ(bench.document.scene()->jointSets[0].name, second);
    bench.document.undo().undo();
    EXPECT_EQ(bench.selection.pointers(), QStringList{"/joint_sets/1"});
    bench.document.undo().redo();
    EXPECT_EQ(bench.selection.pointers(), QStringList{"/joint_sets/0"});
    bench.document.apply("add", appendAt(*bench.document.scene(), "/joint_sets"));
    const auto last = static_cast<int>(bench.document.scene()->jointSets.size()) - 1;
    bench.selection.set({QString("/joint_sets/%1").arg(last)});
    bench.document.undo().undo();
    EXPECT_TRUE(bench.selection.isEmpty()) << "the selected object no longer exists";
}

TEST(SceneTree, OpenListOfThousandsStaysOpenAndIsSelectedAtOnce) {
    NEED_SCREEN();
    TreeBench bench(wall(100, 50));
    bench.selection.set({"/blocks/4321"});
    bench.tree.refresh();
    const QPersistentModelIndex row = bench.at("/blocks/4321");
    bench.document.apply("title", [&] {
        Scene scene = *bench.document.scene();
        scene.blocks[4321].material = "other";
        return scene;
    }());
    bench.tree.refresh();
    EXPECT_TRUE(row.isValid()) << "unchanged rows are not rebuilt";
    QStringList all;
    for (int i = 0; i < 5000; ++i) all << QString("/blocks/%1").arg(i);
    const QItemSelectionModel& selected = *bench.tree.view().selectionModel();
    int changes = 0;
    QObject::connect(&selected, &QItemSelectionModel::selectionChanged, [&] { ++changes; });
    bench.selection.set(all);
    EXPECT_EQ(selected.selectedIndexes().size(), 5000);
    EXPECT_EQ(selected.selection().size(), 1) << "consecutive rows are selected as one range";
    EXPECT_EQ(changes, 1);
}

TEST(SceneTree, FilterKeepsRowsThatContainItsText) {
    NEED_SCREEN();
    TreeBench bench(sampleScene("drift-bolted"));
    bench.tree.findChild<QLineEdit*>()->setText("J2");
    EXPECT_TRUE(bench.at("/joint_sets/1").isValid());
    EXPECT_FALSE(bench.at("/joint_sets/0").isValid());
    EXPECT_FALSE(bench.at("/tunnels").isValid());
}

TEST(SceneTree, DeletingRemovesTheSelectedObjects) {
    NEED_SCREEN();
    TreeBench bench(sampleScene("drift-bolted"));
    const Scene before = *bench.document.scene();
    bench.selection.set({"/joint_sets/0"});
    bench.commands.add({"edit.delete", "Delete", "Edit", {}, {}, {QKeySequence::Delete}}, [] {});
    QTest::keyClick(&bench.tree.view(), Qt::Key_Delete);
    EXPECT_EQ(bench.document.scene()->jointSets.size(), before.jointSets.size() - 1);
    EXPECT_TRUE(bench.selection.isEmpty());
    bench.document.undo().undo();
    EXPECT_EQ(*bench.document.scene(), before);
}

TEST(Visibility, HiddenObjectsStayHiddenWhenOthersAreDeleted) {
    NEED_SCREEN();
    TreeBench bench(sampleScene("drift-bolted"));
    bench.visibility.setHidden("/joint_sets/1", true);
    bench.document.apply("remove", removeAt(*bench.document.scene(), "/joint_sets/0").scene);
    EXPECT_TRUE(bench.visibility.isHidden("/joint_sets/0"));
    EXPECT_FALSE(bench.visibility.isHidden("/joint_sets/1"));
}

TEST(Visibility, HiddenObjectsStayHiddenThroughRenamingAndUndo) {
    NEED_SCREEN();
    TreeBench bench(sampleScene("drift-bolted"));
    bench.visibility.setHidden("/joint_sets/1", true);
    bench.visibility.setLocked("/joint_sets/0", true);
    bench.document.apply("rename", renameAt(*bench.document.scene(), "/joint_sets/1", "steep"));
    EXPECT_TRUE(bench.visibility.isHidden("/joint_sets/1"));
    EXPECT_FALSE(bench.visibility.isHidden("/joint_sets/0"));
    EXPECT_TRUE(bench.visibility.isLocked("/joint_sets/0"));
    bench.document.undo().undo();
    EXPECT_TRUE(bench.visibility.isHidden("/joint_sets/1"));
    bench.document.undo().redo();
    bench.document.apply("remove", removeAt(*bench.document.scene(), "/joint_sets/0"));
    EXPECT_TRUE(bench.visibility.isHidden("/joint_sets/0"));
    bench.document.undo().undo();
    EXPECT_TRUE(bench.visibility.isHidden("/joint_sets/1"));
    EXPECT_TRUE(bench.visibility.isLocked("/joint_sets/0"));  // it was restored under its name
}

TEST(Visibility, HiddenObjectsAreNotDrawn) {
    NEED_SCREEN();
    TreeBench bench(sampleScene("drift-bolted"));
    ASSERT_TRUE(waitFor([&] { return bench.document.checkIsCurrent() && bench.document.checked().picture; }));
    const Checked& checked = bench.document.checked();
    EXPECT_EQ(visiblePicture(checked, bench.visibility), checked.picture);
    bench.visibility.setHidden("/bolt_patterns/0", true);
    EXPECT_TRUE(visiblePicture(checked, bench.visibility)->bolts.empty());
    bench.visibility.setHidden("/joint_sets/0", true);
    std::ptrdiff_t hidden = 0, shown = 0;
    const auto picture = visiblePicture(checked, bench.visibility);
    for (const BlockShape& block : picture->blocks) {
        hidden += std::ranges::count(block.edgesHidden, char{1});
        shown += std::ranges::count(block.edgesHidden, char{0});
    }
    EXPECT_GT(hidden, 100);
    EXPECT_GT(shown, 100);
    bench.visibility.showAll();
    EXPECT_EQ(visiblePicture(checked, bench.visibility), checked.picture);
}

}  // namespace
}  // namespace keyblock
