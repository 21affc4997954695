// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/start/start_page.h"

#include "ui/document/document.h"
#include "ui/document/recent_files.h"
#include "ui/look/commands.h"
#include "ui/look/theme.h"
#include "ui/start/gallery.h"
#include "ui/start/recovery_box.h"
#include "ui/start/start_buttons.h"
#include "ui/start/thumbnails.h"

#include <QAction>
#include <QApplication>
#include <QCheckBox>
#include <QDockWidget>
#include <QEvent>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QMainWindow>
#include <QMenuBar>
#include <QPainter>
#include <QPushButton>
#include <QVariant>
#include <QScrollArea>
#include <QSettings>
#include <QStatusBar>
#include <QTabBar>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>

namespace keyblock {

namespace {

constexpr int sideWidth = 424, narrowSide = 340, leastPage = 1000, rim = 24;  // [px]
constexpr std::size_t mostBoxes = 3;
constexpr char atStartKey[] = "start/showPage", commandKey[] = "command";

void clear(QLayout& layout) {
    while (QLayoutItem* item = layout.takeAt(0)) {
        if (QWidget* widget = item->widget()) {
            widget->hide();
            widget->deleteLater();
        }
        delete item;
    }
}

QLabel* label(const QString& text, const char* name, QWidget* parent) {
    auto* made = new QLabel(text, parent);
    made->setObjectName(name);
    return made;
}

}  // namespace

StartPage::StartPage(const Rooms& rooms, QWidget* covered)
    : QWidget(covered), rooms_(rooms), thumbnails_(new Thumbnails(this)), side_(makeSide()) {
    setObjectName("startPage");
    setAccessibleName(tr("Start page"));
    auto* gallery = new Gallery(rooms.themes, *thumbnails_, this);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    row->addWidget(side_);
    row->addWidget(gallery, 1);
    connect(gallery, &Gallery::wanted, this, &StartPage::sampleWanted);
    connect(&rooms.recent, &RecentFiles::changed, this, [this] { if (isVisible()) showRecent(); });
    connect(&rooms.document, &Document::replaced, this, &QWidget::hide);
    connect(&rooms.document, &Document::changed, this, &QWidget::hide);
    connect(&rooms.themes, &Themes::changed, this, [this] {
        showIcons();
        if (!isVisible()) return;
        showRecovery();
        showRecent();
    });
    connect(thumbnails_, &Thumbnails::ready, this,
            [this](const QString& path, QSize size, const QImage& image, const SceneFacts& facts) {
                if (size != QSize(RecentRow::thumbWidth, RecentRow::thumbHeight)) return;
                for (RecentRow* recentRow : findChildren<RecentRow*>())
                    if (recentRow->text() == path) recentRow->setPicture(image, facts);
            });
    showIcons();
    hide();
}

bool StartPage::isWantedAtStart() { return QSettings().value(atStartKey, true).toBool(); }

void StartPage::open() {
    showRecovery();
    showRecent();
    follow();
    raise();
    show();
    setFocus();
}

QWidget* StartPage::makeSide() {
    auto* side = new QWidget(this);
    side->setObjectName("startSide");
    side->setFixedWidth(sideWidth);
    auto* column = new QVBoxLayout(side);
    column->setContentsMargins(0, 32, 0, 0);
    column->setSpacing(0);
    column->addWidget(makeTitle());
    column->addSpacing(24);
    column->addWidget(makeButtons());
    auto* boxes = new QWidget(side);
    recovery_ = new QVBoxLayout(boxes);
    recovery_->setContentsMargins(rim, 20, rim, 0);
    recovery_->setSpacing(8);
    column->addWidget(boxes);
    auto* header = new QWidget(side);
    auto* row = new QHBoxLayout(header);
    row->setContentsMargins(rim, 22, rim, 8);
    row->addWidget(label(tr("Recent"), "listTitle", header), 1);
    row->addWidget(label(tr("Last opened"), "hint", header));
    column->addWidget(header);
    column->addWidget(label({}, "separatorLine", side));
    auto* list = new QWidget;
    recent_ = new QVBoxLayout(list);
    recent_->setContentsMargins(0, 4, 0, 4);
    recent_->setSpacing(0);
    auto* scroll = new QScrollArea(side);
    scroll->setObjectName("recentScroll");
    scroll->setWidget(list);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setFocusPolicy(Qt::NoFocus);
    column->addWidget(scroll, 1);
    column->addWidget(makeFoot());
    return side;
}

QWidget* StartPage::makeTitle() {
    auto* title = new QWidget(this);
    auto* grid = new QGridLayout(title);
    grid->setContentsMargins(rim, 0, rim, 0);
    grid->setHorizontalSpacing(14);
    grid->setVerticalSpacing(0);
    auto* icon = new QLabel(title);
    icon->setPixmap(QIcon(":/icons/app.svg").pixmap(40, 40));
    grid->addWidget(icon, 0, 0, 2, 1);
    grid->addWidget(label(tr("Keyblock Studio"), "pageTitle", title), 0, 1);
    grid->addWidget(label(tr("2D discontinuous deformation analysis with rock bolts"), "hint", title), 1, 1);
    grid->setColumnStretch(1, 1);
    return title;
}

QWidget* StartPage::makeCommandButton(const QString& id, bool primary) {
    QAction* action = rooms_.commands.action(id);
    QString words = id == "file.open" ? tr("Open scene") : action->text();
    words.remove(QStringLiteral("…"));
    auto* button = new QPushButton(action->icon(), "  " + words, this);
    button->setProperty("start", true);
    button->setProperty("primary", primary);
    button->setProperty(commandKey, id);
    button->setAutoDefault(true);  // Enter presses it, as Space does
    button->setObjectName("start." + id);
    button->setAccessibleName(words);
    button->setToolTip(action->toolTip());
    auto* row = new QHBoxLayout(button);
    row->setContentsMargins(0, 0, 12, 0);
    QLabel* keys = label(keysOf(*action), primary ? "keysOnAccent" : "keys", button);
    row->addWidget(keys, 0, Qt::AlignRight);
    connect(&rooms_.commands, &Commands::keysChanged, keys, [keys, action] { keys->setText(keysOf(*action)); });
    connect(button, &QPushButton::clicked, action, &QAction::trigger);
    return button;
}

/// Updates the icons of buttons: those of commands follow the theme, but their copies on buttons do not.
void StartPage::showIcons() {
    for (QPushButton* button : side_->findChildren<QPushButton*>()) {
        const QString id = button->property(commandKey).toString();
        if (id.isEmpty()) continue;
        const bool isPrimary = button->property("primary").toBool();
        button->setIcon(isPrimary ? rooms_.themes.icon("plus", rooms_.themes.current().onAccent)
                                  : rooms_.commands.action(id)->icon());
    }
}

QWidget* StartPage::makeButtons() {
    auto* buttons = new QWidget(this);
    auto* grid = new QGridLayout(buttons);
    grid->setContentsMargins(rim, 0, rim, 0);
    grid->setSpacing(8);
    int at = 0;
    for (const char* id : {"file.new", "file.open", "file.importDxf", "file.importCsv"})
        if (rooms_.commands.has(id)) {
            grid->addWidget(makeCommandButton(id, at == 0), at / 2, at % 2);
            ++at;
        }
    return buttons;
}

QWidget* StartPage::makeFoot() {
    auto* foot = new QWidget(this);
    foot->setObjectName("startFoot");
    auto* column = new QVBoxLayout(foot);
    column->setContentsMargins(rim - 8, 8, rim, 10);
    column->setSpacing(8);
    auto* row = new QHBoxLayout;
    row->setSpacing(4);
    const std::pair<const char*, QString> links[]{{"help.contents", tr("Manual")}, {"panel.library", tr("Bolt library")},
                                                  {"help.verification", tr("Verification")}, {"help.keys", tr("Shortcuts")}};
    for (const auto& [id, words] : links) {
        if (!rooms_.commands.has(id)) continue;
        QAction* action = rooms_.commands.action(id);
        auto* link = new QPushButton(action->icon(), " " + words, foot);
        link->setProperty("quiet", true);
        link->setProperty(commandKey, action->objectName());
        link->setAutoDefault(true);  // Enter presses it, as Space does
        link->setAccessibleName(words);
        link->setToolTip(action->toolTip());
        link->setObjectName("start." + action->objectName());
        connect(link, &QPushButton::clicked, action, &QAction::trigger);
        row->addWidget(link);
    }
    row->addStretch(1);
    auto* atStart = new QCheckBox(tr("Show this page at start-up"), foot);
    atStart->setObjectName("showAtStart");
    atStart->setAccessibleName(atStart->text());
    atStart->setChecked(isWantedAtStart());
    connect(atStart, &QCheckBox::toggled, this, [](bool on) { QSettings().setValue(atStartKey, on); });
    column->addLayout(row);
    auto* second = new QHBoxLayout;
    second->addSpacing(8);
    second->addWidget(atStart, 1);
    column->addLayout(second);
    return foot;
}

std::vector<Abandoned> StartPage::lookForAbandoned() {
    QStringList unusable;
    std::vector<Abandoned> found = abandonedJournals(journalFolder(), &unusable);
    if (!unusable.isEmpty())
        Q_EMIT reported(tr("A recovery journal cannot be read and was set aside: %1").arg(unusable.join(", ")));
    return found;
}

void StartPage::showRecovery() {
    clear(*recovery_);
    const std::vector<Abandoned> found = lookForAbandoned();
    for (std::size_t i = 0; i < std::min(found.size(), mostBoxes); ++i) {
        auto* box = new RecoveryBox(found[i], rooms_.themes, this);
        // Deferred, because the action deletes the box.
        connect(box, &RecoveryBox::recoverWanted, this, [this](const Abandoned& abandoned, Recover what) {
            QTimer::singleShot(0, this, [=, this] { Q_EMIT recoverWanted(abandoned, what); });
        });
        connect(box, &RecoveryBox::giveUpWanted, this, [this](const Abandoned& abandoned) {
            giveUp(abandoned);
            QTimer::singleShot(0, this, &StartPage::showRecovery);
        });
        recovery_->addWidget(box);
    }
    if (found.size() > mostBoxes)
        recovery_->addWidget(label(tr("%1 more").arg(found.size() - mostBoxes), "hint", this));
    recovery_->parentWidget()->setVisible(!found.empty());
}

void StartPage::showRecent() {
    clear(*recent_);
    for (const RecentFile& file : rooms_.recent.files()) {
        auto* row = new RecentRow(file, rooms_.themes, this);
        connect(row, &RecentRow::clicked, this, [this, path = file.path] { Q_EMIT openWanted(path); },
                Qt::QueuedConnection);
        recent_->addWidget(row);
        thumbnails_->ask(file.path, {RecentRow::thumbWidth, RecentRow::thumbHeight}, devicePixelRatioF(),
                         rooms_.themes.current());
    }
    if (rooms_.recent.files().empty()) {
        auto* none = label(tr("Scenes that you open or save are listed here."), "emptyHint", this);
        recent_->addWidget(none);
    }
    recent_->addStretch(1);
}

void StartPage::follow() {
    const auto* window = qobject_cast<QMainWindow*>(parentWidget());
    QRect area = parentWidget()->rect();
    if (window) {
        area.setTop(window->menuWidget() ? window->menuWidget()->geometry().bottom() + 1 : 0);
        if (window->statusBar()->isVisible()) area.setBottom(window->statusBar()->geometry().top() - 1);
    }
    setGeometry(area);
    fitSide(area.width() < leastPage);
    if (isVisible()) stackAboveDocks();
}

/// Hides icons and keys on a narrow screen, where the samples need the space.
void StartPage::fitSide(bool narrow) {
    side_->setFixedWidth(narrow ? narrowSide : sideWidth);
    for (QPushButton* button : side_->findChildren<QPushButton*>())
        if (button->property("quiet").toBool()) button->setIconSize(narrow ? QSize(1, 1) : QSize(16, 16));
    for (const char* name : {"keys", "keysOnAccent"})
        for (QLabel* keys : side_->findChildren<QLabel*>(name)) keys->setVisible(!narrow);
}

/// Raises the page above the docks but below the palette and other overlays.
void StartPage::stackAboveDocks() {
    std::vector<QWidget*> above;
    bool isBehind = true;
    for (QObject* sibling : parentWidget()->children()) {
        auto* widget = qobject_cast<QWidget*>(sibling);
        if (widget == this) isBehind = false;
        const bool isDock = qobject_cast<QDockWidget*>(sibling) || qobject_cast<QTabBar*>(sibling);
        if (!isBehind && widget && widget != this && !isDock && !widget->isWindow()) above.push_back(widget);
    }
    raise();
    for (QWidget* widget : above) widget->raise();
}

/// Keeps the page above docks and their tabs, which are raised when they are shown.
bool StartPage::eventFilter(QObject* watched, QEvent* event) {
    const QEvent::Type type = event->type();
    const bool isSized = watched == parentWidget() && (type == QEvent::Resize || type == QEvent::LayoutRequest);
    const bool isRaised = (type == QEvent::ZOrderChange || type == QEvent::Show) && watched->parent() == parentWidget() &&
                          (qobject_cast<QDockWidget*>(watched) || qobject_cast<QTabBar*>(watched));
    if (isSized || isRaised) QTimer::singleShot(0, this, &StartPage::follow);
    return QWidget::eventFilter(watched, event);
}

void StartPage::paintEvent(QPaintEvent*) { QPainter(this).fillRect(rect(), rooms_.themes.current().window); }

void StartPage::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    qApp->installEventFilter(this);
}

void StartPage::hideEvent(QHideEvent* event) {
    QWidget::hideEvent(event);
    qApp->removeEventFilter(this);
}

void StartPage::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape) hide();
    else QWidget::keyPressEvent(event);
}

void addStartCommands(Commands& commands, StartPage& page) {
    commands.add({"view.start", StartPage::tr("Start page"), "View", "home",
                  StartPage::tr("Shows recent scenes, samples and edits that can be recovered."), {}, false, "start"},
                 [&page] { page.open(); });
}

}  // namespace keyblock
