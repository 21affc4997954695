// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Files dropped on the window, deleted from the disk, or with wrong content: each is
// opened by its type, or reported.
#include "tests/scratch_folder.h"
#include "tests/ui/screen/screen.h"

#include "solver/files/scene/scene_file.h"
#include "ui/document/document.h"
#include "ui/look/theme.h"
#include "ui/runs/runs.h"
#include "ui/window/file_drops.h"
#include "ui/window/main_window.h"

#include <QApplication>
#include <QDropEvent>
#include <QFile>
#include <QLabel>
#include <QMimeData>
#include <QUrl>
#include <gtest/gtest.h>

namespace keyblock {
namespace {

struct Window {
    Window() : window(themes) { window.show(); }
    Document& document() { return *window.findChild<Document*>(); }

    /// Drops files on a widget; false if the window accepts none of them.
    bool drop(const QStringList& paths) {
        QMimeData data;
        QList<QUrl> urls;
        for (const QString& path : paths) urls << QUrl::fromLocalFile(path);
        data.setUrls(urls);
        QDragEnterEvent enter({400, 300}, Qt::CopyAction | Qt::MoveAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(&window, &enter);
        if (!enter.isAccepted()) return false;
        QDropEvent event({400, 300}, Qt::CopyAction | Qt::MoveAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(&window, &event);
        return event.isAccepted() && event.dropAction() == Qt::CopyAction;  // never moves the file
    }

    Themes themes;
    MainWindow window;
};

bool shows(const char* kind) {
    for (const QWidget* widget : QApplication::topLevelWidgets())
        if (widget->isVisible() && widget->inherits(kind)) return true;
    return false;
}

TEST(FileDrops, AreOpenedByFileType) {
    NEED_SCREEN();
    Window screen;
    EXPECT_TRUE(screen.drop({KEYBLOCK_SAMPLES_DIR "/incline.json"}));
    EXPECT_TRUE(waitFor([&] { return screen.document().title() == "incline.json"; }));
    for (const char* drawing : {"/import/feet.dxf", "/import/bolts.csv"}) {
        EXPECT_TRUE(screen.drop({QString(KEYBLOCK_TEST_DATA_DIR) + drawing}));
        EXPECT_TRUE(waitFor([] { return shows("keyblock::ImportWindow"); })) << drawing;
        for (QWidget* widget : QApplication::topLevelWidgets())
            if (widget->inherits("keyblock::ImportWindow")) widget->close();
        EXPECT_TRUE(waitFor([] { return !shows("keyblock::ImportWindow"); }));
    }
    EXPECT_FALSE(screen.drop({"/etc/hostname"})) << "nothing that the program reads";
    EXPECT_FALSE(screen.drop({}));
}

TEST(FileDrops, AFileThatIsNotARunIsReported) {
    NEED_SCREEN();
    const test::ScratchFolder scratch;
    test::putContent(scratch.path() / "no.kbrun", "this is no run");
    Window screen;
    QString message;
    QObject::connect(screen.window.findChild<Runs*>(), &Runs::reported, [&](const QString& text) { message = text; });
    EXPECT_TRUE(screen.drop({QString::fromStdString((scratch.path() / "no.kbrun").string())}));
    EXPECT_TRUE(waitFor([&] { return message.contains("no.kbrun"); })) << message.toStdString();
}

TEST(FilesGone, AreReportedAndCountAsUnsaved) {
    NEED_SCREEN();
    const test::ScratchFolder scratch;
    const QString path = QString::fromStdString((scratch.path() / "scene.json").string());
    ASSERT_TRUE(QFile::copy(KEYBLOCK_SAMPLES_DIR "/incline.json", path));
    Window screen;
    screen.window.openPath(path);
    EXPECT_FALSE(screen.document().isModified());
    QFile::remove(path);
    EXPECT_TRUE(waitFor([&] { return screen.document().isModified(); }));
    const auto* bar = screen.window.findChild<QFrame*>("noticeBar");
    ASSERT_TRUE(bar);
    EXPECT_TRUE(bar->isVisible());
    EXPECT_TRUE(bar->findChild<QLabel*>() != nullptr);
    screen.document().save(path);
    EXPECT_FALSE(screen.document().isModified());
    EXPECT_TRUE(readSceneFile(path.toStdString()).scene);
}

}  // namespace
}  // namespace keyblock
