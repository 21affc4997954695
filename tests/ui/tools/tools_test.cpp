// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The tools on the canvas: real mouse and key events, checked by the resulting undo
// steps.
#include "../screen/screen.h"
#include "solver/scene/check.h"
#include "ui/canvas/canvas.h"
#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/document/visibility.h"
#include "ui/edit/edits.h"
#include "ui/look/commands.h"
#include "ui/look/display.h"
#include "ui/look/theme.h"
#include "ui/tools/tool.h"
#include "ui/tools/tool_bar.h"
#include "ui/tools/tool_desk.h"
#include "ui/tools/tool_palette.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QCursor>
#include <QFrame>
#include <QLineEdit>
#include <QMenu>
#include <QMouseEvent>
#include <QTest>
#include <QToolButton>
#include <QUndoStack>

namespace {

using namespace keyblock;

/// Notes that the mouse has arrived at a point of the screen.
class MouseArrival : public QObject {
public:
    explicit MouseArrival(const QPoint& target) : place(target) { QCoreApplication::instance()->installEventFilter(this); }

    const QPoint place;
    bool isReported = false;

protected:
    bool eventFilter(QObject*, QEvent* event) override {
        if (event->type() == QEvent::MouseMove)
            isReported = isReported || static_cast<QMouseEvent*>(event)->globalPos() == place;
        return false;
    }
};

/// Canvas, desk and the objects they need, without a window.
struct Place {
    Themes themes;
    Display display;
    Commands commands{themes};
    Document document;
    Selection selection;
    Visibility visibility{document};
    Canvas canvas{themes};
    std::unique_ptr<ToolDesk> desk;

    Place() {
        canvas.resize(1000, 800);
        canvas.QWidget::show();
        desk = std::make_unique<ToolDesk>(canvas, document, selection, visibility, display, themes, commands);
        desk->bar().resize(1000, 36);
        selection.follow(document);
        document.startNew(newScene());
        EXPECT_TRUE(QTest::qWaitForWindowExposed(&canvas));
        canvas.zoomTo({{-20, -16}, {20, 16}});
        canvas.setFocus();
        PointingModes modes;
        desk->bench().setModes(modes);
    }
    ~Place() {
        delete &desk->bar();
        delete &desk->palette();
        desk.reset();
    }

    QPoint pixel(const Point& place) const { return canvas.map().toPixel(place).toPoint(); }
    /// Moves the mouse and waits until the X server reports it.
    void move(const Point& place) {
        MouseArrival arrival(canvas.mapToGlobal(pixel(place)));
        const bool isReported = canvas.rect().contains(pixel(place)) && QCursor::pos() != arrival.place;
        QTest::mouseMove(&canvas, pixel(place));
        EXPECT_TRUE(!isReported || waitFor([&] { return arrival.isReported; }));
    }
    void click(const Point& place, Qt::KeyboardModifiers modifiers = {}) {
        move(place);
        QTest::mouseClick(&canvas, Qt::LeftButton, modifiers, pixel(place));
    }
    void drag(const Point& from, const Point& to) {
        move(from);
        QTest::mousePress(&canvas, Qt::LeftButton, {}, pixel(from));
        for (const double share : {0.3, 0.7, 1.0}) move(from + share * (to - from));
        QTest::mouseRelease(&canvas, Qt::LeftButton, {}, pixel(to));
    }
    void key(int key, Qt::KeyboardModifiers modifiers = {}) {
        QTest::keyClick(&canvas, static_cast<Qt::Key>(key), modifiers);
    }
    /// Types into the box at the cursor, from the canvas.
    void type(const QString& text) {
        QTest::keyClick(&canvas, text.front().toLatin1());
        auto* x = canvas.findChild<QLineEdit*>("coordinate.x");
        QTest::keyClicks(x, text.mid(1));
        QTest::keyClick(x, Qt::Key_Return);
    }
    void choose(const char* tool) { commands.action(QString("tool.") + tool)->trigger(); }
    const Scene& scene() const { return *document.committed(); }
    int steps() { return document.undo().index(); }
    QString lastStep() { return document.undo().undoText(); }
    void drawDrift() {
        choose("outline");
        type("-15,-12");
        type("@30,27");
        choose("tunnel");
        type("0,0");
    }
};

TEST(Tools, FromAnEmptySceneToAPattern) {
    NEED_SCREEN();
    Place place;
    place.drawDrift();
    ASSERT_TRUE(place.scene().domain);
    EXPECT_EQ(place.scene().domain->boundary[2], Point(15, 15));
    EXPECT_EQ(place.scene().supports.size(), 3u);
    ASSERT_EQ(place.scene().tunnels.size(), 1u);
    EXPECT_EQ(place.desk->tool().id(), "select") << "the handles are shown by Select";
    EXPECT_EQ(place.selection.pointers(), QStringList{"/tunnels/0"});
    place.choose("joint-set");
    EXPECT_FALSE(place.desk->tool().commitText().isEmpty()) << "a set is previewed at once";
    place.key(Qt::Key_Return);
    place.click({-5, -5});
    place.click({-3, -4});
    place.key(Qt::Key_Return);
    ASSERT_EQ(place.scene().jointSets.size(), 2u);
    EXPECT_NEAR(place.scene().jointSets[1].dip, 26.6, 5.0);
    place.choose("pattern");
    place.click({2.55, 0.0});
    place.move({-2.55, 0.0});
    EXPECT_TRUE(place.desk->tool().commitText().contains("8"))
        << place.desk->tool().commitText().toStdString();
    place.click({-2.55, 0.0});
    place.key(Qt::Key_Return);
    ASSERT_EQ(place.scene().boltPatterns.size(), 1u);
    EXPECT_EQ(place.scene().stages.size(), 3u);
    EXPECT_EQ(place.lastStep(), "Add bolt pattern P1");
    EXPECT_EQ(place.steps(), 5);
    EXPECT_FALSE(hasErrors(checkScene(place.scene())));
    const Scene drawn = place.scene();
    while (place.document.undo().canUndo()) place.document.undo().undo();
    EXPECT_EQ(place.scene(), newScene());
    while (place.document.undo().canRedo()) place.document.undo().redo();
    EXPECT_EQ(place.scene(), drawn);
}

TEST(Tools, EscGoesBackOneLevel) {
    NEED_SCREEN();
    Place place;
    place.drawDrift();
    place.choose("joint");
    place.click({-10, -8});
    EXPECT_TRUE(place.desk->tool().previous());
    place.key(Qt::Key_Escape);
    EXPECT_FALSE(place.desk->tool().previous());
    EXPECT_EQ(place.desk->tool().id(), "joint");
    place.key(Qt::Key_Escape);
    EXPECT_EQ(place.desk->tool().id(), "select");
    place.click({-1, 0});
    EXPECT_EQ(place.selection.pointers(), QStringList{"/tunnels/0"});
    place.key(Qt::Key_Escape);
    EXPECT_TRUE(place.selection.isEmpty());
    EXPECT_EQ(place.steps(), 2);
}

TEST(Tools, AJointIsDrawnWithSnapOrthoAndTyping) {
    NEED_SCREEN();
    Place place;
    place.drawDrift();
    place.choose("joint");
    place.click({-14.9, -11.9});
    EXPECT_EQ(place.desk->tool().previous(), Point(-15, -12)) << "snapped to the corner";
    place.type("@5,0");
    PointingModes modes;
    modes.ortho = true;
    modes.objectSnap = false;
    place.desk->bench().setModes(modes);
    place.click({-9.5, -7});
    place.key(Qt::Key_Backspace);
    place.click({-9.6, -6});
    place.key(Qt::Key_Return);
    ASSERT_EQ(place.scene().joints.size(), 1u);
    const std::vector<Point>& points = place.scene().joints[0].points;
    ASSERT_EQ(points.size(), 3u);
    EXPECT_NEAR((points[1] - Point(-10, -12)).norm(), 0.0, 1e-9);
    EXPECT_NEAR(points[2].x(), -10.0, 1e-9) << "straight up";
    EXPECT_NEAR(points[2].y(), -6.0, 0.1);
}

TEST(Tools, WrongCoordinatesAreReportedAndCanBeCorrected) {
    NEED_SCREEN();
    Place place;
    place.choose("outline");
    place.type("1,2,3");
    auto* x = place.canvas.findChild<QLineEdit*>("coordinate.x");
    EXPECT_TRUE(x->isVisible());
    EXPECT_FALSE(place.desk->tool().previous());
    x->setText("0,0");
    QTest::keyClick(x, Qt::Key_Return);
    EXPECT_EQ(place.desk->tool().previous(), Point(0, 0));
    place.type("0,5");
    EXPECT_FALSE(place.scene().domain) << "the outline has no area";
}

/// A drift with one joint.
void drawJoint(Place& place, const Point& from, const Point& to) {
    place.drawDrift();
    place.choose("joint");
    place.click(from);
    place.click(to);
    place.key(Qt::Key_Return);
}

TEST(Tools, DragWithSnapIsOneUndoStep) {
    NEED_SCREEN();
    Place place;
    drawJoint(place, {-10, -5}, {-6, -5});
    place.key(Qt::Key_Escape);
    ASSERT_EQ(place.scene().joints.size(), 1u);
    const std::vector<Point> before = place.scene().joints[0].points;
    place.click({-8, -5});
    EXPECT_EQ(place.selection.pointers(), QStringList{"/joints/0"});
    const int steps = place.steps();
    place.drag({-8.6, -5}, {-8.6, -8});
    EXPECT_EQ(place.steps(), steps + 1);
    EXPECT_EQ(place.lastStep(), "Move joint J1");
    EXPECT_NEAR(place.scene().joints[0].points[0].y(), before[0].y() - 3.0, 0.1);
    EXPECT_FALSE(place.document.isPreviewing());
    place.drag(place.scene().joints[0].points[1], {-14.95, 14.9});  // a handle, to the corner
    EXPECT_EQ(place.lastStep(), "Change joint J1");
    EXPECT_EQ(place.scene().joints[0].points[1], Point(-15, 15));
    place.key(Qt::Key_Left);
    EXPECT_LT(place.scene().joints[0].points[1].x(), -15.0);
}

TEST(Tools, DragEndsWhenItsHandleIsDeleted) {
    NEED_SCREEN();
    Place place;
    place.drawDrift();
    const Point middle = place.scene().tunnels[0].center;
    place.move(middle);
    QTest::mousePress(&place.canvas, Qt::LeftButton, {}, place.pixel(middle));
    place.document.undo().undo();
    for (const double off : {1.0, 2.0}) place.move(middle + Point(off, 0.0));
    QTest::mouseRelease(&place.canvas, Qt::LeftButton, {}, place.pixel(middle));
    EXPECT_TRUE(place.scene().tunnels.empty());
    place.document.undo().redo();
    place.selection.set({"/tunnels/0"});
    place.move(middle);
    QTest::mousePress(&place.canvas, Qt::LeftButton, {}, place.pixel(middle));
    place.commands.action("edit.selectAll")->trigger();
    const Scene before = place.scene();
    for (const double off : {1.0, 2.0}) place.move(middle + Point(off, 0.0));
    QTest::mouseRelease(&place.canvas, Qt::LeftButton, {}, place.pixel(middle + Point(2.0, 0.0)));
    EXPECT_EQ(place.scene(), before);
}

TEST(Tools, CommandsWithoutEffectAreDisabled) {
    NEED_SCREEN();
    Place place;
    const auto isOn = [&](const char* id) { return place.commands.action(id)->isEnabled(); };
    const auto areOn = [&](std::initializer_list<const char*> ids, bool on) {
        for (const char* id : ids) EXPECT_EQ(isOn(id), on) << id;
    };
    areOn({"edit.cut", "edit.copy", "edit.paste", "edit.duplicate", "edit.delete", "edit.selectAll"}, false);
    place.drawDrift();
    place.selection.clear();
    EXPECT_TRUE(isOn("edit.selectAll"));
    areOn({"edit.cut", "edit.copy", "edit.duplicate", "edit.delete"}, false);
    place.selection.set({"/tunnels/0"});
    areOn({"edit.cut", "edit.copy", "edit.duplicate", "edit.delete"}, true);
    place.selection.set({"/domain"});  // there is only one
    areOn({"edit.cut", "edit.copy", "edit.duplicate"}, false);
    EXPECT_TRUE(isOn("edit.delete"));
    place.selection.set({"/analysis"});
    areOn({"edit.cut", "edit.copy", "edit.duplicate", "edit.delete"}, false);
    place.selection.set({"/tunnels/0"});
    place.commands.action("edit.cut")->trigger();
    areOn({"edit.cut", "edit.copy", "edit.duplicate", "edit.delete"}, false);
    EXPECT_TRUE(isOn("edit.paste"));
}

TEST(Tools, ClipboardCommandsAreDisabledWhileResultsAreShown) {
    NEED_SCREEN();
    Place place;
    place.drawDrift();
    EXPECT_TRUE(place.commands.action("edit.duplicate")->isEnabled());
    EXPECT_FALSE(place.commands.action("edit.paste")->isEnabled()) << "nothing was copied yet";
    place.commands.action("edit.copy")->trigger();
    EXPECT_TRUE(place.commands.action("edit.paste")->isEnabled());
    place.desk->setDrawing(false);
    for (const char* id : {"edit.cut", "edit.copy", "edit.paste", "edit.duplicate", "edit.delete", "edit.selectAll"})
        EXPECT_FALSE(place.commands.action(id)->isEnabled()) << id;
    place.desk->setDrawing(true);
    EXPECT_TRUE(place.commands.action("edit.paste")->isEnabled());
    place.visibility.setLocked("/tunnels/0", true);
    place.commands.action("edit.selectAll")->trigger();
    EXPECT_FALSE(place.selection.isEmpty());
    EXPECT_FALSE(place.selection.contains("/tunnels/0"));
}

TEST(Tools, AfterTabACommaIsADecimalSeparator) {
    NEED_SCREEN();
    Place place;
    place.choose("outline");
    place.type("-15,-12");
    place.key(Qt::Key_Tab);
    auto* x = place.canvas.findChild<QLineEdit*>("coordinate.x");
    auto* y = place.canvas.findChild<QLineEdit*>("coordinate.y");
    QTest::keyClicks(x, "1,5");
    QTest::keyClick(x, Qt::Key_Tab);
    y->setText("2,25");
    QTest::keyClick(y, Qt::Key_Return);
    ASSERT_TRUE(place.scene().domain);
    EXPECT_EQ(place.scene().domain->boundary[2], Point(1.5, 2.25));
}

TEST(Tools, NameMayEqualTheTextForNoChoice) {
    NEED_SCREEN();
    Place place;
    place.drawDrift();
    Scene scene = place.scene();
    scene.jointMaterials.emplace_back("default", JointMaterial{});
    place.document.apply("add", scene);
    place.choose("joint");
    auto* box = place.desk->bar().findChild<QComboBox*>("option.joint_material");
    ASSERT_TRUE(box);
    box->setCurrentIndex(box->count() - 1);
    Q_EMIT box->activated(box->count() - 1);
    place.click({-8, -8});
    place.click({-4, -6});
    place.key(Qt::Key_Return);
    ASSERT_EQ(place.scene().joints.size(), 1u);
    EXPECT_EQ(place.scene().joints[0].jointMaterial, "default");
}

TEST(Tools, BoxEnclosesOrCrossesAndDeleteNamesItsStep) {
    NEED_SCREEN();
    Place place;
    place.drawDrift();
    place.selection.clear();
    place.drag({-4, -4}, {4, 4});
    EXPECT_EQ(place.selection.pointers(), QStringList{"/tunnels/0"});
    place.drag({4, 4}, {1, 1});
    EXPECT_EQ(place.selection.pointers(), QStringList{"/tunnels/0"}) << "the box crosses the wall";
    place.drag({5, 5}, {9, 9});
    EXPECT_TRUE(place.selection.isEmpty());
    place.click({-1, 0});
    place.commands.action("edit.copy")->trigger();
    place.commands.action("edit.paste")->trigger();
    EXPECT_EQ(place.scene().tunnels.size(), 2u);
    EXPECT_EQ(place.selection.pointers(), QStringList{"/tunnels/1"});
    place.commands.action("edit.delete")->trigger();
    EXPECT_EQ(place.scene().tunnels.size(), 1u);
    EXPECT_EQ(place.lastStep(), "Delete tunnel 2");
    EXPECT_TRUE(place.selection.isEmpty());
}

TEST(Tools, BoltIsPerpendicularToTheWall) {
    NEED_SCREEN();
    Place place;
    place.drawDrift();
    place.choose("bolt");
    place.click({-2.6, -1.0});
    ASSERT_EQ(place.scene().bolts.size(), 1u);
    const Bolt& bolt = place.scene().bolts[0];
    EXPECT_NEAR(bolt.head.x(), -2.5, 1e-9);
    EXPECT_NEAR((bolt.farEnd - bolt.head - Point(-2.4, 0)).norm(), 0.0, 1e-9);
    EXPECT_EQ(place.scene().stages[2].install, std::vector<std::string>{"B1"});
}

TEST(Tools, PointsWithoutSnapAreRounded) {
    NEED_SCREEN();
    Place place;
    drawJoint(place, {-9.87654321, -7.654321}, {-6.1234567, -3.3333333});
    ASSERT_EQ(place.scene().joints.size(), 1u);
    for (const Point& point : place.scene().joints[0].points) {
        EXPECT_EQ(point.x(), QString::number(point.x(), 'f', 2).toDouble()) << "a pixel is larger than a centimetre";
        EXPECT_EQ(point.y(), QString::number(point.y(), 'f', 2).toDouble());
    }
}

TEST(Tools, OptionsInTheBarChangeThePreview) {
    NEED_SCREEN();
    Place place;
    place.drawDrift();
    place.choose("pattern");
    place.click({2.55, 0.0});
    place.click({-2.55, 0.0});
    auto* spacing = place.desk->bar().findChild<QLineEdit*>("option.spacing");
    ASSERT_TRUE(spacing);
    spacing->setText("2000mm");
    QTest::keyClick(spacing, Qt::Key_Return);
    EXPECT_TRUE(place.desk->tool().commitText().contains("4")) << place.desk->tool().commitText().toStdString();
    spacing = place.desk->bar().findChild<QLineEdit*>("option.spacing");
    spacing->setText("-1");
    QTest::keyClick(spacing, Qt::Key_Return);
    EXPECT_TRUE(place.desk->tool().commitText().contains("4")) << "an invalid number changes nothing";
    place.key(Qt::Key_Return);
    ASSERT_EQ(place.scene().boltPatterns.size(), 1u);
    EXPECT_DOUBLE_EQ(place.scene().boltPatterns[0].spacing, 2.0);
}

TEST(Tools, APatternIsCentredOrReachesFromEndToEnd) {
    NEED_SCREEN();
    Place place;
    place.drawDrift();
    place.choose("pattern");
    place.click({2.55, 0.0});
    place.click({-2.55, 0.0});
    const auto option = [&](const char* name, const QString& text) {
        auto* line = place.desk->bar().findChild<QLineEdit*>(QString("option.") + name);
        ASSERT_TRUE(line) << name;
        line->setText(text);
        QTest::keyClick(line, Qt::Key_Return);
    };
    const auto layout = [&](const char* word) {
        for (const ToolField& field : place.desk->tool().fields()) {
            if (field.id == "fit") {
                EXPECT_EQ(field.set(FieldValue(std::string(word))), "");
            }
        }
    };
    option("spacing", "1.9");
    place.key(Qt::Key_Return);
    ASSERT_EQ(place.scene().boltPatterns.size(), 1u);
    const auto headsOf = [&](std::size_t row) { return boltsOfPattern(place.scene(), place.scene().boltPatterns[row]); };
    const auto centred = headsOf(0);
    ASSERT_GE(centred.size(), 3u);
    EXPECT_NEAR(centred.front().points[1].y(), centred.back().points[1].y(), 1e-3) << "same distance from both ends";
    EXPECT_NEAR(centred.front().points[1].x(), -centred.back().points[1].x(), 1e-3);
    place.choose("pattern");
    place.click({2.55, 0.0});
    place.click({-2.55, 0.0});
    layout("end to end");
    option("count", "5");
    EXPECT_TRUE(place.desk->tool().commitText().contains("5")) << place.desk->tool().commitText().toStdString();
    place.key(Qt::Key_Return);
    ASSERT_EQ(place.scene().boltPatterns.size(), 2u);
    const auto even = headsOf(1);
    ASSERT_EQ(even.size(), 5u);
    EXPECT_NEAR(even.back().points[1].x(), -even.front().points[1].x(), 1e-4) << "the last bolt is included";
}

TEST(Tools, TabMovesThroughTheFieldsOfATool) {
    NEED_SCREEN();
    Place place;
    place.drawDrift();
    place.choose("joint-set");
    ToolBar& bar = place.desk->bar();
    bar.resize(1600, 36);
    bar.QWidget::show();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(&bar));
    QApplication::setActiveWindow(&bar);
    const auto field = [&](const char* id) { return bar.findChild<QLineEdit*>(QString("option.") + id); };
    ASSERT_TRUE(field("dip") && field("spacing") && field("spacing_deviation"));
    field("dip")->setFocus();
    field("dip")->selectAll();
    const auto typeAndTab = [&](const char* text, Qt::Key key) {
        auto* at = qobject_cast<QLineEdit*>(QApplication::focusWidget());
        ASSERT_TRUE(at) << text;
        QTest::keyClicks(at, text);
        QTest::keyClick(at, key);
    };
    typeAndTab("52", Qt::Key_Tab);
    EXPECT_TRUE(field("spacing")->hasFocus());
    typeAndTab("1.8", Qt::Key_Tab);
    EXPECT_TRUE(field("spacing_deviation")->hasFocus());
    typeAndTab("0.4", Qt::Key_Backtab);
    EXPECT_TRUE(field("spacing")->hasFocus());
    typeAndTab("-3", Qt::Key_Tab);
    EXPECT_TRUE(field("spacing")->hasFocus()) << "a field with an error keeps the focus";
    typeAndTab("1.6", Qt::Key_Return);
    EXPECT_EQ(field("dip")->text().toDouble(), 52.0);
    EXPECT_EQ(field("spacing")->text().toDouble(), 1.6);
    EXPECT_EQ(field("spacing_deviation")->text().toDouble(), 0.4);
    EXPECT_FALSE(place.canvas.findChild<QLineEdit*>("coordinate.x")->isVisible());
}

QMenu* menuAt(Place& place, const Point& at) {
    const QPoint pixel = place.pixel(at);
    QContextMenuEvent event(QContextMenuEvent::Mouse, pixel, place.canvas.mapToGlobal(pixel));
    QApplication::sendEvent(&place.canvas, &event);
    const QList<QMenu*> menus = place.canvas.findChildren<QMenu*>();
    return menus.isEmpty() ? nullptr : menus.last();
}

QAction* actionOf(QMenu& menu, const QString& text) {
    for (QAction* action : menu.actions())
        if (action->text() == text) return action;
    return nullptr;
}

TEST(Tools, TheContextMenuEndsAndUndoesWhatIsDrawn) {
    NEED_SCREEN();
    Place place;
    place.drawDrift();
    place.choose("joint");
    for (const Point& at : {Point(-10, -8), Point(-8, -9), Point(-6, -8)}) place.click(at);
    QMenu* menu = menuAt(place, {-6, -8});
    ASSERT_TRUE(menu && actionOf(*menu, "Undo last point"));
    actionOf(*menu, "Undo last point")->trigger();
    menu->close();
    menu = menuAt(place, {-6, -8});
    ASSERT_TRUE(actionOf(*menu, "Enter")->isEnabled());
    actionOf(*menu, "Enter")->trigger();
    menu->close();
    ASSERT_EQ(place.scene().joints.size(), 1u);
    EXPECT_EQ(place.scene().joints[0].points.size(), 2u);
    place.choose("select");
    menu = menuAt(place, place.scene().joints[0].points[0]);
    ASSERT_TRUE(menu && actionOf(*menu, "Delete joint J1"));
    actionOf(*menu, "Delete joint J1")->trigger();
    menu->close();
    EXPECT_TRUE(place.scene().joints.empty());
}

TEST(Tools, OptionsThatDoNotFitAreInAPopup) {
    NEED_SCREEN();
    Place place;
    place.drawDrift();
    place.desk->bar().QWidget::show();
    place.desk->bar().resize(560, 36);
    place.choose("pattern");
    auto* more = place.desk->bar().findChild<QToolButton*>("toolMore");
    ASSERT_TRUE(waitFor([&] { return more->isVisible(); }));
    settle();
    EXPECT_FALSE(place.desk->bar().findChild<QLineEdit*>("option.spacing_out_of_plane")->isVisible());
    more->click();
    auto* popup = place.desk->bar().findChild<QFrame*>("toolMorePopup");
    ASSERT_TRUE(popup);
    auto* apart = popup->findChild<QLineEdit*>("option.spacing_out_of_plane");
    ASSERT_TRUE(apart);
    apart->setText("1,25");
    QTest::keyClick(apart, Qt::Key_Return);
    popup->close();
    place.click({2.55, 0.0});
    place.click({-2.55, 0.0});
    place.key(Qt::Key_Return);
    ASSERT_EQ(place.scene().boltPatterns.size(), 1u);
    EXPECT_DOUBLE_EQ(place.scene().boltPatterns[0].spacingOutOfPlane.value_or(0.0), 1.25);
    place.desk->bar().resize(1800, 36);
    EXPECT_TRUE(waitFor([&] { return !more->isVisible(); }));
}

TEST(Tools, EveryToolAcceptsClicksInAnEmptyScene) {
    NEED_SCREEN();
    Place place;
    for (const char* tool : {"select", "outline", "block", "joint", "joint-set", "tunnel", "bolt", "pattern", "support",
                             "load", "motion", "monitor", "measure"}) {
        place.document.startNew(Scene{});
        place.choose(tool);
        place.click({1, 1});
        place.click({3, 2});
        QTest::mouseDClick(&place.canvas, Qt::LeftButton, {}, place.pixel({5, 5}));
        for (const int key : {Qt::Key_Backspace, Qt::Key_Return, Qt::Key_C, Qt::Key_Tab}) place.key(key);
        place.key(Qt::Key_Escape);
        place.key(Qt::Key_Escape);
        while (place.document.undo().canUndo()) place.document.undo().undo();
        EXPECT_EQ(place.scene(), Scene{}) << tool;
    }
}

}  // namespace
