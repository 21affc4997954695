// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/time_line.h"

#include "solver/results/history.h"
#include "solver/results/result_names.h"
#include "ui/docks/event_marks.h"
#include "ui/docks/time_track.h"
#include "ui/look/action_button.h"
#include "ui/look/commands.h"
#include "ui/look/display.h"
#include "ui/look/elided_label.h"
#include "ui/look/theme.h"
#include "ui/picture/captions.h"
#include "ui/runs/bolt_choice.h"
#include "ui/runs/live_run.h"
#include "ui/runs/time_cursor.h"

#include <QComboBox>
#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <ranges>
#include <utility>

namespace keyblock {

namespace {

constexpr int mostOfLabel = 320, mostOfStage = 120;  // [px]; mostOfStage: room kept for the name of the stage
constexpr int shortest = 3;  // level of `showAsShort`
constexpr int fullHeight = 104, emptyHeight = 30, rowHeight = 28;  // [px]
constexpr double speeds[]{0.1, 0.25, 0.5, 1.0, 2.0, 4.0, 10.0};

QFrame* separatorIn(QWidget* parent) {
    auto* line = new QFrame(parent);
    line->setObjectName("separator");
    line->setFixedSize(1, 18);
    return line;
}

ElidedLabel* labelIn(QWidget* parent, const char* name, const QString& accessible) {
    auto* label = new ElidedLabel(parent);
    label->setMost(mostOfLabel);
    label->setObjectName(name);
    label->setAccessibleName(accessible);
    label->setTextFormat(Qt::PlainText);
    return label;
}

/// Index of the last history row up to a time; −1 before the first.
long rowAt(const HistoryLog& rows, const FrameHead& head) {
    const auto places = std::views::iota(std::size_t{0}, rows.size());
    const auto timeOf = [&](std::size_t row) { return std::pair(rows[row].stage, rows[row].time); };
    const auto after = std::ranges::upper_bound(places, std::pair(head.stage, head.time), {}, timeOf);
    return static_cast<long>(after - places.begin()) - 1;
}

}  // namespace

TimeLine::TimeLine(const Themes& themes, const Display& display, Commands& commands, TimeCursor& cursor,
                   const BoltChoice& choice, QWidget* parent)
    : QWidget(parent), themes_(themes), display_(display), commands_(commands), cursor_(cursor), choice_(choice),
      full_(new QWidget(this)), empty_(new QWidget(this)), track_(new TimeTrack(themes, cursor, full_)) {
    setObjectName("timeLine");
    setAttribute(Qt::WA_StyledBackground);
    setAccessibleName(tr("Timeline"));
    auto* column = new QVBoxLayout(full_);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto* row = new QHBoxLayout;
    row->setContentsMargins(12, 2, 16, 0);
    row->addWidget(transport_ = makeTransport());
    row->addStretch(1);
    row->addWidget(countsBar_ = makeCounts());
    column->addLayout(row);
    column->addWidget(track_);
    auto* hint = new QHBoxLayout(empty_);
    hint->setContentsMargins(16, 0, 16, 0);
    auto* text = labelIn(empty_, "timeLineHint", tr("Timeline"));
    text->setMost(QWIDGETSIZE_MAX);
    const auto tell = [this, text] {
        text->setText(tr("No results yet. Press %1 to run all stages; failures are then marked on the timeline.")
                          .arg(commands_.callOf("run.start")));
    };
    tell();
    connect(&commands, &Commands::keysChanged, text, tell);
    hint->addWidget(text);
    auto* both = new QVBoxLayout(this);
    both->setContentsMargins(0, 0, 0, 0);
    both->setSpacing(0);
    both->addWidget(full_);
    both->addWidget(empty_);
    connect(&themes, &Themes::changed, this, &TimeLine::showIcons);
    connect(&cursor, &TimeCursor::runChanged, this, &TimeLine::showRun);
    connect(&cursor, &TimeCursor::runGrew, this, &TimeLine::showCounts);
    connect(&cursor, &TimeCursor::moved, this, &TimeLine::showMoment);
    connect(&cursor, &TimeCursor::changed, this, [this] {
        showMoment();
        showIcons();
    });
    connect(&choice, &BoltChoice::changed, this, &TimeLine::showMoment);
    connect(&display, &Display::changed, this, &TimeLine::showMoment);
    showIcons();
    showRun();
}

QToolButton* TimeLine::iconButton(const char* command) {
    QToolButton* button = buttonOf(*commands_.action(command), full_);
    button->setFixedSize(28, rowHeight);
    button->setAutoRaise(true);
    return button;
}

QWidget* TimeLine::makeTransport() {
    auto* bar = new QWidget(full_);
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(6);
    row->addWidget(iconButton("time.home"));
    play_ = iconButton("time.play");
    play_->setProperty("framed", "icon");
    row->addWidget(play_);
    row->addWidget(iconButton("time.end"));
    loop_ = new QToolButton(bar);
    loop_->setObjectName("timeLoop");
    loop_->setAccessibleName(tr("Loop"));
    loop_->setToolTip(tr("Loop playback"));
    loop_->setCheckable(true);
    loop_->setFixedSize(28, rowHeight);
    connect(loop_, &QToolButton::toggled, this, [this](bool on) { cursor_.setLoops(on); });
    row->addWidget(loop_);
    speed_ = new QComboBox(bar);
    speed_->setObjectName("timeSpeed");
    speed_->setAccessibleName(tr("Speed"));
    speed_->setToolTip(tr("Playback speed; 1× is 25 frames per second"));
    for (const double speed : speeds) speed_->addItem(QString::number(speed) + QStringLiteral("×"), speed);
    speed_->setCurrentIndex(3);
    speed_->setFixedSize(58, 24);
    connect(speed_, QOverload<int>::of(&QComboBox::activated), this,
            [this](int index) { cursor_.setSpeed(speed_->itemData(index).toDouble()); });
    row->addWidget(speed_);
    row->addWidget(separatorIn(bar));
    stage_ = labelIn(bar, "timeStage", tr("Stage shown"));
    time_ = labelIn(bar, "timeReadout", tr("Time shown"));
    frame_ = labelIn(bar, "timeFrame", tr("Frame shown"));
    time_->setMinimumWidth(86);  // so that the layout does not shift while the time changes
    frame_->setMinimumWidth(104);
    live_ = new QToolButton(bar);
    live_->setObjectName("timeLive");
    live_->setText(tr("Live"));
    live_->setAccessibleName(tr("Live"));
    live_->setFixedHeight(20);
    connect(live_, &QToolButton::clicked, this, [this] { cursor_.goLive(); });
    compare_ = labelIn(bar, "timeCompare", tr("Comparison with cursor B"));
    for (QWidget* widget : {static_cast<QWidget*>(stage_), static_cast<QWidget*>(time_), static_cast<QWidget*>(frame_),
                            static_cast<QWidget*>(live_), static_cast<QWidget*>(separatorIn(bar)),
                            static_cast<QWidget*>(compare_)})
        row->addWidget(widget);
    return bar;
}

QWidget* TimeLine::makeCounts() {
    auto* bar = new QWidget(full_);
    auto* row = new QHBoxLayout(bar);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(2);
    events_ = labelIn(bar, "timeEvents", tr("Events"));
    events_->setText(tr("Events"));
    events_->setMinimumWidth(events_->sizeHint().width());
    row->addWidget(events_);
    for (std::size_t g = 0; g < eventGroups.size(); ++g) {
        const EventGroup group = eventGroups[g].group;
        auto* button = new QToolButton(bar);
        button->setObjectName("count" + QString::number(g));
        button->setAccessibleName(tr("Show events: %1").arg(nameOf(group)));
        button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        button->setCheckable(true);
        button->setChecked(true);
        button->setFixedHeight(24);
        button->setProperty("count", true);
        connect(button, &QToolButton::clicked, this, [this, group](bool on) {
            for (const EventKind kind : kindsOf(group)) cursor_.setHidden(kind, !on);
        });
        counts_[g] = button;
        row->addWidget(button);
    }
    row->addWidget(separatorIn(bar));
    bookmark_ = iconButton("time.bookmark");
    row->addWidget(bookmark_);
    QAction* next = commands_.action("time.nextEvent");
    next_ = buttonOf(*next, bar, [next] { return next->text() + QStringLiteral("  ") + keysOf(*next); });
    next_->setObjectName("nextEvent");
    next_->setFixedHeight(24);
    row->addWidget(next_);
    return bar;
}

void TimeLine::showIcons() {
    play_->setIcon(themes_.icon(cursor_.isPlaying() || cursor_.isLive() ? "pause" : "play", themes_.current().text));
    if (auto* home = full_->findChild<QToolButton*>("time.home")) home->setIcon(themes_.icon("home", themes_.current().text));
    if (auto* end = full_->findChild<QToolButton*>("time.end")) end->setIcon(themes_.icon("end", themes_.current().text));
    loop_->setIcon(themes_.icon("loop"));
    showBookmark();
    for (std::size_t g = 0; g < eventGroups.size(); ++g) {
        constexpr int side = 16, sharp = 3;
        QPixmap pixmap(side * sharp, side * sharp);
        pixmap.setDevicePixelRatio(sharp);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        const bool off = numbers_.of(eventGroups[g].group) == 0 || !counts_[g]->isChecked();
        if (off) painter.setOpacity(0.55);
        drawEventMark(painter, themes_.current(), eventGroups[g].mark, {0.5 * side, 0.5 * side});
        painter.end();
        counts_[g]->setIcon(QIcon(pixmap));
    }
}

void TimeLine::showRun() {
    const bool any = cursor_.run() != nullptr;
    full_->setVisible(any);
    empty_->setVisible(!any);
    setFixedHeight(any ? fullHeight : emptyHeight);
    counted_ = 0;
    numbers_ = {};
    showCounts();
    showMoment();
}

void TimeLine::showCounts() {
    const EventCounts before = numbers_;
    const bool first = counted_ == 0;
    if (cursor_.run()) {
        const std::vector<Event>& events = cursor_.run()->eventList();
        for (; counted_ < events.size(); ++counted_) numbers_.add(events[counted_]);
    }
    if (!first && before == numbers_) return;
    nameCounts();
    fit();
}

void TimeLine::nameCounts() {
    for (std::size_t g = 0; g < eventGroups.size(); ++g) {
        const EventGroup group = eventGroups[g].group;
        const QString number = Display::number(static_cast<double>(numbers_.of(group)), 9);
        const QString kinds = QString::fromStdString(numbers_.kindsText(group));
        counts_[g]->setText(short_ > 0 ? number : nameOf(group) + ' ' + number);
        counts_[g]->setToolTip(tr("Show or hide events on the timeline: %1. “Next event” skips hidden events.")
                                   .arg(nameOf(group)) +
                               (kinds.isEmpty() ? QString() : '\n' + kinds));
        counts_[g]->setEnabled(!kinds.isEmpty());
    }
    showIcons();
}

QSize TimeLine::minimumSizeHint() const { return {420, height()}; }

void TimeLine::resizeEvent(QResizeEvent*) { fit(); }

/// Shows as much as fits. First the names of kinds are hidden, then values that other panels show as well.
void TimeLine::fit() {
    for (int level = 0; level <= shortest; ++level) {
        showAsShort(level);
        const int stage = std::min(stage_->sizeHint().width(), mostOfStage);  // its minimum is 0
        if (transport_->minimumSizeHint().width() + stage + countsBar_->sizeHint().width() + 40 <= width()) return;
    }
}

void TimeLine::showAsShort(int level) {
    if (level == short_) return;
    short_ = level;
    nameCounts();
    events_->setVisible(level < 2);
    frame_->setVisible(level < 2);
    next_->setVisible(level < 2);
    for (QWidget* widget : {static_cast<QWidget*>(loop_), static_cast<QWidget*>(speed_)}) widget->setVisible(level < 3);
    bookmark_->setVisible(level < 3);
    for (QWidget* bar : {transport_, countsBar_}) bar->layout()->invalidate();
}

void TimeLine::showMoment() {
    if (!cursor_.hasMoment()) {
        for (QLabel* label : {stage_, time_, frame_, compare_}) label->clear();
        live_->setVisible(cursor_.goesOn());
        return;
    }
    const LiveRun& run = *cursor_.run();
    const FrameHead head = cursor_.head();
    const QString stage = QString::fromStdString(stageName(run.scene(), head.stage));
    const bool needsOtherRoom = stage != stage_->text() || live_->isHidden() == cursor_.goesOn();
    stage_->setText(stage);
    time_->setText(tr("t = %1").arg(QString::fromStdString(timeText(run.scene(), head.stage, head.time))));
    const auto frame = cursor_.frame();
    const auto count = static_cast<int>(run.frames().size());
    frame_->setText(frame ? tr("frame %1 of %2").arg(*frame + 1).arg(count) : tr("step %1").arg(head.step));
    live_->setVisible(cursor_.goesOn());
    if (needsOtherRoom) fit();
    live_->setProperty("live", cursor_.isLive());
    live_->setText(cursor_.isLive() ? tr("Live") : tr("Go live"));
    const Theme& theme = themes_.current();
    live_->setStyleSheet(cursor_.isLive() ? QStringLiteral("QToolButton { background: %1; color: %2; border: none; "
                                                           "border-radius: 10px; padding: 0 8px; font-weight: 600; }")
                                                .arg(theme.accentSoft.name(), theme.accent.name())
                                          : QString());
    compare_->setText(compareText());
    showBookmark();
}

void TimeLine::showBookmark() {
    const auto here = cursor_.storedFrame();
    const bool marked = here && cursor_.bookmarks().contains(*here);
    bookmark_->setIcon(themes_.icon("bookmark", marked ? themes_.current().accent : themes_.current().text2));
}

/// The time of cursor B, its difference from cursor A, and the change in the force of the selected bolt.
QString TimeLine::compareText() const {
    const auto b = cursor_.cursorB();
    if (!b) return {};
    const LiveRun& run = *cursor_.run();
    const FrameHead &there = run.frames()[*b], here = cursor_.head();
    QString text = tr("B %1").arg(QString::fromStdString(timeText(run.scene(), there.stage, there.time)));
    if (there.stage == here.stage)
        text += QStringLiteral("   Δ(A−B) ") +
                QString::fromStdString(timeText(run.scene(), here.stage, here.time - there.time));
    else
        text += QStringLiteral("   ") + QString::fromStdString(stageName(run.scene(), there.stage));
    const int bolt = choice_.bolt();
    const long a = rowAt(run.historyRows(), here), from = rowAt(run.historyRows(), there);
    if (bolt < 0 || a < 0 || from < 0) return text;
    const std::size_t column = historyColumn(run.scene(), {-1, 0, bolt, BoltQuantity::AxialForce});
    const auto valueAt = [&](long row) { return run.historyRows()[row].values[column]; };
    const ShownUnit unit = display_.shown("N");
    const double change = unit.factor * (valueAt(a) - valueAt(from));
    if (!std::isfinite(change)) return text;
    return text + tr("   ΔN %1 %2 %3")
                      .arg(QString::fromStdString(boltName(run.scene(), bolt)),
                           (change > 0.0 ? QStringLiteral("+") : QString()) + Display::number(change, 4), unit.symbol);
}

}  // namespace keyblock
