// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The start page: every sample opens from within the program, cards get their pictures,
// recent files and recoverable scenes are listed.
#include "tests/scratch_folder.h"
#include "tests/ui/screen/screen.h"

#include "solver/files/scene/scene_file.h"
#include "ui/document/checked.h"
#include "ui/document/document.h"
#include "ui/document/recent_files.h"
#include "ui/look/commands.h"
#include "ui/look/theme.h"
#include "ui/start/start_buttons.h"
#include "ui/start/start_page.h"
#include "ui/start/samples.h"

#include <QDir>
#include <QPushButton>
#include <QTest>
#include <gtest/gtest.h>

namespace keyblock {
namespace {

struct Page {
    Page() : commands(themes), journal(document), recent(document) {
        commands.add({"file.new", "New scene", "File", "new", {}, {QKeySequence::New}}, [this] { ++begun; });
        commands.add({"file.open", "Open…", "File", "open", {}, {QKeySequence::Open}}, [] {});
        covered.resize(1600, 1000);
        page = new StartPage({themes, commands, document, journal, recent}, &covered);
    }
    Themes themes;
    Commands commands;
    Document document;
    Journal journal;
    RecentFiles recent;
    QWidget covered;
    StartPage* page;
    int begun = 0;
};

TEST(StartPages, EveryBuiltInSampleEqualsItsFile) {
    NEED_SCREEN();
    const std::vector<Sample> samples = gallerySamples();
    EXPECT_EQ(samples.size(), size_t(QDir(KEYBLOCK_SAMPLES_DIR).entryList({"*.json"}).size()));
    EXPECT_EQ(samples.front().name, "drift-rebar-dbolt");
    for (const Sample& sample : samples) {
        const std::optional<Scene> scene = sampleScene(sample);
        ASSERT_TRUE(scene) << sample.name.toStdString();
        EXPECT_FALSE(sample.title.isEmpty() || sample.shows.isEmpty()) << sample.name.toStdString();
        EXPECT_GT(sample.seconds, 0.0) << sample.name.toStdString() << ": run resources/gallery/measure.py";
        SceneReading file = readSceneFile(KEYBLOCK_SAMPLES_DIR "/" + sample.name.toStdString() + ".json");
        for (Stage& stage : file.scene->stages)
            for (auto* acceleration : {&stage.baseAcceleration, &stage.bodyAcceleration})
                if (*acceleration) (*acceleration)->file.clear();
        EXPECT_EQ(sceneText(*scene), sceneText(*file.scene)) << sample.name.toStdString();
    }
}

TEST(StartPages, SampleCardsGetPicturesAndOpenCopies) {
    NEED_SCREEN();
    Page page;
    QString opened;
    QObject::connect(page.page, &StartPage::sampleWanted, [&](const Sample& sample) { opened = sample.name; });
    page.covered.show();
    page.page->open();
    auto* card = page.page->findChild<SampleCard*>("sample.incline");
    ASSERT_TRUE(card);
    EXPECT_TRUE(waitFor([&] { return card->hasPicture(); }, 60000));
    card->setFocus();
    QTest::keyClick(card, Qt::Key_Return);
    EXPECT_EQ(opened, "incline");
    QTest::mouseClick(page.page->findChild<QPushButton*>("start.file.new"), Qt::LeftButton);
    EXPECT_EQ(page.begun, 1);
}

TEST(StartPages, SamplesAreFilteredByKind) {
    NEED_SCREEN();
    Page page;
    page.covered.show();
    page.page->open();
    QTest::mouseClick(page.page->findChild<QPushButton*>("kind.Drifts"), Qt::LeftButton);
    EXPECT_FALSE(page.page->findChild<SampleCard*>("sample.drift-bolted")->isHidden());
    EXPECT_TRUE(page.page->findChild<SampleCard*>("sample.incline")->isHidden());
    QTest::mouseClick(page.page->findChild<QPushButton*>("kind.Verification"), Qt::LeftButton);
    EXPECT_TRUE(page.page->findChild<SampleCard*>("sample.drift-bolted")->isHidden());
    EXPECT_TRUE(page.page->findChild<SampleCard*>("sample.angle-rebar-40")->isHidden()) << "expects its own result";
    EXPECT_FALSE(page.page->findChild<SampleCard*>("sample.incline")->isHidden());
}

TEST(StartPages, IconsFollowTheTheme) {
    NEED_SCREEN();
    Page page;
    const auto* button = page.page->findChild<QPushButton*>("start.file.open");
    const bool wasDark = page.themes.isDark();
    const qint64 before = button->icon().cacheKey();
    page.themes.choose(!wasDark);
    EXPECT_NE(button->icon().cacheKey(), before);
    EXPECT_EQ(button->icon().cacheKey(), page.commands.action("file.open")->icon().cacheKey());
    page.themes.choose(wasDark);
}

TEST(StartPages, EnterPressesTheFocusedWidget) {
    NEED_SCREEN();
    const test::ScratchFolder scratch;
    const QString file = QString::fromStdString((scratch.path() / "heading.json").string());
    Page page;
    page.document.save(file);
    page.recent.add(file);
    page.covered.show();
    page.page->open();
    QString opened;
    QObject::connect(page.page, &StartPage::openWanted, [&](const QString& path) { opened = path; });
    auto* row = page.page->findChild<RecentRow*>("recent.heading.json");
    ASSERT_TRUE(row);
    QTest::keyClick(row, Qt::Key_Return);
    EXPECT_TRUE(waitFor([&] { return opened == file; })) << opened.toStdString();
    QTest::keyClick(page.page->findChild<QPushButton*>("start.file.new"), Qt::Key_Return);
    EXPECT_EQ(page.begun, 1);
}

TEST(StartPages, RecentFilesAndRecoverableScenesAreListed) {
    NEED_SCREEN();
    const test::ScratchFolder scratch;
    const QString file = QString::fromStdString((scratch.path() / "crosscut-east.json").string());
    {
        Document document;
        Journal journal(document);
        document.save(file);
        Scene scene;
        scene.title = "edited";
        document.apply("Set title", scene);
    }
    Page page;
    page.recent.add(file);
    page.covered.show();
    page.page->open();
    EXPECT_TRUE(page.page->findChild<RecentRow*>("recent.crosscut-east.json"));
    Abandoned asked;
    QObject::connect(page.page, &StartPage::recoverWanted, [&](const Abandoned& abandoned) { asked = abandoned; });
    auto* recover = page.page->findChild<QPushButton*>("recovery.Recover");
    ASSERT_TRUE(recover);
    QTest::mouseClick(recover, Qt::LeftButton);
    EXPECT_TRUE(waitFor([&] { return !asked.title.isEmpty(); }));
    EXPECT_EQ(asked.title, "crosscut-east.json");
    QTest::mouseClick(page.page->findChild<QPushButton*>("recovery.Discard"), Qt::LeftButton);
    EXPECT_TRUE(waitFor([] { return abandonedJournals().empty(); }));
}

TEST(StartPages, AnErrorFoundByReadingAndCheckingIsCountedOnce) {
    NEED_SCREEN();
    const test::ScratchFolder scratch;
    const QString file = QString::fromStdString((scratch.path() / "faulty.json").string());
    QFile text(file);
    ASSERT_TRUE(text.open(QIODevice::WriteOnly));
    text.write(R"({"format": "keyblock-scene", "version": 1, "materials": {"rock": {"density": -5, "youngs_modulus": 6e10, "poissons_ratio": 0.7}},
        "blocks": [{"points": [[0, 0], [1, 0], [1, 1]], "material": "rock"}],
        "monitors": [{"name": "far", "point": [9, 9]}]})");
    text.close();
    Page page;
    page.recent.add(file);
    page.covered.show();
    page.page->open();
    const auto* row = page.page->findChild<RecentRow*>("recent.faulty.json");
    ASSERT_TRUE(row);
    EXPECT_TRUE(waitFor([&] { return row->accessibleDescription().contains("errors"); }));
    EXPECT_TRUE(row->accessibleDescription().contains("3 errors")) << row->accessibleDescription().toStdString();
}

TEST(StartPages, TimesAreShownInShortForm) {
    const QDateTime now(QDate(2026, 11, 22), QTime(15, 0));
    EXPECT_EQ(whenText(now.addSecs(-2400), now), "today 14:20");
    EXPECT_EQ(whenText(now.addDays(-1), now), "yesterday");
    EXPECT_EQ(whenText(now.addDays(-4), now), "18 Nov");
    EXPECT_EQ(whenText(now.addYears(-1), now), "22 Nov 2025");
    EXPECT_EQ(durationText(0.26), "0.3 s");
    EXPECT_EQ(durationText(29.4), "29 s");
    EXPECT_EQ(durationText(240), "4 min");
}

}  // namespace
}  // namespace keyblock
