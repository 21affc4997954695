// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Somebody who clicks, drags, types and calls commands at random, wherever there is
// something to click. Nothing may crash or hang, and undo must lead back to the
// first scene to the byte. `KEYBLOCK_ACTIONS=10000` does more of it, `KEYBLOCK_SEED`
// something else.
#include "tests/ui/screen/screen.h"

#include "solver/files/scene_file.h"
#include "ui/document/document.h"
#include "ui/look/commands.h"
#include "ui/look/theme.h"
#include "ui/window/main_window.h"

#include <QAbstractSpinBox>
#include <QApplication>
#include <QComboBox>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QKeyEvent>
#include <QLineEdit>
#include <QMenu>
#include <QTest>
#include <QTimer>
#include <QUndoStack>
#include <QWheelEvent>
#include <gtest/gtest.h>

#include <cstdlib>
#include <iostream>
#include <random>

namespace keyblock {
namespace {

int numberFrom(const char* name, int otherwise) {
    const char* text = std::getenv(name);
    return text ? std::atoi(text) : otherwise;
}

class Somebody {
public:
    Somebody(QWidget& window, unsigned seed) : window_(window), random_(seed) {
        // Questions and menus wait for an answer within the action that made them.
        closer_.setInterval(50);
        QObject::connect(&closer_, &QTimer::timeout, [this] { answerWhatIsModal(); });
        closer_.start();
    }

    void act() {
        switch (below(8)) {
            case 0: return command();
            case 1: return key();
            case 2: return type();
            case 3: return drag();
            case 4: return wheel();
            default: return click();
        }
    }

    const std::string& last() const { return last_; }

private:
    int below(int count) { return std::uniform_int_distribution(0, count - 1)(random_); }

    QWidget* anyWidget() {
        QList<QWidget*> widgets;
        for (QWidget* widget : QApplication::allWidgets())
            if (widget->isVisible() && widget->isEnabled() && widget->window() == &window_ && widget->width() > 2 &&
                widget->height() > 2)
                widgets << widget;
        // The list of all widgets is that of a hash: the same seed should do the same.
        std::sort(widgets.begin(), widgets.end(), [](QWidget* a, QWidget* b) {
            const QPoint pa = a->mapToGlobal({}), pb = b->mapToGlobal({});
            return std::tuple(pa.y(), pa.x(), a->width(), a->height(), a->objectName()) <
                   std::tuple(pb.y(), pb.x(), b->width(), b->height(), b->objectName());
        });
        return widgets.isEmpty() ? &window_ : widgets[below(widgets.size())];
    }

    QPoint anyPlace(const QWidget& widget) { return {below(widget.width()), below(widget.height())}; }

    void tell(const std::string& what, const QObject& object) {
        last_ = what + " " + object.metaObject()->className() + " '" + object.objectName().toStdString() + "'";
        if (std::getenv("KEYBLOCK_TELL")) std::cerr << last_ << std::endl;
    }

    void click() {
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

    void drag() {
        QPointer<QWidget> widget = anyWidget();
        tell("drag", *widget);
        const Qt::MouseButton button = below(3) == 0 ? Qt::MiddleButton : Qt::LeftButton;
        const QPoint from = anyPlace(*widget), to = anyPlace(*widget);
        QTest::mousePress(widget, button, {}, from);
        if (widget) QTest::mouseMove(widget, (from + to) / 2);
        if (widget) QTest::mouseMove(widget, to);
        if (widget) QTest::mouseRelease(widget, button, {}, to);
    }

    void wheel() {
        QWidget* widget = anyWidget();
        tell("wheel", *widget);
        const QPoint place = anyPlace(*widget);
        QWheelEvent event(place, widget->mapToGlobal(place), {}, {0, below(2) ? 120 : -120}, Qt::NoButton, {},
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(widget, &event);
    }

    QWidget* focused() {
        QWidget* widget = QApplication::focusWidget();
        return widget ? widget : &window_;
    }

    void key() {
        static constexpr int keys[]{Qt::Key_Escape, Qt::Key_Return, Qt::Key_Tab,  Qt::Key_Delete, Qt::Key_Left,
                                    Qt::Key_Right,  Qt::Key_Up,     Qt::Key_Down, Qt::Key_Space,  Qt::Key_Home,
                                    Qt::Key_End,    Qt::Key_F3,     Qt::Key_F8,   Qt::Key_F9,     Qt::Key_B,
                                    Qt::Key_J,      Qt::Key_K,      Qt::Key_P,    Qt::Key_T,      Qt::Key_M,
                                    Qt::Key_S,      Qt::Key_N,      Qt::Key_F5,   Qt::Key_Backspace};
        tell("key", *focused());
        QTest::keyClick(focused(), static_cast<Qt::Key>(keys[below(std::size(keys))]));
    }

    void type() {
        static const char* const texts[]{"12.5,3", "@2,0",  "@3<45", "5", "-1e400", "300mm", "=5/2+0.1", "=1/0", "nan",
                                         "inf",    "",      "0",     "1e-300", "a rather long name that goes on and on",
                                         "ä ö 漢", "3 < 4", "@",     "12,5",   "../../x", "%1 %2"};
        tell("type", *focused());
        for (const QChar c : QString::fromUtf8(texts[below(std::size(texts))])) {
            QKeyEvent press(QEvent::KeyPress, 0, Qt::NoModifier, c);  // QTest's own knows no other letters than ASCII
            QApplication::sendEvent(focused(), &press);
        }
        if (below(2)) QTest::keyClick(focused(), Qt::Key_Return);
    }

    void command() {
        // These leave the window, or the scene whose undo is to be followed back.
        static const QStringList leaving{"file.quit", "file.new", "file.open", "file.save", "file.saveAs"};
        const auto& all = window_.findChild<Commands*>()->all();
        QAction* action = all[static_cast<std::size_t>(below(static_cast<int>(all.size())))];
        if (leaving.contains(action->objectName())) return;
        tell("command", *action);
        action->trigger();
    }

    void answerWhatIsModal() {
        if (QWidget* popup = QApplication::activePopupWidget()) {
            popup->close();
            return;
        }
        if (QWidget* modal = QApplication::activeModalWidget()) modal->close();
    }

    QWidget& window_;
    std::mt19937 random_;
    QTimer closer_;
    std::string last_;
};

void undoAll(Document& document) {
    document.endPreview();
    while (document.undo().canUndo()) document.undo().undo();
}

TEST(RandomActions, NeitherCrashNorHangAndUndoLeadsBack) {
    NEED_SCREEN();
    Themes themes;
    MainWindow window(themes);
    window.show();
    window.openPath(KEYBLOCK_SAMPLES_DIR "/drift-bolted.json");
    auto& document = *window.findChild<Document*>();
    ASSERT_FALSE(document.scene()->title.empty());
    std::string before = wholeSceneText(*document.scene());
    // The first page may open a sample; undo leads back to that one then.
    QObject::connect(&document, &Document::replaced, [&] { before = wholeSceneText(*document.scene()); });
    Somebody somebody(window, static_cast<unsigned>(numberFrom("KEYBLOCK_SEED", 1)));
    const int actions = numberFrom("KEYBLOCK_ACTIONS", 500);
    for (int i = 0; i < actions; ++i) {
        QElapsedTimer timer;
        timer.start();
        somebody.act();
        QApplication::processEvents();
        EXPECT_LT(timer.elapsed(), 60000) << "hung at action " << i << ": " << somebody.last();
        EXPECT_TRUE(window.isVisible()) << "gone at action " << i << ": " << somebody.last();
    }
    undoAll(document);
    EXPECT_EQ(wholeSceneText(*document.scene()), before);
}

}  // namespace
}  // namespace keyblock
