// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a journal keeps comes back with its steps of undo; what is damaged is told
// and does no harm; windows leave each other's journals alone.
#include "tests/scratch_folder.h"
#include "tests/ui/screen/screen.h"

#include "solver/files/scene_file.h"
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

Scene titled(const std::string& title) {
    Scene scene;
    scene.title = title;
    return scene;
}

/// A document with its journal, as of a program that ended without closing it.
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

TEST_F(Journals, EditsComeBackWithTheirStepsOfUndo) {
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

TEST_F(Journals, TheLastCommandCanBeLeftOut) {
    {
        Window window(folder());
        window.document.startNew(titled("first"));
        window.document.apply("Good", titled("good"));
        window.document.apply("Bad", titled("bad"));
    }
    const std::vector<Abandoned> found = abandonedJournals(folder());
    ASSERT_EQ(found.size(), 1u);
    EXPECT_EQ(found[0].lastStep, "Bad");
    Window next(folder());
    EXPECT_EQ(recover(found[0], Recover::WithoutLastCommand, next.document, next.journal), "");
    EXPECT_EQ(next.document.scene()->title, "good");
    EXPECT_FALSE(next.document.undo().canRedo());
}

TEST_F(Journals, WhatIsRecoveredIsJournalledAgain) {
    {
        Window window(folder());
        window.document.startNew(titled("first"));
        window.document.apply("Name", titled("second"));
    }
    {
        Window again(folder());
        const std::vector<Abandoned> found = abandonedJournals(folder());
        ASSERT_EQ(found.size(), 1u);
        EXPECT_EQ(recover(found[0], Recover::Everything, again.document, again.journal), "");
        again.document.apply("Name again", titled("third"));
    }
    const std::vector<Abandoned> found = abandonedJournals(folder());
    ASSERT_EQ(found.size(), 1u);
    Window last(folder());
    EXPECT_EQ(recover(found[0], Recover::Everything, last.document, last.journal), "");
    EXPECT_EQ(last.document.scene()->title, "third");
    EXPECT_EQ(last.document.undo().count(), 2);
}

TEST_F(Journals, AClosedOrSavedDocumentLeavesNone) {
    {
        Window closed(folder());
        closed.document.apply("Name", titled("second"));
        closed.journal.close();
        Window saved(folder());
        saved.document.apply("Name", titled("second"));
        saved.document.save(file("scene.json"));
        Window replaced(folder());
        replaced.document.apply("Name", titled("second"));
        replaced.document.startNew({});
    }
    EXPECT_TRUE(abandonedJournals(folder()).empty());
    EXPECT_TRUE(QDir(folder()).entryList({"*.journal"}, QDir::Files).isEmpty());
}

TEST_F(Journals, EditsAfterSavingAreOfTheFile) {
    {
        Window window(folder());
        window.document.apply("Name", titled("second"));
        window.document.save(file("scene.json"));
        window.document.apply("Name", titled("third"));
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

TEST_F(Journals, AnOpenWindowsJournalIsLeftAlone) {
    Window window(folder());
    window.document.apply("Name", titled("second"));
    window.journal.flush();
    EXPECT_TRUE(abandonedJournals(folder()).empty());
    EXPECT_TRUE(QFile::exists(window.journal.path()));
}

TEST_F(Journals, DamageIsToldAndWhatStandsBeforeItComesBack) {
    {
        Window window(folder());
        for (const char* title : {"a", "b", "c"}) window.document.apply("Name", titled(title));
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

TEST_F(Journals, AnyBytesAreReadWithoutHarm) {
    {
        Window window(folder());
        for (const char* title : {"a", "b", "c"}) window.document.apply("Name", titled(title));
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
    test::putContent((folder() + "/noise.journal").toStdString(), "no journal\n\xff\xfe\n");
    QStringList unusable;
    EXPECT_EQ(abandonedJournals(folder(), &unusable).size(), 1u);
    EXPECT_EQ(unusable.size(), 1);
}

TEST_F(Journals, AFolderThatTakesNothingIsTold) {
    test::putContent(file("blocked").toStdString(), "a file where the folder should be");
    Window window(file("blocked"));
    QString why;
    QObject::connect(&window.journal, &Journal::failed, [&](const QString& text) { why = text; });
    window.document.apply("Name", titled("second"));
    EXPECT_FALSE(why.isEmpty());
    EXPECT_EQ(window.document.scene()->title, "second");
    bool mended = false;
    QObject::connect(&window.journal, &Journal::mended, [&] { mended = true; });
    QFile::remove(file("blocked"));
    window.document.apply("Name", titled("third"));
    EXPECT_TRUE(mended);
    window.journal.flush();
    const Journalled read = readJournal(test::contentOf(window.journal.path().toStdString()));
    ASSERT_EQ(read.steps.size(), 3u) << "the one in between too";
    EXPECT_NE(read.steps[1].text.find("second"), std::string::npos);
    EXPECT_NE(read.steps[2].text.find("third"), std::string::npos);
}

/// A limit on the size of files stands for a disk that is full.
TEST_F(Journals, WhatAFullDiskDoesNotTakeIsWrittenOnceItHasRoom) {
    std::signal(SIGXFSZ, SIG_IGN);
    rlimit usual{};
    ASSERT_EQ(getrlimit(RLIMIT_FSIZE, &usual), 0);
    Window window(folder());
    int failures = 0, mended = 0;
    QObject::connect(&window.journal, &Journal::failed, [&] { ++failures; });
    QObject::connect(&window.journal, &Journal::mended, [&] { ++mended; });
    window.document.apply("Name", titled("before"));
    window.journal.flush();
    const rlimit full{static_cast<rlim_t>(QFile(window.journal.path()).size() + 20), usual.rlim_max};
    setrlimit(RLIMIT_FSIZE, &full);
    for (const char* title : {"a", "b", "c"}) window.document.apply("Name", titled(title));
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
