// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/dock.h"

#include "ui/look/elided_label.h"
#include "ui/look/theme.h"

#include <QDockWidget>
#include <QHBoxLayout>
#include <QMainWindow>
#include <QTabBar>
#include <QTimer>
#include <QToolButton>

#include <algorithm>

namespace keyblock {

namespace {

constexpr int headerHeight = 30, leastWidth = 180, leastHeight = 96;  // [px] header, and smallest size of the content

QToolButton* headerButton(QWidget* header, const Themes& themes, const char* icon, const QString& name) {
    auto* button = new QToolButton(header);
    const auto show = [button, &themes, icon] { button->setIcon(themes.icon(icon)); };
    show();
    QObject::connect(&themes, &Themes::changed, button, show);
    button->setFixedSize(22, 22);
    button->setAccessibleName(name);
    button->setToolTip(name);
    button->setFocusPolicy(Qt::NoFocus);
    return button;
}

/// A header that takes up its fixed height in the dock even while it is not visible.
class DockHeader : public QWidget {
public:
    using QWidget::QWidget;
    QSize sizeHint() const override { return {QWidget::sizeHint().width(), maximumHeight()}; }
    QSize minimumSizeHint() const override { return {QWidget::minimumSizeHint().width(), maximumHeight()}; }
};

QWidget* makeHeader(QDockWidget& dock, const Themes& themes) {
    auto* header = new DockHeader(&dock);
    header->setObjectName("dockHeader");
    header->setAttribute(Qt::WA_StyledBackground);
    header->setFixedHeight(headerHeight);
    auto* row = new QHBoxLayout(header);
    row->setContentsMargins(12, 0, 6, 0);
    row->setSpacing(2);
    auto* title = new ElidedLabel(header);
    title->setObjectName("dockTitle");
    title->setText(dock.windowTitle());
    QObject::connect(&dock, &QDockWidget::windowTitleChanged, title, &ElidedLabel::setText);
    row->addWidget(title, 1);
    QToolButton* floating = headerButton(header, themes, "float", QDockWidget::tr("Float %1").arg(dock.windowTitle()));
    QObject::connect(floating, &QToolButton::clicked, &dock, [&dock] { dock.setFloating(!dock.isFloating()); });
    row->addWidget(floating);
    QToolButton* closing = headerButton(header, themes, "close", QDockWidget::tr("Close %1").arg(dock.windowTitle()));
    QObject::connect(closing, &QToolButton::clicked, &dock, &QDockWidget::hide);
    row->addWidget(closing);
    return header;
}

/// Hides the header in a tab group, where the tab shows the title. The header returns when the dock leaves the group.
void hideSecondHeader(QMainWindow& window, QDockWidget& dock, QWidget& header) {
    const QList<QDockWidget*> others = window.tabifiedDockWidgets(&dock);
    const auto isShown = [](const QDockWidget* other) { return !other->isHidden(); };
    const bool tabbed = !dock.isFloating() && std::any_of(others.begin(), others.end(), isShown);
    header.setFixedHeight(tabbed ? 0 : headerHeight);
    header.setVisible(!tabbed);
    header.updateGeometry();
    for (QTabBar* tabs : window.findChildren<QTabBar*>(QString(), Qt::FindDirectChildrenOnly)) tabs->setDrawBase(false);
}

}  // namespace

QDockWidget* makeDock(QMainWindow& window, const Themes& themes, const QString& id, const QString& title,
                      QWidget* widget) {
    auto* dock = new QDockWidget(title, &window);
    dock->setObjectName(id);
    widget->setMinimumSize(leastWidth, leastHeight);  // content that does not fit is clipped; the window does not grow
    dock->setWidget(widget);
    QWidget* header = makeHeader(*dock, themes);
    dock->setTitleBarWidget(header);
    const auto look = [&window, dock, header] { hideSecondHeader(window, *dock, *header); };
    const auto later = [dock, look] { QTimer::singleShot(0, dock, look); };
    QObject::connect(dock, &QDockWidget::visibilityChanged, dock, later);
    QObject::connect(dock, &QDockWidget::dockLocationChanged, dock, later);
    QObject::connect(dock, &QDockWidget::topLevelChanged, dock, later);
    return dock;
}

QDockWidget* makeBand(QMainWindow& window, const QString& id, const QString& title, QWidget* widget) {
    auto* dock = new QDockWidget(title, &window);
    dock->setObjectName(id);
    dock->setWidget(widget);
    dock->setTitleBarWidget(new QWidget(dock));
    dock->setFeatures(QDockWidget::NoDockWidgetFeatures);
    return dock;
}

}  // namespace keyblock
