// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Screen readers: every widget that takes a click or a key has an accessible name. And
// names of a scene are never taken for markup.
#include "tests/ui/screen/screen.h"

#include "ui/document/document.h"
#include "ui/look/theme.h"
#include "ui/window/main_window.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAbstractSpinBox>
#include <QComboBox>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>
#include <QScrollBar>
#include <QTabBar>
#include <QTextEdit>
#include <gtest/gtest.h>

namespace keyblock {
namespace {

template <typename... Kinds>
bool isOneOf(const QWidget* widget) {
    return (qobject_cast<const Kinds*>(widget) || ...);
}

bool takesInput(const QWidget* widget) {
    if (isOneOf<QScrollBar, QHeaderView, QTabBar>(widget)) return false;
    return isOneOf<QAbstractButton, QLineEdit, QComboBox, QAbstractSpinBox, QTextEdit, QPlainTextEdit,
                   QAbstractItemView, QAbstractSlider>(widget);
}

/// Parts that Qt creates within a widget that has the name: the line of a spin box, the list of a combo box.
bool isPartOfAnother(const QWidget* widget) {
    if (widget->objectName().startsWith("qt_")) return true;
    const QWidget* parent = widget->parentWidget();
    return parent && (isOneOf<QComboBox, QAbstractSpinBox, QLineEdit, QTabBar, QAbstractItemView>(parent) ||
                      parent->inherits("QComboBoxPrivateContainer") || parent->inherits("QDockWidget") ||
                      parent->inherits("QMenuBar") || parent->inherits("QToolBar") ||
                      parent->inherits("QKeySequenceEdit"));
}

QString placeOf(const QWidget* widget) {
    QStringList place;
    for (; widget; widget = widget->parentWidget())
        place.prepend(QString("%1(%2)").arg(widget->metaObject()->className(), widget->objectName()));
    return place.join(" > ");
}

/// The accessible name. Not from QAccessible, which does not outlive an application that ends with the program.
QString spokenName(const QWidget* widget) {
    if (!widget->accessibleName().isEmpty()) return widget->accessibleName();
    if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) return button->text();
    for (const QLabel* label : widget->window()->findChildren<QLabel*>())
        if (label->buddy() == widget) return label->text();
    return {};
}

void expectNames(QWidget& window) {
    for (QWidget* widget : window.findChildren<QWidget*>()) {
        if (!takesInput(widget) || isPartOfAnother(widget)) continue;
        EXPECT_FALSE(spokenName(widget).trimmed().isEmpty()) << placeOf(widget).toStdString();
    }
}

TEST(Names, EveryWidgetThatTakesInputHasAnAccessibleName) {
    NEED_SCREEN();
    Themes themes;
    MainWindow window(themes);
    window.show();
    expectNames(window);
    window.openPath(KEYBLOCK_SAMPLES_DIR "/drift-bolted.json");
    const auto& document = *window.findChild<Document*>();
    ASSERT_TRUE(waitFor([&] { return document.checkIsCurrent() && document.checked().picture; }));
    settle();
    expectNames(window);
}

TEST(Names, LabelsDoNotTakeThemForMarkup) {
    NEED_SCREEN();
    Themes themes;
    MainWindow window(themes);
    window.show();
    window.openPath(KEYBLOCK_SAMPLES_DIR "/drift-bolted.json");
    ASSERT_TRUE(waitFor([&] { return window.findChild<Document*>()->checkIsCurrent(); }));
    settle();
    QLabel later("<b>later</b>", &window);
    later.show();
    for (const QLabel* label : window.findChildren<QLabel*>())
        if (label->isVisible()) {
            EXPECT_NE(label->textFormat(), Qt::AutoText) << placeOf(label).toStdString();
        }
    EXPECT_EQ(later.textFormat(), Qt::PlainText);
}

}  // namespace
}  // namespace keyblock
