// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Figures, tables and animations of a run are written to files, on a thread; errors of
// writing and drawing are reported, and Stop leaves no unfinished files.
#include "tests/scratch_folder.h"
#include "tests/ui/screen/screen.h"

#include "solver/files/run_store/run_store.h"
#include "solver/files/run_store/run_store_writer.h"
#include "solver/files/scene/scene_file.h"
#include "solver/run/run.h"
#include "ui/export/export_form.h"
#include "ui/export/export_job.h"
#include "ui/export/export_window.h"
#include "ui/export/tab_separated.h"
#include "ui/look/theme.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPixmap>
#include <QPushButton>
#include <gtest/gtest.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <string>

namespace keyblock {
namespace {

namespace fs = std::filesystem;

/// A run of a sample in a store of its own, made once.
class Exports : public testing::Test {
protected:
    void SetUp() override {
        NEED_SCREEN();
        order_.store = scratch_.path() / "rebar.kbrun";
        const SceneReading reading = readSceneFile(KEYBLOCK_SAMPLES_DIR "/rebar-elastic-85.json");
        RunStoreWriter writer(order_.store, false);
        Control control;
        keyblock::run(*reading.scene, writer, control);
        order_.figure.runName = "rebar";
    }

    /// The final message, and whether it reports an error.
    std::pair<QString, bool> run(const ExportOrder& order) {
        ExportJob job;
        std::optional<std::pair<QString, bool>> said;
        QObject::connect(&job, &ExportJob::ended, [&](const QString& text, bool bad) { said = {text, bad}; });
        job.start(order);
        EXPECT_TRUE(waitFor([&] { return said.has_value(); }, 60000));
        return said.value_or(std::pair{QString(), true});
    }

    test::ScratchFolder scratch_;
    ExportOrder order_;
};

TEST_F(Exports, FiguresOfAllKindsAndFormats) {
    for (const FigureKind kind : {FigureKind::Section, FigureKind::Bolt, FigureKind::Curves}) {
        order_.figure.kind = kind;
        order_.out = scratch_.path() / ("figure" + std::to_string(int(kind)) + ".pdf");
        order_.figure.format = PaperFormat::Pdf;
        const auto [said, bad] = run(order_);
        EXPECT_FALSE(bad) << said.toStdString();
        EXPECT_TRUE(test::contentOf(order_.out).starts_with("%PDF"));
    }
}

TEST_F(Exports, AllFiguresAndTablesIntoAFolder) {
    order_.what = ExportWhat::Everything;
    order_.out = scratch_.path() / "all";
    order_.figure.filter.stage = 0;  // as the window requests the time that it shows
    order_.figure.filter.when = When::At;
    order_.figure.filter.time = 0.5;
    const auto [said, bad] = run(order_);
    EXPECT_FALSE(bad) << said.toStdString();
    for (const char* name : {"rebar-section.svg", "rebar-curves.svg", "rebar-history.csv", "rebar-blocks.csv"})
        EXPECT_TRUE(fs::exists(order_.out / name)) << name;
    std::set<std::string> contents;
    std::size_t files = 0;
    for (const auto& entry : fs::directory_iterator(order_.out)) {
        ++files;
        EXPECT_TRUE(contents.insert(test::contentOf(entry.path())).second) << entry.path() << " is there twice";
    }
    EXPECT_TRUE(said.startsWith(QString("%1 files").arg(files))) << said.toStdString();
}

TEST_F(Exports, DataComeWithAFigureOnlyOnRequest) {
    order_.figure.format = PaperFormat::Svg;
    order_.out = scratch_.path() / "alone" / "section.svg";
    fs::create_directories(order_.out.parent_path());
    EXPECT_FALSE(run(order_).second);
    EXPECT_EQ(std::distance(fs::directory_iterator(order_.out.parent_path()), {}), 1);
    order_.withData = true;
    const auto [said, bad] = run(order_);
    EXPECT_FALSE(bad);
    EXPECT_TRUE(said.contains("CSV")) << said.toStdString();
    EXPECT_GT(std::distance(fs::directory_iterator(order_.out.parent_path()), {}), 2);
}

TEST_F(Exports, AnAnimationWithoutFfmpegIsAFolderOfImages) {
    order_.what = ExportWhat::Film;
    order_.out = scratch_.path() / "frames";
    order_.figure.dpi = 40;
    const auto [said, bad] = run(order_);
    EXPECT_FALSE(bad) << said.toStdString();
    EXPECT_TRUE(fs::exists(order_.out / "frame-0001.png"));
    EXPECT_TRUE(fs::exists(order_.out / "frames.csv"));
}

TEST_F(Exports, TheFormStartsFromTheCurrentView) {
    const auto store = std::make_shared<const RunStore>(order_.store);
    ExportForm form(nullptr);
    Exportable shown{store, order_.store, 1, "sigma3", 0, 1.0};
    shown.boltQuantity = "shear_force";
    shown.view = Box{{-1.0, -2.0}, {3.0, 4.0}};
    form.take(shown);
    form.choose(ExportWhat::Figure);
    FigureRequest request = form.order().figure;
    EXPECT_EQ(request.quantity, "sigma3");
    EXPECT_EQ(request.boltQuantity, "shear_force");
    EXPECT_FALSE(request.window);
    form.findChild<QComboBox*>("export.extent")->setCurrentIndex(2);
    form.findChild<QLineEdit*>("export.title")->setText("Section A");
    request = form.order().figure;
    ASSERT_TRUE(request.window);
    EXPECT_EQ(request.window->max, Point(3.0, 4.0));
    EXPECT_EQ(request.title, "Section A");
    EXPECT_NO_THROW(paintFigure(*store, request));
    form.choose(ExportWhat::Film);
    request = form.order().figure;
    EXPECT_NEAR(request.width * request.dpi / 25.4, 1920.0, 0.5);
    form.choose(ExportWhat::Everything);
    EXPECT_TRUE(form.findChild<QLabel*>("export.note")->text().contains("frame 2 of"));
}

TEST(TabSeparated, QuotesAreRemovedAndCommasInThemStay) {
    EXPECT_EQ(tabSeparated("a,b\n\"x, y\",\"say \"\"no\"\"\"\n"), "a\tb\nx, y\tsay \"no\"\n");
}

#ifdef KEYBLOCK_HAS_FFMPEG
TEST_F(Exports, AnAnimationIsWrittenOrStopped) {
    order_.what = ExportWhat::Film;
    order_.out = scratch_.path() / "film.mp4";
    order_.figure.dpi = 60;
    const auto [said, bad] = run(order_);
    EXPECT_FALSE(bad) << said.toStdString();
    EXPECT_GT(fs::file_size(order_.out), 500u);
    order_.out = scratch_.path() / "stopped.mp4";
    {
        ExportJob job;
        job.start(order_);
    }
    EXPECT_FALSE(fs::exists(order_.out));
}
#endif

TEST_F(Exports, FilesThatCannotBeWrittenOrReadAreReported) {
    order_.out = "/nowhere/at/all.svg";
    EXPECT_TRUE(run(order_).second);
    order_.out = scratch_.path() / "figure.svg";
    order_.figure.quantity = "colour";
    EXPECT_TRUE(run(order_).second);
    order_.store = scratch_.path() / "none.kbrun";
    EXPECT_TRUE(run(order_).second);
}

TEST_F(Exports, TheWindowPreviewsAndCopies) {
    Themes themes;
    const auto store = std::make_shared<const RunStore>(order_.store);
    ExportWindow window([&] { return Exportable{store, order_.store, 1, "sigma1", 0, 1.0}; }, themes, nullptr);
    window.open(ExportWhat::Figure);
    const auto* picture = window.findChild<QLabel*>("export.preview");
    EXPECT_TRUE(waitFor([&] { return picture->pixmap(Qt::ReturnByValue).width() > 100; }));
    auto* kinds = window.findChild<QComboBox*>("export.kind");
    auto* copy = window.findChild<QPushButton*>("export.Copy");
    for (const int kind : {0, 1, 2, 3}) {  // section, bolt, curves, events, at a time
        QApplication::clipboard()->clear();
        kinds->setCurrentIndex(kind);
        copy->click();
        EXPECT_TRUE(waitFor([] { return !QApplication::clipboard()->image().isNull(); }))
            << kinds->currentText().toStdString();
    }
    window.open(ExportWhat::Numbers);
    copy->click();
    EXPECT_TRUE(waitFor([] { return QApplication::clipboard()->text().contains('\t'); }));
}

TEST(ExportWindows, WithoutARunExportIsDisabled) {
    NEED_SCREEN();
    Themes themes;
    ExportWindow window([] { return Exportable{}; }, themes, nullptr);
    window.open(ExportWhat::Figure);
    EXPECT_FALSE(window.findChild<QPushButton*>("export.Export")->isEnabled());
}

}  // namespace
}  // namespace keyblock
