// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/help_width.h"

#include "ui/window/dock.h"

#include <QDockWidget>
#include <QEvent>
#include <QMainWindow>
#include <QTimer>

#include <algorithm>

namespace keyblock {

namespace {

constexpr int helpWidth = 460;  // [px]
constexpr double mostOfWindow = 0.36;  // largest share of the window's width

}  // namespace

HelpWidth::HelpWidth(QMainWindow& window, QDockWidget& help, QDockWidget& properties)
    : QObject(&help), window_(window), help_(help), properties_(properties), base_(propertyWidth) {
    connect(&help, &QDockWidget::visibilityChanged, this, &HelpWidth::follow);
    properties.installEventFilter(this);
}

bool HelpWidth::sharesPlace() const {
    return !help_.isFloating() && window_.tabifiedDockWidgets(&properties_).contains(&help_);
}

int HelpWidth::wideWidth() const {
    return std::max(base_, std::min(helpWidth, static_cast<int>(mostOfWindow * window_.width())));
}

/// Widens the dock for help and restores its width. Deferred, because the docks get their positions after the signal.
void HelpWidth::follow(bool inFront) {
    if (inFront && !wide_ && sharesPlace()) {
        wide_ = true;
        QTimer::singleShot(0, this, [this] {
            if (wide_) window_.resizeDocks({&help_}, {wideWidth()}, Qt::Horizontal);
        });
    } else if (!inFront && wide_) {
        QTimer::singleShot(0, this, [this] {
            if (help_.isVisible() && sharesPlace() && !help_.visibleRegion().isEmpty()) return;
            window_.resizeDocks({&properties_}, {base_}, Qt::Horizontal);
            QTimer::singleShot(0, this, [this] { wide_ = false; });
        });
    }
}

bool HelpWidth::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize && !wide_ && properties_.isVisible() && !properties_.isFloating())
        base_ = properties_.width();
    return QObject::eventFilter(watched, event);
}

}  // namespace keyblock
