// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A document is recovered from its journal with its undo steps; damage is reported
// and does no harm; windows do not touch each other's journals.
#include "tests/scratch_folder.h"
#include "tests/ui/screen/screen.h"

#include "solver/files/scene/scene_file.h"
#include "ui/document/document.h"
#include "ui/document/journal_text.h"
#include "ui/document/recovery.h"

#include <QDir>
#include <QFile>
#include <QStringList>
#include <QUndoStack>
#include <gtest/gtest.h>

#include <sys/resource.h>

#include <csignal>

namespace keyblock {
namespace {

Scene journalled(const std::string& title) {
    Scene scene;
    scene.title = title;
    return scene;
}

/// Text of the scene after a step.
std::string textOf(const Journalled& journal, std::size_t step) {
    std::string text;
    for (std::size_t i = 0; i <= step; ++i) text = textAfter(journal.steps[i], text);
    return text;
}

/// A document with its journal, as after a crash.
struct Window {
    explicit Window(const QString& folder) : journal(document, folder) {}
    Document document;
    Journal journal;
};

class Journals : public testing::Test {
protected:
    void SetUp() override { NEED_SCREEN(); }
    QString folder() const { return QString::fromStdString((scratch_.path() / "journals").string()); }
    QString file(const char* name) const { return QString::fromStdString((scratch_.path() / name).string()); }

    test::ScratchFolder scratch_;
};

TEST_F(Journals, EditsAreRecoveredWithTheirUndoSteps) {
    std::string first, last;
    {
        Window window(folder());
        ASSERT_TRUE(window.document.open(KEYBLOCK_SAMPLES_DIR "/drift-bolted.json").empty());
        first = wholeSceneText(*window.document.scene());
        Scene scene = *window.document.scene();
        scene.title = "Drift, „bolted“ – 2 m";
        window.document.apply("Set title", scene);
        scene.jointSets.pop_back();
        window.document.apply("Delete joint set", scene);
        scene.analysis.thickness = 2.0;
        window.document.apply("Set thickness", scene);
        window.document.undo().undo();
        last = wholeSceneText(*window.document.scene());
    }
    const std::vector<Abandoned> found = abandonedJournals(folder());
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].title, "drift-bolted.json");
    EXPECT_EQ(found[0].changes, 4u);
    Window next(folder());
    EXPECT_EQ(recover(found[0], Recover::Everything, next.document, next.journal), "");
    EXPECT_EQ(wholeSceneText(*next.document.scene()), last);
    EXPECT_TRUE(next.document.isModified());
    EXPECT_EQ(next.document.undo().undoText(), "Delete joint set");
    EXPECT_EQ(next.document.undo().redoText(), "Set thickness");
    next.document.undo().setIndex(0);
    EXPECT_EQ(wholeSceneText(*next.document.scene()), first);
    EXPECT_FALSE(next.document.isModified());
    EXPECT_FALSE(QFile::exists(found[0].journal));
}

TEST_F(Journals, RecoveryCanLeaveOutTheLastCommand) {
    {
        Window window(folder());
        window.document.startNew(journalled("first"));
        window.document.apply("Good", journalled("good"));
        window.document.apply("Bad", journalled("bad"));
    }
    const std::vector<Abandoned> found = abandonedJournals(folder());
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].lastStep, "Bad");
    Window next(folder());
    EXPECT_EQ(recover(found[0], Recover::WithoutLastCommand, next.document, next.journal), "");
    EXPECT_EQ(next.document.scene()->title, "good");
    EXPECT_FALSE(next.document.undo().canRedo());
}

TEST_F(Journals, RecoveredDocumentIsJournalledAgain) {
    {
        Window window(folder());
        window.document.startNew(journalled("first"));
        window.document.apply("Name", journalled("second"));
    }
    {
        Window again(folder());
        const std::vector<Abandoned> found = abandonedJournals(folder());
        ASSERT_EQ(found.size(), 1u);
        EXPECT_EQ(recover(found[0], Recover::Everything, again.document, again.journal), "");
        again.document.apply("Name again", journalled("third"));
    }
    const std::vector<Abandoned> found = abandonedJournals(folder());
    ASSERT_EQ(found.size(), 1u);
    Window last(folder());
    EXPECT_EQ(recover(found[0], Recover::Everything, last.document, last.journal), "");
    EXPECT_EQ(last.document.scene()->title, "third");
    EXPECT_EQ(last.document.undo().count(), 2);
}

TEST_F(Journals, ClosedOrSavedDocumentLeavesNoJournal) {
    {
        Window closed(folder());
        closed.document.apply("Name", journalled("second"));
        closed.journal.close();
        Window saved(folder());
        saved.document.apply("Name", journalled("second"));
        saved.document.save(file("scene.json"));
        Window replaced(folder());
        replaced.document.apply("Name", journalled("second"));
        replaced.document.startNew({});
    }
    EXPECT_TRUE(abandonedJournals(folder()).empty());
    EXPECT_TRUE(QDir(folder()).entryList({"*.journal"}, QDir::Files).isEmpty());
}

TEST_F(Journals, EditsAfterSavingBelongToTheFile) {
    {
        Window window(folder());
        window.document.apply("Name", journalled("second"));
        window.document.save(file("scene.json"));
        window.document.apply("Name", journalled("third"));
    }
    const std::vector<Abandoned> found = abandonedJournals(folder());
    ASSERT_EQ(found.size(), 1u);
    Window next(folder());
    EXPECT_EQ(recover(found[0], Recover::Everything, next.document, next.journal), "");
    EXPECT_EQ(next.document.path(), file("scene.json"));
    EXPECT_TRUE(next.document.isModified());
    next.document.undo().undo();
    EXPECT_FALSE(next.document.isModified());
}

TEST_F(Journals, JournalOfAnOpenWindowIsSkipped) {
    Window window(folder());
    window.document.apply("Name", journalled("second"));
    window.journal.flush();
    EXPECT_TRUE(abandonedJournals(folder()).empty());
    EXPECT_TRUE(QFile::exists(window.journal.path()));
}

TEST_F(Journals, DamageIsReportedAndEarlierLinesAreRecovered) {
    {
        Window window(folder());
        for (const char* title : {"a", "b", "c"}) window.document.apply("Name", journalled(title));
    }
    const QString journal = abandonedJournals(folder()).at(0).journal;
    std::string content = test::contentOf(journal.toStdString());
    content[content.size() - 10] ^= 1;  // in the last line
    test::putContent(journal.toStdString(), content);
    const std::vector<Abandoned> found = abandonedJournals(folder());
    ASSERT_EQ(found.size(), 1u);
    EXPECT_TRUE(found[0].damage.contains("line 4"));
    Window next(folder());
    EXPECT_EQ(recover(found[0], Recover::Everything, next.document, next.journal), "");
    EXPECT_EQ(next.document.scene()->title, "b");
    EXPECT_TRUE(QFile::exists(journal + ".damaged"));
}

TEST_F(Journals, AnyBytesAreReadSafely) {
    {
        Window window(folder());
        for (const char* title : {"a", "b", "c"}) window.document.apply("Name", journalled(title));
    }
    const std::string whole = test::contentOf(abandonedJournals(folder()).at(0).journal.toStdString());
    for (std::size_t end = 0; end <= whole.size(); ++end) {
        const Journalled read = readJournal(std::string_view(whole).substr(0, end));
        EXPECT_EQ(read.damage, "") << end;  // cut off, not damaged
        EXPECT_LE(read.changes, 3u);
    }
    for (std::size_t place = 0; place < whole.size(); ++place) {
        std::string bent = whole;
        bent[place] = static_cast<char>(bent[place] + 1);
        EXPECT_LT(readJournal(bent).changes, 3u) << place;
    }
    const Journalled astray = readJournal(journalBegin("", "a", "{}", false) + journalSaved(7, "b.json"));
    EXPECT_NE(astray.damage, "");
    EXPECT_FALSE(astray.saved) << "there is no step 7";
    test::putContent((folder() + "/noise.journal").toStdString(), "no journal\n\xff\xfe\n");
    QStringList unusable;
    EXPECT_EQ(abandonedJournals(folder(), &unusable).size(), 1u);
    EXPECT_EQ(unusable.size(), 1);
}

TEST_F(Journals, UnwritableFolderIsReported) {
    test::putContent(file("blocked").toStdString(), "a file where the folder should be");
    Window window(file("blocked"));
    QString why;
    QObject::connect(&window.journal, &Journal::failed, [&](const QString& text) { why = text; });
    window.document.apply("Name", journalled("second"));
    EXPECT_TRUE(why.contains("Not a directory") || why.contains("File exists")) << why.toStdString();
    EXPECT_EQ(window.document.scene()->title, "second");
    bool mended = false;
    QObject::connect(&window.journal, &Journal::mended, [&] { mended = true; });
    QFile::remove(file("blocked"));
    window.document.apply("Name", journalled("third"));
    EXPECT_TRUE(mended);
    window.journal.flush();
    const Journalled read = readJournal(test::contentOf(window.journal.path().toStdString()));
    ASSERT_EQ(read.steps.size(), 3u) << "including the one in between";
    EXPECT_NE(textOf(read, 1).find("second"), std::string::npos);
    EXPECT_NE(textOf(read, 2).find("third"), std::string::npos);
}

/// Columns of blocks, more than a screen full of text.
Scene manyBlocks() {
    Scene scene;
    for (int i = 0; i < 400; ++i) {
        Block& block = scene.blocks.emplace_back();
        block.name = "B" + std::to_string(i);
        block.points = {Point(i, 0.0), Point(i + 0.5, 0.0), Point(i + 0.5, 1.0)};
    }
    return scene;
}

TEST_F(Journals, EditAtTwoDistantPositionsIsStoredCompactly) {
    Window window(folder());
    window.document.startNew(manyBlocks());
    std::vector<std::string> texts{wholeSceneText(*window.document.scene())};
    const auto edit = [&](const auto& change) {
        Scene scene = *window.document.scene();
        change(scene);
        window.document.apply("Edit", std::move(scene));
        texts.push_back(wholeSceneText(*window.document.scene()));
    };
    edit([](Scene& scene) { scene.title = "begun"; });
    window.journal.flush();
    const qint64 before = QFile(window.journal.path()).size();
    for (int i = 0; i < 20; ++i)
        edit([&](Scene& scene) {
            scene.blocks.front().points[0].x() -= 0.01;
            scene.blocks[200 + i].name += "x";
            scene.blocks.back().points[1].x() += 0.01;
        });
    edit([](Scene& scene) { std::swap(scene.blocks[3], scene.blocks[390]); });
    edit([](Scene& scene) { scene.blocks.erase(scene.blocks.begin() + 100, scene.blocks.begin() + 300); });
    edit([](Scene& scene) { scene.blocks.front().name = "Ä", scene.blocks.back().name = "Ö"; });
    edit([](Scene& scene) { scene.blocks.front().name = "Ö", scene.blocks.back().name = "Ä"; });
    window.journal.flush();
    EXPECT_LT(QFile(window.journal.path()).size() - before, 12000);
    const Journalled read = readJournal(test::contentOf(window.journal.path().toStdString()));
    ASSERT_EQ(read.steps.size(), texts.size());
    for (std::size_t i = 0; i < texts.size(); ++i) EXPECT_EQ(textOf(read, i), texts[i]) << i;
}

TEST_F(Journals, RecoveredDocumentContinuesAfterAnyUndo) {
    std::vector<std::string> texts;
    {
        Window window(folder());
        window.document.startNew(manyBlocks());
        for (int i = 0; i < 100; ++i) {
            Scene scene = *window.document.scene();
            scene.blocks[3 * i].name = "Edited " + std::to_string(i);
            texts.push_back(wholeSceneText(scene));
            window.document.apply("Edit " + QString::number(i), std::move(scene));
        }
        window.document.undo().setIndex(90);
    }
    for (const int back : {40, 39, 1}) {
        Window window(folder());
        const std::vector<Abandoned> found = abandonedJournals(folder());
        ASSERT_EQ(found.size(), 1u);
        EXPECT_EQ(recover(found[0], Recover::Everything, window.document, window.journal), "");
        window.document.undo().undo();
        window.document.undo().redo();
        window.document.undo().setIndex(back);
        EXPECT_EQ(wholeSceneText(*window.document.scene()), texts[back - 1]);
        EXPECT_EQ(window.document.undo().redoText(), "Edit " + QString::number(back));
        Scene scene = *window.document.scene();
        scene.title = "Went on at " + std::to_string(back);
        window.document.apply("Go on", scene);
        scene.blocks.pop_back();
        window.document.apply("Delete", scene);
        texts[back] = wholeSceneText(*window.document.scene());
    }
    const std::vector<Abandoned> found = abandonedJournals(folder());
    ASSERT_EQ(found.size(), 1u);
    Window last(folder());
    EXPECT_EQ(recover(found[0], Recover::WithoutLastCommand, last.document, last.journal), "");
    EXPECT_EQ(last.document.scene()->title, "Went on at 1");
    EXPECT_EQ(last.document.scene()->blocks.size(), 400u);
    EXPECT_EQ(last.document.undo().count(), 2);
    last.document.undo().undo();
    EXPECT_EQ(wholeSceneText(*last.document.scene()), texts[0]);
}

/// In the format used before an edit could have several changes.
TEST_F(Journals, OlderJournalsCanBeRead) {
    QDir().mkpath(folder());
    const std::string lines =
        R"(742a5d0c276c8dad {"journal": 1, "path": "", "name": "", "scene": "{\n  \"format\": \"keyblock-scene\",\n  \"version\": 1,\n  \"title\": \"first\"\n}\n"}
c592aed18fcfd7d6 {"at": 1, "step": "Good", "begin": 60, "end": 4, "text": "good"}
de461d952d1d8d9d {"at": 2, "step": "Bad", "begin": 60, "end": 5, "text": "ba"}
80a723af2d1a4b09 {"at": 1}
)";
    test::putContent((folder() + "/old.journal").toStdString(), lines);
    const std::vector<Abandoned> found = abandonedJournals(folder());
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].damage, "");
    Window next(folder());
    EXPECT_EQ(recover(found[0], Recover::Everything, next.document, next.journal), "");
    EXPECT_EQ(next.document.scene()->title, "good");
    next.document.undo().redo();
    EXPECT_EQ(next.document.scene()->title, "bad");
    next.document.undo().setIndex(0);
    EXPECT_EQ(next.document.scene()->title, "first");
}

TEST_F(Journals, OldJournalIsKeptWhileTheDiskIsFull) {
    std::signal(SIGXFSZ, SIG_IGN);
    {
        Window window(folder());
        window.document.startNew(manyBlocks());
        window.document.apply("Name", journalled("second"));
    }
    const std::vector<Abandoned> found = abandonedJournals(folder());
    ASSERT_EQ(found.size(), 1u);
    rlimit usual{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &usual), 0);
    const rlimit full{1000, usual.rlim_max};
    setrlimit(RLIMIT_FSIZE, &full);
    Window next(folder());
    const QString why = recover(found[0], Recover::Everything, next.document, next.journal);
    setrlimit(RLIMIT_FSIZE, &usual);
    EXPECT_EQ(why, "");
    EXPECT_EQ(next.document.scene()->title, "second");
    EXPECT_TRUE(QFile::exists(found[0].journal));
    EXPECT_TRUE(waitFor([&] { return !QFile::exists(found[0].journal); })) << "it would be offered next to newer work";
    EXPECT_EQ(readJournal(test::contentOf(next.journal.path().toStdString())).changes, 1u);
}

TEST_F(Journals, UnreadableSceneIsNotShownAsEmpty) {
    QDir().mkpath(folder());
    const std::string good = wholeSceneText(journalled("good")), none = "no scene at all";
    const std::string lines = journalBegin("", "", none, false) + journalStep(1, "Mend", none, good);
    test::putContent((folder() + "/odd.journal").toStdString(), lines);
    const std::vector<Abandoned> found = abandonedJournals(folder());
    ASSERT_EQ(found.size(), 1u);
    Window next(folder());
    EXPECT_EQ(recover(found[0], Recover::Everything, next.document, next.journal), "");
    QString message;
    QObject::connect(&next.document, &Document::reported, [&](const QString& text) { message = text; });
    next.document.undo().undo();
    EXPECT_EQ(next.document.scene()->title, "good");
    EXPECT_TRUE(next.document.isModified());
    EXPECT_TRUE(message.contains("cannot be read")) << message.toStdString();
    next.document.apply("Name", journalled("further"));
    next.journal.flush();
    EXPECT_EQ(readJournal(test::contentOf(next.journal.path().toStdString())).damage, "");
}

/// A limit on the size of files simulates a full disk.
TEST_F(Journals, EditsAreWrittenOnceAFullDiskHasRoom) {
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit usual{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &usual), 0);
    Window window(folder());
    int failures = 0, mended = 0;
    QObject::connect(&window.journal, &Journal::failed, [&] { ++failures; });
    QObject::connect(&window.journal, &Journal::mended, [&] { ++mended; });
    window.document.apply("Name", journalled("before"));
    window.journal.flush();
    const rlimit full{static_cast<rlim_t>(QFile(window.journal.path()).size() + 20), usual.rlim_max};
    setrlimit(RLIMIT_FSIZE, &full);
    for (const char* title : {"a", "b", "c"}) window.document.apply("Name", journalled(title));
    EXPECT_TRUE(waitFor([&] { return failures > 0; }));
    const Journalled meanwhile = readJournal(test::contentOf(window.journal.path().toStdString()));
    setrlimit(RLIMIT_FSIZE, &usual);
    EXPECT_EQ(meanwhile.damage, "");
    EXPECT_EQ(meanwhile.changes, 1u);
    EXPECT_TRUE(waitFor([&] { return mended > 0; }));
    EXPECT_EQ(failures, 1);
    const Journalled after = readJournal(test::contentOf(window.journal.path().toStdString()));
    EXPECT_EQ(after.damage, "");
    EXPECT_EQ(after.changes, 4u);
}

}  // namespace
}  // namespace keyblock
