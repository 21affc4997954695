// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Figures, tables and films of a run end up in files, from a thread; what cannot be
// written or drawn is told, and Stop leaves nothing unfinished.
#include "tests/scratch_folder.h"
#include "tests/ui/screen/screen.h"

#include "solver/files/run_store.h"
#include "solver/files/run_store_writer.h"
#include "solver/files/scene_file.h"
#include "solver/run/run.h"
#include "ui/export/export_job.h"
#include "ui/export/export_window.h"
#include "ui/look/theme.h"

#include <QApplication>
#include <QClipboard>
#include <QComboBox>
#include <QLabel>
#include <QPixmap>
#include <QPushButton>
#include <QStandardPaths>
#include <gtest/gtest.h>

#include <algorithm>

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

    /// What it said at the end; empty after success is no answer.
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

TEST_F(Exports, EverythingIntoAFolder) {
    order_.what = ExportWhat::Everything;
    order_.out = scratch_.path() / "all";
    order_.figure.filter.stage = 0;  // as the window asks for the moment that it shows
    order_.figure.filter.when = When::At;
    order_.figure.filter.time = 0.5;
    const auto [said, bad] = run(order_);
    EXPECT_FALSE(bad) << said.toStdString();
    for (const char* name : {"rebar-section.svg", "rebar-curves.svg", "rebar-history.csv", "rebar-blocks.csv"})
        EXPECT_TRUE(fs::exists(order_.out / name)) << name;
}

TEST_F(Exports, AFilmIsMadeOrStopped) {
    if (QStandardPaths::findExecutable("ffmpeg").isEmpty()) GTEST_SKIP() << "ffmpeg is not installed";
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

TEST_F(Exports, WhatCannotBeWrittenOrReadIsTold) {
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
    for (const int kind : {0, 1, 2, 3}) {  // section, bolt, curves, events, at a moment
        QApplication::clipboard()->clear();
        kinds->setCurrentIndex(kind);
        copy->click();
        EXPECT_TRUE(waitFor([] { return !QApplication::clipboard()->image().isNull(); }))
            << kinds->currentText().toStdString();
    }
    window.open(ExportWhat::Numbers);
    copy->click();
    EXPECT_TRUE(waitFor([] { return QApplication::clipboard()->text().contains(','); }));
}

TEST(ExportWindows, WithoutARunNothingIsOffered) {
    NEED_SCREEN();
    Themes themes;
    ExportWindow window([] { return Exportable{}; }, themes, nullptr);
    window.open(ExportWhat::Figure);
    EXPECT_FALSE(window.findChild<QPushButton*>("export.Export")->isEnabled());
}

}  // namespace
}  // namespace keyblock
