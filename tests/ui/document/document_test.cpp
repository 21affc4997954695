// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Undo by value: an edit is a step, an edit without change and a preview are not,
// and undo restores the first scene to the byte.
#include "tests/scratch_folder.h"
#include "tests/ui/screen/screen.h"

#include "solver/files/scene/scene_file.h"
#include "ui/document/document.h"
#include "ui/document/file_watch.h"

#include <QTimer>
#include <QUndoStack>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <vector>

namespace keyblock {
namespace {

Scene titled(const std::string& title) {
    Scene scene;
    scene.title = title;
    return scene;
}

TEST(Documents, EditIsAStepAndUndoRestoresTheScene) {
    NEED_SCREEN();
    Document document;
    document.startNew(titled("first"));
    const std::string before = wholeSceneText(*document.scene());
    document.apply("Name it", titled("second"));
    EXPECT_EQ(document.scene()->title, "second");
    EXPECT_EQ(document.undo().undoText(), "Name it");
    EXPECT_TRUE(document.isModified());
    document.undo().undo();
    EXPECT_EQ(wholeSceneText(*document.scene()), before);
    EXPECT_FALSE(document.isModified());
}

TEST(Documents, DestroyedDocumentEmitsNothing) {
    NEED_SCREEN();
    int count = 0;
    {
        Document document;
        document.apply("Name it", titled("second"));
        QObject::connect(&document.undo(), &QUndoStack::indexChanged, [&] { ++count; });
        QObject::connect(&document, &Document::fileChanged, [&] { ++count; });
    }
    EXPECT_EQ(count, 0);
}

TEST(Documents, MissingFileIsSignalledOnceAlsoIfModified) {
    NEED_SCREEN();
    const test::ScratchFolder scratch;
    for (const bool isModified : {false, true}) {
        Document document;
        document.save(QString::fromStdString((scratch.path() / "a.json").string()));
        if (isModified) document.apply("Name it", titled("second"));
        int count = 0;
        QObject::connect(&document, &Document::fileChanged, [&] { ++count; });
        document.fileIsGone();
        EXPECT_EQ(count, 1);
        EXPECT_TRUE(document.isModified());
    }
}

TEST(Documents, EditWithoutChangeAddsNoStep) {
    NEED_SCREEN();
    Document document;
    document.startNew(titled("first"));
    document.apply("Nothing", titled("first"));
    EXPECT_EQ(document.undo().count(), 0);
}

TEST(Documents, SceneOpenedAfterUnsavedWorkIsNotModified) {
    NEED_SCREEN();
    Document document;
    document.startNew(titled("imported"), "imported", true);
    EXPECT_TRUE(document.isModified());
    document.startNew(titled("second"));
    EXPECT_FALSE(document.isModified());
    document.startNew(titled("imported"), "imported", true);
    EXPECT_TRUE(document.open(KEYBLOCK_SAMPLES_DIR "/rebar-20.json").empty());
    EXPECT_FALSE(document.isModified());
}

TEST(Documents, PreviewIsShownAndDiscarded) {
    NEED_SCREEN();
    Document document;
    document.startNew(titled("first"));
    document.preview(titled("dragged"));
    EXPECT_EQ(document.scene()->title, "dragged");
    EXPECT_EQ(document.committed()->title, "first");
    document.endPreview();
    EXPECT_EQ(document.scene()->title, "first");
    EXPECT_EQ(document.undo().count(), 0);
}

TEST(Documents, SampleIsOpenedCheckedAndCut) {
    NEED_SCREEN();
    Document document;
    EXPECT_TRUE(document.open(KEYBLOCK_SAMPLES_DIR "/drift-bolted.json").empty());
    ASSERT_TRUE(waitFor([&] { return document.checkIsCurrent(); }));
    ASSERT_TRUE(document.checked().cut);
    EXPECT_GT(document.checked().cut->blocks, 100);
    EXPECT_FALSE(hasErrors(document.checked().problems));
}

TEST(Documents, DrawingShowsOpeningsAndAllBolts) {
    NEED_SCREEN();
    Document document;
    ASSERT_TRUE(document.open(KEYBLOCK_SAMPLES_DIR "/drift-bolted.json").empty());
    ASSERT_TRUE(waitFor([&] { return document.checkIsCurrent(); }));
    const Checked& checked = document.checked();
    ASSERT_TRUE(checked.picture);
    EXPECT_EQ(checked.picture->bolts.size(), checked.cut->scene.bolts.size());  // some are installed in a later stage
    EXPECT_LT(checked.picture->blocks.size(), checked.cut->scene.blocks.size());  // the rock in the tunnel is not drawn
    EXPECT_FALSE(checked.picture->walls.empty());
    for (const BoltShape& bolt : checked.picture->bolts)
        EXPECT_TRUE(std::ranges::any_of(bolt.marks, [](const Mark& mark) { return mark.kind == MarkKind::Bonded; }))
            << bolt.name;
}

TEST(Documents, EverySampleThatHasBlocksIsDrawn) {
    for (const auto& entry : std::filesystem::directory_iterator(KEYBLOCK_SAMPLES_DIR)) {
        if (entry.path().extension() != ".json") continue;
        const SceneReading reading = readSceneFile(entry.path());
        ASSERT_TRUE(reading.scene) << entry.path();
        const SectionPicture picture = drawingPicture(reading.cut ? reading.cut->scene : *reading.scene);
        EXPECT_FALSE(picture.blocks.empty()) << entry.path();
    }
}

TEST(Documents, FailedOpeningIsReportedAndChangesNothing) {
    NEED_SCREEN();
    Document document;
    document.startNew(titled("kept"));
    const std::vector<Problem> problems = document.open("/nowhere/at-all.json");
    ASSERT_FALSE(problems.empty());
    EXPECT_EQ(document.scene()->title, "kept");
}

TEST(Documents, ReadablePartOfAFileWithErrorsOpensAsANewScene) {
    NEED_SCREEN();
    const test::ScratchFolder scratch;
    const std::filesystem::path file = scratch.path() / "half.json";
    const std::string whole = test::contentOf(KEYBLOCK_SAMPLES_DIR "/tower-100.json");
    test::putContent(file, whole.substr(0, whole.size() / 2));
    Document document;
    PartReading read;
    QObject::connect(&document, &Document::readInPart, [&](const PartReading& reading) { read = reading; });
    const QString path = QString::fromStdString(file.string());
    EXPECT_FALSE(document.open(path).empty());
    EXPECT_TRUE(document.openPart(path));
    EXPECT_TRUE(read.isOpen);
    EXPECT_GT(document.scene()->blocks.size(), 10u);
    EXPECT_TRUE(document.path().isEmpty());
    EXPECT_TRUE(document.isModified());
    ASSERT_FALSE(read.problems.empty());
    EXPECT_GT(read.problems.front().line, 1);
    EXPECT_EQ(read.text.size(), int(whole.size() / 2));
}

TEST(Documents, SceneWithCheckErrorsOpensUnchanged) {
    NEED_SCREEN();
    const test::ScratchFolder scratch;
    const QString path = QString::fromStdString((scratch.path() / "unfinished.json").string());
    {
        Document document;
        Scene scene;
        scene.bolts.push_back({});
        scene.bolts.back().type = "d-bolt-20";
        document.apply("Add bolt", scene);
        document.save(path);
    }
    Document document;
    EXPECT_TRUE(document.open(path).empty());
    EXPECT_EQ(document.path(), path);
    EXPECT_EQ(document.scene()->bolts.size(), 1u);
}

TEST(Documents, UnknownNameDoesNotMakeTheOpeningPartial) {
    NEED_SCREEN();
    const test::ScratchFolder scratch;
    const QString path = QString::fromStdString((scratch.path() / "type-gone.json").string());
    Document document;
    Scene scene;
    scene.bolts.push_back({});
    scene.bolts.back().type = "theirs";
    document.apply("Add bolt", scene);
    document.save(path);
    Document again;
    EXPECT_TRUE(again.open(path).empty());
    EXPECT_EQ(again.path(), path);
    EXPECT_EQ(again.scene()->bolts.at(0).type, "theirs");
}

TEST(Documents, FieldsThatDoNotApplyAreNeitherKeptNorSaved) {
    NEED_SCREEN();
    const test::ScratchFolder scratch;
    const QString path = QString::fromStdString((scratch.path() / "kind.json").string());
    Document document;
    Scene scene;
    scene.stages.resize(1);
    scene.stages[0].name = "shake";
    scene.stages[0].kind = StageKind::Dynamic;
    scene.stages[0].duration = 1.0;
    scene.stages[0].increments = 5;
    document.apply("Set kind", scene);
    EXPECT_FALSE(document.scene()->stages[0].increments);
    document.save(path);
    EXPECT_TRUE(document.open(path).empty());
}

TEST(Documents, SavingIsSignalledOnce) {
    NEED_SCREEN();
    const test::ScratchFolder scratch;
    const QString path = QString::fromStdString((scratch.path() / "scene.json").string());
    Document document;
    document.apply("Set title", titled("saved"));
    std::vector<bool> modified;
    QObject::connect(&document, &Document::fileChanged, [&] { modified.push_back(document.isModified()); });
    document.save(path);
    EXPECT_EQ(modified, std::vector{false});
}

TEST(Documents, OvertakenCheckIsStopped) {
    const SceneReading reading = readSceneFile(KEYBLOCK_SAMPLES_DIR "/drift-bolted.json");
    ASSERT_TRUE(reading.scene);
    const std::atomic<bool> stop{true};
    const auto checked = checkedOf(std::make_shared<const Scene>(*reading.scene), &stop);
    EXPECT_FALSE(checked->picture);
}

/// Until the watch has looked at the file, if the system has reported a change of it so far.
void waitForLook(const FileWatch& watch) {
    const auto* before = watch.findChild<QTimer*>(QString(), Qt::FindDirectChildrenOnly);  // a look
    ASSERT_TRUE(before);
    settle();
    ASSERT_TRUE(waitFor([&] { return !before->isActive(); }));
    settle();
}

TEST(Documents, DocumentWithRemovedFileIsModified) {
    NEED_SCREEN();
    const test::ScratchFolder scratch;
    const QString path = QString::fromStdString((scratch.path() / "scene.json").string());
    Document document;
    FileWatch watch(document);
    int gone = 0;
    QObject::connect(&watch, &FileWatch::goneFromDisk, [&] { ++gone; });
    document.save(path);
    std::filesystem::remove(path.toStdString());
    EXPECT_TRUE(waitFor([&] { return gone == 1; }));
    EXPECT_TRUE(document.isModified());
    document.save(path);
    EXPECT_FALSE(document.isModified());
    waitForLook(watch);
    EXPECT_EQ(gone, 1);
}

TEST(Documents, WritesByOtherProgramsAreNoticedButNotOurOwn) {
    NEED_SCREEN();
    const test::ScratchFolder scratch;
    const QString path = QString::fromStdString((scratch.path() / "scene.json").string());
    Document document;
    FileWatch watch(document);
    int noticed = 0;
    QObject::connect(&watch, &FileWatch::changedOnDisk, [&] { ++noticed; });
    document.save(path);
    document.apply("Set title", titled("ours"));
    document.save(path);
    waitForLook(watch);
    EXPECT_EQ(noticed, 0);
    test::putContent(path.toStdString(), sceneText(titled("theirs")));
    EXPECT_TRUE(waitFor([&] { return noticed == 1; }));
}

}  // namespace
}  // namespace keyblock
