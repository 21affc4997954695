// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A drawing becomes a scene by roles that the user chooses; everything in it is
// accounted for.
#include "tests/scratch_folder.h"
#include "tests/ui/screen/screen.h"

#include "solver/scene/scene.h"
#include "ui/look/theme.h"
#include "ui/start/import_window.h"
#include "ui/start/picture_pane.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QPointer>
#include <QPushButton>
#include <QTreeWidget>
#include <gtest/gtest.h>

#include <optional>

namespace keyblock {
namespace {

std::string lineOn(const std::string& layer, double x0, double y0, double x1, double y1) {
    const auto group = [](int code, const std::string& value) { return std::to_string(code) + "\n" + value + "\n"; };
    return group(0, "LINE") + group(8, layer) + group(10, std::to_string(x0)) + group(20, std::to_string(y0)) +
           group(11, std::to_string(x1)) + group(21, std::to_string(y1));
}

std::string drawing() {
    return "0\nSECTION\n2\nENTITIES\n" + lineOn("rim", 0, 0, 10, 0) + lineOn("rim", 10, 0, 10, 8) +
           lineOn("rim", 10, 8, 0, 8) + lineOn("rim", 0, 8, 0, 0) + lineOn("joints", -1, 2, 11, 6) +
           "0\nTEXT\n8\nnotes\n10\n1\n20\n1\n1\nhello\n0\nENDSEC\n0\nEOF\n";
}

TEST(ImportWindows, ChosenRolesGiveAScene) {
    NEED_SCREEN();
    const test::ScratchFolder scratch;
    const std::filesystem::path file = scratch.path() / "section.dxf";
    test::putContent(file, drawing());
    Themes themes;
    auto* window = new ImportWindow(QString::fromStdString(file.string()), themes, nullptr);
    window->QWidget::show();
    std::optional<Scene> made;
    QObject::connect(window, &ImportWindow::imported, [&](const Scene& scene, const QString&) { made = scene; });
    const auto role = [&](const char* layer) { return window->findChild<QComboBox*>(QString("import.role.") + layer); };
    auto* import = window->findChild<QPushButton*>("import.import");
    const auto choose = [&](const char* layer, LayerRole wanted) {
        const QPointer<QComboBox> box = role(layer);
        box->setCurrentIndex(box->findData(int(wanted)));
        Q_EMIT box->activated(box->currentIndex());
        // The result of the new reading replaces the boxes.
        EXPECT_TRUE(waitFor([&] {
            QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
            return !box && role(layer) && role(layer)->currentData().toInt() == int(wanted);
        }));
    };
    auto* unit = window->findChild<QComboBox*>("import.unit");
    unit->setCurrentIndex(unit->findData("m"));
    Q_EMIT unit->activated(unit->currentIndex());
    ASSERT_TRUE(waitFor([&] { return role("rim") && role("joints"); }));
    choose("rim", LayerRole::Boundary);
    choose("joints", LayerRole::Joint);
    ASSERT_TRUE(waitFor([&] { return import->isEnabled(); }));
    const auto* account = window->findChild<QTreeWidget*>("import.account");
    EXPECT_FALSE(account->findItems("TEXT", Qt::MatchExactly).isEmpty());
    import->click();
    ASSERT_TRUE(made);
    EXPECT_TRUE(made->domain);
    EXPECT_EQ(made->joints.size(), 1u);
    window->close();
}

TEST(ImportWindows, AFileThatIsNotADrawingIsReportedAndGivesNoScene) {
    NEED_SCREEN();
    Themes themes;
    auto* window = new ImportWindow("/nowhere/at-all.dxf", themes, nullptr);
    window->QWidget::show();
    const auto* pane = window->findChild<PicturePane*>();
    EXPECT_TRUE(waitFor([&] { return pane->accessibleDescription().contains("/nowhere/at-all.dxf"); }));
    EXPECT_FALSE(window->findChild<QPushButton*>("import.import")->isEnabled());
    window->close();
}

}  // namespace
}  // namespace keyblock
