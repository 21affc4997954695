// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ui/window/random_user.h"

#include "ui/look/commands.h"
#include "ui/window/main_window.h"

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QContextMenuEvent>
#include <QDialog>
#include <QDockWidget>
#include <QDropEvent>
#include <QKeyEvent>
#include <QMenu>
#include <QMimeData>
#include <QPointer>
#include <QTest>
#include <QUrl>
#include <QWheelEvent>

#include <algorithm>
#include <cstdlib>
#include <iostream>
#include <iterator>
#include <tuple>

namespace keyblock {

namespace {

bool isVerbose() {
    static const bool verbose = std::getenv("KEYBLOCK_TELL") != nullptr;
    return verbose;
}

/// Whether the mouse can reach the widget: no modal dialog blocks it.
bool isInReach(const QWidget& widget) {
    return widget.isVisible() && widget.isEnabled() && widget.width() > 2 && widget.height() > 2 &&
           !widget.windowFlags().testFlag(Qt::ToolTip);
}

}  // namespace

RandomUser::RandomUser(MainWindow& window, unsigned seed, QStringList files)
    : window_(window), commands_(*window.findChild<Commands*>()), files_(std::move(files)), random_(seed) {
    // Dialogs and menus wait for an answer within the action that opened them.
    answering_.setInterval(30);
    QObject::connect(&answering_, &QTimer::timeout, [this] { answer(); });
    answering_.start();
}

void RandomUser::act() {
    closeWindows();
    switch (below(18)) {
        case 0:
        case 1: command(); break;
        case 2:
        case 3: key(); break;
        case 4:
        case 5: type(); break;
        case 6: drag(); break;
        case 7:
        case 8: draw(); break;
        case 9: wheel(); break;
        case 10: below(4) == 0 ? drop() : undoOrRedo(); break;
        case 11: run(); break;
        case 12: askMenu(); break;
        default: click(); break;
    }
    noteWhere();
}

int RandomUser::countOf(const std::string& beginning) const {
    int count = 0;
    for (const auto& [what, times] : counts_)
        if (what.starts_with(beginning)) count += times;
    return count;
}

/// In the main window, or in the import or export window.
QWidget* RandomUser::anyWidget() {
    QList<QWidget*> widgets;
    for (QWidget* widget : QApplication::allWidgets())
        if (isInReach(*widget)) widgets << widget;
    // The order of all widgets is that of a hash: sort them, so that a seed is reproducible.
    std::sort(widgets.begin(), widgets.end(), [](QWidget* a, QWidget* b) {
        const QPoint pa = a->mapToGlobal({}), pb = b->mapToGlobal({});
        return std::tuple(pa.y(), pa.x(), a->width(), a->height(), a->objectName()) <
               std::tuple(pb.y(), pb.x(), b->width(), b->height(), b->objectName());
    });
    return widgets.isEmpty() ? &window_ : widgets[below(widgets.size())];
}

QPoint RandomUser::anyPlace(const QWidget& widget) { return {below(widget.width()), below(widget.height())}; }

QWidget* RandomUser::focused() {
    QWidget* widget = QApplication::focusWidget();
    return widget ? widget : &window_;
}

void RandomUser::tell(const std::string& what, const QObject& object) {
    last_ = what + " " + object.metaObject()->className() + " '" + object.objectName().toStdString() + "'";
    ++counts_[what];
    if (isVerbose()) std::cerr << last_ << std::endl;
}

/// Notes the current tool, and the visible docks and windows.
void RandomUser::noteWhere() {
    for (const QAction* action : commands_.all())
        if (action->objectName().startsWith("tool.") && action->isChecked())
            ++counts_["tool " + action->objectName().toStdString()];
    for (const QDockWidget* dock : window_.findChildren<QDockWidget*>())
        if (dock->isVisible() && !dock->visibleRegion().isEmpty()) ++counts_["dock " + dock->objectName().toStdString()];
    for (const QWidget* window : QApplication::topLevelWidgets())
        if (window->isVisible() && window != &window_)
            ++counts_[std::string("window ") + window->metaObject()->className()];
}

void RandomUser::click() {
    QPointer<QWidget> widget = anyWidget();
    tell("click", *widget);
    static constexpr Qt::MouseButton buttons[]{Qt::LeftButton, Qt::LeftButton, Qt::LeftButton, Qt::RightButton,
                                               Qt::MiddleButton};
    static constexpr Qt::KeyboardModifier modifiers[]{Qt::NoModifier, Qt::NoModifier, Qt::ControlModifier,
                                                      Qt::ShiftModifier};
    const QPoint place = anyPlace(*widget);
    const Qt::MouseButton button = buttons[below(5)];
    QTest::mouseMove(widget, place);
    if (!widget) return;
    if (below(6) == 0)
        QTest::mouseDClick(widget, button, {}, place);
    else
        QTest::mouseClick(widget, button, modifiers[below(4)], place);
}

void RandomUser::drag() {
    QPointer<QWidget> widget = anyWidget();
    tell("drag", *widget);
    const Qt::MouseButton button = below(3) == 0 ? Qt::MiddleButton : Qt::LeftButton;
    const QPoint from = anyPlace(*widget), to = anyPlace(*widget);
    QTest::mousePress(widget, button, {}, from);
    if (widget) QTest::mouseMove(widget, (from + to) / 2);
    if (widget) QTest::mouseMove(widget, to);
    if (widget) QTest::mouseRelease(widget, button, {}, to);
}

/// Some points on the canvas with some tool, then the key that ends the object.
void RandomUser::draw() {
    QPointer<QWidget> canvas = window_.findChild<QWidget*>("canvas");
    if (!canvas || !canvas->isVisible()) return click();
    tell("draw", *canvas);
    static const char* const tools[]{"tool.select", "tool.outline", "tool.block", "tool.joint", "tool.joint-set",
                                     "tool.tunnel", "tool.bolt", "tool.pattern", "tool.support", "tool.load",
                                     "tool.motion", "tool.monitor", "tool.measure"};
    const QString tool = tools[below(std::size(tools))];
    if (below(2) && commands_.has(tool)) commands_.action(tool)->trigger();
    for (int places = 1 + below(4); places > 0 && canvas; --places) {
        const QPoint place = anyPlace(*canvas);
        QTest::mouseMove(canvas, place);
        if (canvas) QTest::mouseClick(canvas, Qt::LeftButton, {}, place);
    }
    static constexpr Qt::Key ends[]{Qt::Key_Return, Qt::Key_Return, Qt::Key_Escape};
    if (canvas) QTest::keyClick(canvas, ends[below(3)]);
}

void RandomUser::wheel() {
    QWidget* widget = anyWidget();
    tell("wheel", *widget);
    const QPoint place = anyPlace(*widget);
    QWheelEvent event(place, widget->mapToGlobal(place), {}, {0, below(2) ? 120 : -120}, Qt::NoButton, {},
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(widget, &event);
}

void RandomUser::key() {
    static constexpr int keys[]{Qt::Key_Escape, Qt::Key_Return, Qt::Key_Tab,  Qt::Key_Delete, Qt::Key_Left,
                                Qt::Key_Right,  Qt::Key_Up,     Qt::Key_Down, Qt::Key_Space,  Qt::Key_Home,
                                Qt::Key_End,    Qt::Key_F3,     Qt::Key_F8,   Qt::Key_F9,     Qt::Key_B,
                                Qt::Key_J,      Qt::Key_K,      Qt::Key_P,    Qt::Key_T,      Qt::Key_M,
                                Qt::Key_S,      Qt::Key_N,      Qt::Key_F5,   Qt::Key_Backspace};
    tell("key", *focused());
    QTest::keyClick(focused(), static_cast<Qt::Key>(keys[below(std::size(keys))]));
}

void RandomUser::type() {
    static const char* const texts[]{"12.5,3", "@2,0", "@3<45", "5", "-1e400", "300mm", "=5/2+0.1", "=1/0", "nan", "inf",
                                     "", "0", "1e-300", "a rather long name that goes on and on", "ä ö 漢", "3 < 4", "@",
                                     "12,5", "../../x", "%1 %2"};
    tell("type", *focused());
    for (const QChar c : QString::fromUtf8(texts[below(std::size(texts))])) {
        QKeyEvent press(QEvent::KeyPress, 0, Qt::NoModifier, c);  // QTest's own supports ASCII letters only
        QApplication::sendEvent(focused(), &press);
    }
    if (below(2)) QTest::keyClick(focused(), Qt::Key_Return);
}

/// Excludes commands that end the program.
bool RandomUser::mayDo(const QAction& action) const {
    return action.isEnabled() && !action.isSeparator() && action.objectName() != "file.quit";
}

void RandomUser::command() {
    const auto& all = commands_.all();
    QAction* action = all[below(static_cast<int>(all.size()))];
    if (!mayDo(*action)) return;
    tell("command", *action);
    ++counts_["command " + action->objectName().toStdString()];
    action->trigger();
}

void RandomUser::undoOrRedo() {
    QAction* action = commands_.action(below(3) == 0 ? "edit.redo" : "edit.undo");
    if (!action->isEnabled()) return;
    tell(action->objectName().toStdString(), *action);
    action->trigger();
}

/// Starts a run, or operates the one in progress or shown.
void RandomUser::run() {
    static const char* const ids[]{"run.start", "run.start", "run.start", "run.pause", "run.step", "run.stop",
                                   "time.play", "time.end", "time.nextEvent", "time.compare"};
    QAction* action = commands_.action(ids[below(std::size(ids))]);
    if (!action->isEnabled()) return;
    tell(action->objectName().toStdString(), *action);
    action->trigger();
}

void RandomUser::askMenu() {
    QPointer<QWidget> widget = below(2) ? window_.findChild<QWidget*>("canvas") : anyWidget();
    if (!widget || !widget->isVisible()) return;
    tell("menu wanted", *widget);
    const QPoint place = anyPlace(*widget);
    QTest::mouseClick(widget, Qt::RightButton, {}, place);
    if (!widget) return;
    QContextMenuEvent event(QContextMenuEvent::Mouse, place, widget->mapToGlobal(place));
    QApplication::sendEvent(widget, &event);
}

/// Keeps few windows open besides the main one, which would otherwise get hardly any actions.
void RandomUser::closeWindows() {
    QWidgetList others;
    for (QWidget* window : QApplication::topLevelWidgets())
        if (window->isVisible() && window != &window_ && window->windowType() == Qt::Window) others << window;
    if (others.size() > 1) others[below(others.size())]->close();
}

void RandomUser::drop() {
    if (files_.isEmpty()) return;
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(files_[below(files_.size())])});
    tell("drop", window_);
    const QPoint place = anyPlace(window_);
    QDragEnterEvent enter(place, Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(&window_, &enter);
    QDropEvent drop(place, Qt::CopyAction, &data, Qt::LeftButton, {});
    if (enter.isAccepted()) QApplication::sendEvent(&window_, &drop);
}

void RandomUser::answer() {
    if (QWidget* popup = QApplication::activePopupWidget()) {
        if (auto* menu = qobject_cast<QMenu*>(popup)) return answer(*menu);
        ++counts_["popup"];
        if (below(2)) QTest::keyClick(focused(), below(2) ? Qt::Key_Down : Qt::Key_Return);
        if (QApplication::activePopupWidget() == popup) popup->close();
    } else if (QWidget* dialog = QApplication::activeModalWidget()) {
        answer(*dialog);
    }
}

void RandomUser::answer(QMenu& menu) {
    ++counts_["menu"];
    QList<QAction*> able;
    for (QAction* action : menu.actions())
        if (mayDo(*action) && !action->menu()) able << action;
    const QPointer<QAction> chosen = able.isEmpty() || below(2) ? nullptr : able[below(able.size())];
    menu.close();
    if (!chosen) return;
    ++counts_["menu action"];
    QTimer::singleShot(0, chosen, &QAction::trigger);  // its dialog must be answered by the current timer
}

/// Mostly presses one of its buttons, sometimes only closes it.
void RandomUser::answer(QWidget& dialog) {
    ++counts_[std::string("dialog ") + dialog.metaObject()->className()];
    QList<QAbstractButton*> able;
    for (auto* button : dialog.findChildren<QAbstractButton*>())
        if (isInReach(*button)) able << button;
    if (able.isEmpty() || below(3) == 0) dialog.close();
    else QTimer::singleShot(0, able[below(able.size())], &QAbstractButton::click);
}

}  // namespace keyblock
