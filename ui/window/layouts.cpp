// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/layouts.h"

#include "ui/look/commands.h"
#include "ui/window/dock.h"

#include <QCoreApplication>
#include <QDockWidget>
#include <QEvent>
#include <QLineEdit>
#include <QMainWindow>
#include <QMenu>
#include <QSettings>
#include <QTimer>
#include <QToolButton>
#include <QWidgetAction>

#include <algorithm>
#include <utility>
#include <vector>

namespace keyblock {

namespace {

constexpr int version = 2;  // version of the saved states; states of other versions are ignored
constexpr char folder[] = "layouts";
constexpr int bottomHeight = 240, leastBottom = 172, others = 640;  // [px]

// Tab groups of docks, placed side by side below the timeline. The first dock of each group is in front.
using Groups = std::vector<std::vector<const char*>>;

constexpr std::array arrangements{Arrangement::Drawing, Arrangement::Results, Arrangement::Studies};

/// A study has its own page in place of the canvas, and no docks below it.
const Groups& groupsOf(Arrangement arrangement) {
    static const Groups none;
    if (arrangement == Arrangement::Studies) return none;
    static const Groups drawing{{"problemsDock", "stagesDock", "libraryDock"}, {"censusDock", "stressDock"}};
    static const Groups results{
        {"stripDock"},
        {"curvesDock", "energyDock", "quantitiesDock", "safetyDock", "accuracyDock"},
        {"stabilityDock", "healthDock", "eventsDock", "runsDock", "logDock"}};
    return arrangement == Arrangement::Drawing ? drawing : results;
}

QList<int> widthsOf(Arrangement arrangement) {
    return arrangement == Arrangement::Drawing ? QList<int>{880, 720} : QList<int>{740, 440, 420};
}

QDockWidget* dock(QMainWindow& window, const char* id) { return window.findChild<QDockWidget*>(id); }

QList<QDockWidget*> docksOf(QMainWindow& window, const std::vector<const char*>& ids) {
    QList<QDockWidget*> docks;
    for (const char* id : ids)
        if (QDockWidget* found = dock(window, id)) docks << found;
    return docks;
}

/// All tab groups of all arrangements, without empty ones.
QList<QList<QDockWidget*>> allGroups(QMainWindow& window) {
    QList<QList<QDockWidget*>> groups;
    for (const Arrangement arrangement : arrangements)
        for (const auto& group : groupsOf(arrangement)) groups << docksOf(window, group);
    groups.removeAll({});
    return groups;
}

/// Puts the docks of all arrangements side by side below the timeline; the caller decides which are visible.
void placeAll(QMainWindow& window) {
    QDockWidget* last = dock(window, "timeDock");
    if (!last) return;
    const QList<QList<QDockWidget*>> groups = allGroups(window);
    for (const auto& group : groups)
        for (QDockWidget* member : group) window.removeDockWidget(member);
    window.addDockWidget(Qt::BottomDockWidgetArea, last);
    last->show();
    Qt::Orientation direction = Qt::Vertical;
    for (const auto& group : groups) {
        window.splitDockWidget(last, group.front(), direction);
        last = group.front();
        direction = Qt::Horizontal;
    }
    // Tabs are made last, because a dock that is placed next to a tab group would be added to the group.
    for (const auto& group : groups)
        for (int i = 1; i < group.size(); ++i) window.tabifyDockWidget(group[i - 1], group[i]);
}

/// Places the tree at the left and the properties at the right. Help is in a tab behind the properties and closed.
void placeSides(QMainWindow& window) {
    QDockWidget *tree = dock(window, "sceneDock"), *properties = dock(window, "propertyDock"),
                *help = dock(window, "helpDock");
    if (!tree || !properties || !help) return;
    for (QDockWidget* side : {tree, properties, help}) side->setFloating(false);
    window.addDockWidget(Qt::LeftDockWidgetArea, tree);
    window.addDockWidget(Qt::RightDockWidgetArea, properties);
    window.tabifyDockWidget(properties, help);
    help->hide();
    tree->show();
    properties->show();
    QTimer::singleShot(0, &window, [&window, tree, properties] {
        window.resizeDocks({tree, properties}, {treeWidth, propertyWidth}, Qt::Horizontal);
    });
}

/// Shows the docks of an arrangement and hides those of the others.
void showOnly(QMainWindow& window, Arrangement shown) {
    if (QDockWidget* time = dock(window, "timeDock")) time->setVisible(shown != Arrangement::Studies);
    for (const Arrangement arrangement : arrangements)
        for (const auto& group : groupsOf(arrangement))
            for (QDockWidget* member : docksOf(window, group)) {
                member->setFloating(false);
                member->setVisible(arrangement == shown);
            }
}

void size(QMainWindow& window, Arrangement arrangement) {
    QList<QDockWidget*> firsts;
    QList<int> widths;
    for (std::size_t i = 0; i < groupsOf(arrangement).size(); ++i) {
        const QList<QDockWidget*> members = docksOf(window, groupsOf(arrangement)[i]);
        if (members.isEmpty()) continue;
        members.front()->raise();
        firsts << members.front();
        widths << widthsOf(arrangement)[static_cast<int>(i)];
    }
    if (firsts.isEmpty()) return;
    window.resizeDocks(firsts, widths, Qt::Horizontal);
    // On a low screen the canvas has priority.
    const int bottom = std::clamp(window.height() - others, leastBottom, bottomHeight);
    window.resizeDocks({firsts.front()}, {bottom}, Qt::Vertical);
}

/// The widest dock in front below the timeline, which gets a dock of another arrangement as a tab. Null if the dock has a
/// place already.
QDockWidget* hostFor(QMainWindow& window, Arrangement arrangement, QDockWidget& guest) {
    for (const auto& group : groupsOf(arrangement))
        if (docksOf(window, group).contains(&guest)) return nullptr;
    const auto isBelow = [&window](QDockWidget* dock) {
        return window.dockWidgetArea(dock) == Qt::BottomDockWidgetArea && !dock->isFloating() &&
               dock->features().testFlag(QDockWidget::DockWidgetClosable);
    };
    const QList<QDockWidget*> neighbours = window.tabifiedDockWidgets(&guest);
    const auto isShown = [](const QDockWidget* dock) { return !dock->isHidden(); };
    if (!isBelow(&guest) || std::any_of(neighbours.begin(), neighbours.end(), isShown)) return nullptr;
    QDockWidget* widest = nullptr;
    for (QDockWidget* host : window.findChildren<QDockWidget*>()) {
        const bool isInFront = isBelow(host) && isShown(host) && !host->visibleRegion().isEmpty();
        if (isInFront && (!widest || host->width() > widest->width())) widest = host;
    }
    return widest;
}

QString keyOf(Arrangement arrangement) {
    static constexpr std::array keys{"drawing", "results", "studies"};
    return QString::fromLatin1(keys.at(static_cast<std::size_t>(arrangement)));
}

QString pathOf(const QString& name, Arrangement arrangement) {
    // Written in hexadecimal, because a name may contain separators of settings keys.
    return QString(folder) + "/named/" + QString::fromLatin1(name.toUtf8().toHex()) + '/' + keyOf(arrangement);
}

}  // namespace

Layouts::Layouts(QMainWindow& window, Commands& commands) : QObject(&window), window_(window) {
    addDockCommands(commands);
    commands.add({"view.resetLayout", tr("Reset layout"), "View", {}, tr("Restores the default layout."), {},
                  false, "layout"},
                 [this] { reset(); });
}

void Layouts::begin() {
    const QSettings settings;
    for (const Arrangement each : arrangements)
        states_[static_cast<std::size_t>(each)] = settings.value(QString(folder) + '/' + keyOf(each)).toByteArray();
    setCurrent(settings.value(QString(folder) + "/current").toString());
    placeAll(window_);
    apply();
}

void Layouts::show(Arrangement arrangement) {
    if (arrangement == arrangement_) return;
    now() = window_.saveState(version);
    arrangement_ = arrangement;
    apply();
}

/// Restores the saved arrangement, or the default one. Sizes are set once the window is laid out; painting waits until
/// then, because the docks would overlap before.
void Layouts::apply() {
    window_.setAnimated(false);
    window_.setUpdatesEnabled(false);
    const bool isRestored = !now().isEmpty() && window_.restoreState(now(), version);
    if (!isRestored) {
        if (std::exchange(hasGuests_, false)) placeAll(window_);
        showOnly(window_, arrangement_);
    }
    QTimer::singleShot(0, this, [this, isRestored, shown = arrangement_] {
        // The timeline grows when a run is shown; after the sizes are set it would take its height from the docks below.
        QCoreApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
        if (!isRestored && shown == arrangement_) size(window_, shown);
        window_.setUpdatesEnabled(true);
        window_.setAnimated(true);
        window_.repaint();  // Qt loses an update that was requested before updates were disabled
    });
}

void Layouts::keep() {
    now() = window_.saveState(version);
    QSettings settings;
    for (const Arrangement each : arrangements)
        settings.setValue(QString(folder) + '/' + keyOf(each), states_[static_cast<std::size_t>(each)]);
    settings.setValue(QString(folder) + "/current", current_);
}

void Layouts::reset() {
    states_ = {};
    placeSides(window_);
    placeAll(window_);
    apply();
    setCurrent({});
}

void Layouts::reveal(QDockWidget& shown) {
    QDockWidget* host = shown.isHidden() && !shown.isFloating() ? hostFor(window_, arrangement_, shown) : nullptr;
    if (host) {
        window_.tabifyDockWidget(host, &shown);
        hasGuests_ = true;
    }
    shown.show();
    shown.raise();
}

QStringList Layouts::names() const {
    QSettings settings;
    settings.beginGroup(QString(folder) + "/named");
    QStringList names;
    for (const QString& hex : settings.childGroups()) names << QString::fromUtf8(QByteArray::fromHex(hex.toLatin1()));
    names.sort(Qt::CaseInsensitive);
    return names;
}

void Layouts::save(const QString& name) {
    now() = window_.saveState(version);
    QSettings settings;
    for (const Arrangement each : arrangements)
        settings.setValue(pathOf(name, each), states_[static_cast<std::size_t>(each)]);
    setCurrent(name);
}

void Layouts::load(const QString& name) {
    const QSettings settings;
    for (const Arrangement each : arrangements) {
        const QByteArray kept = settings.value(pathOf(name, each)).toByteArray();
        states_[static_cast<std::size_t>(each)] = kept;
    }
    apply();
    setCurrent(name);
}

void Layouts::remove(const QString& name) {
    QSettings().remove(pathOf(name, Arrangement::Drawing).section('/', 0, -2));
    if (name == current_) setCurrent({});
}

void Layouts::addDockCommands(Commands& commands) {
    for (QDockWidget* each : window_.findChildren<QDockWidget*>()) {
        if (!each->features().testFlag(QDockWidget::DockWidgetClosable)) continue;
        QAction* action = commands.add({"dock." + each->objectName(),
                                        each->windowTitle(),
                                        "View",
                                        {},
                                        tr("Shows or hides this panel."),
                                        {},
                                        true,
                                        "docks"},
                                       [this, each] {
                                           if (each->isHidden()) reveal(*each);
                                           else each->hide();
                                       });
        const auto tell = [action, each] { action->setChecked(!each->isHidden()); };
        connect(each->toggleViewAction(), &QAction::toggled, action, tell);
        tell();
    }
}

QToolButton* Layouts::makeButton(QWidget* parent) {
    button_ = new QToolButton(parent);
    button_->setObjectName("layoutButton");
    button_->setAccessibleName(tr("Layout"));
    button_->setToolTip(tr("Saved panel layouts"));
    button_->setPopupMode(QToolButton::InstantPopup);
    auto* menu = new QMenu(button_);
    connect(menu, &QMenu::aboutToShow, this, [this, menu] { fillMenu(*menu); });
    button_->setMenu(menu);
    setCurrent(current_);
    return button_;
}

void Layouts::fillMenu(QMenu& menu) {
    menu.clear();
    for (const QString& name : names()) {
        QAction* action = menu.addAction(name, this, [this, name] { load(name); });
        action->setCheckable(true);
        action->setChecked(name == current_);
    }
    if (!menu.isEmpty()) menu.addSeparator();
    auto* field = new QLineEdit(&menu);
    field->setPlaceholderText(tr("Save layout as…"));
    field->setAccessibleName(tr("Name of this layout"));
    field->setMaxLength(60);
    connect(field, &QLineEdit::returnPressed, this, [this, field, &menu] {
        if (!field->text().trimmed().isEmpty()) save(field->text().trimmed());
        menu.close();
    });
    auto* entry = new QWidgetAction(&menu);
    entry->setDefaultWidget(field);
    menu.addAction(entry);
    if (!current_.isEmpty())
        menu.addAction(tr("Delete layout “%1”").arg(current_), this, [this] { remove(current_); });
    menu.addAction(tr("Reset layout"), this, &Layouts::reset);
}

void Layouts::setCurrent(const QString& name) {
    current_ = name;
    if (button_) button_->setText(tr("Layout: %1").arg(name.isEmpty() ? tr("default") : name));
}

}  // namespace keyblock
