// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/events_list.h"

#include "solver/results/result_names.h"
#include "ui/docks/event_marks.h"
#include "ui/look/display.h"
#include "ui/look/plain_text.h"
#include "ui/look/theme.h"
#include "ui/picture/captions.h"
#include "ui/runs/bolt_choice.h"
#include "ui/runs/live_run.h"
#include "ui/runs/time_cursor.h"

#include <QHeaderView>
#include <QLabel>
#include <QPainter>
#include <QPixmap>
#include <QScrollBar>
#include <QTreeView>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>

namespace keyblock {

namespace {

QPixmap markOf(const Theme& theme, EventKind kind) {
    constexpr int side = 16, sharp = 2;
    QPixmap pixmap(side * sharp, side * sharp);
    pixmap.setDevicePixelRatio(sharp);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    drawEventMark(painter, theme, rowOf(kind).mark, {0.5 * side, 0.5 * side});
    return pixmap;
}

}  // namespace

EventsModel::EventsModel(const Themes& themes, const Display& display, TimeCursor& cursor, QObject* parent)
    : QAbstractTableModel(parent), themes_(themes), display_(display), cursor_(cursor) {}

void EventsModel::takeRun() {
    beginResetModel();
    rows_.clear();
    seen_ = 0;
    if (cursor_.run())
        for (const Event& event : cursor_.run()->eventList()) {
            if (!cursor_.hiddenKinds().contains(event.kind)) rows_.push_back(seen_);
            ++seen_;
        }
    endResetModel();
}

void EventsModel::takeMore() {
    if (!cursor_.run()) return;
    const std::vector<Event>& events = cursor_.run()->eventList();
    std::vector<std::size_t> more;
    for (; seen_ < events.size(); ++seen_)
        if (!cursor_.hiddenKinds().contains(events[seen_].kind)) more.push_back(seen_);
    if (more.empty()) return;
    const auto first = static_cast<int>(rows_.size());
    beginInsertRows({}, first, first + static_cast<int>(more.size()) - 1);
    rows_.insert(rows_.end(), more.begin(), more.end());
    endInsertRows();
}

int EventsModel::lastRowUntil(long events) const {
    const auto after = std::lower_bound(rows_.begin(), rows_.end(), static_cast<std::size_t>(std::max(events, 0L)));
    return static_cast<int>(after - rows_.begin()) - 1;
}

int EventsModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int EventsModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : columns; }

QVariant EventsModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole) return {};
    const std::array<QString, columns> names{tr("No."), tr("Time"), tr("Event"), tr("Where"), tr("Force"), tr("Cause")};
    return names[static_cast<std::size_t>(section)];
}

QVariant EventsModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || !cursor_.run()) return {};
    const std::size_t number = eventAt(index.row());
    const std::vector<Event>& events = cursor_.run()->eventList();
    if (number >= events.size()) return {};
    const Event& event = events[number];
    if (role == Qt::DisplayRole) return text(event, number, index.column());
    if (role == Qt::DecorationRole && index.column() == What) return markOf(themes_.current(), event.kind);
    if (role == Qt::ToolTipRole)
        return asTip(index.column() == Time ? text(event, number, Time).toString() : chainOf(number));
    const bool isNumber = index.column() == Number || index.column() == Force || index.column() == Cause;
    if (role == Qt::TextAlignmentRole) return int(Qt::AlignVCenter | (isNumber ? Qt::AlignRight : Qt::AlignLeft));
    if (role == Qt::ForegroundRole && cursor_.hasMoment() && static_cast<long>(number) >= cursor_.head().events)
        return themes_.current().text3;
    return {};
}

QVariant EventsModel::text(const Event& event, std::size_t number, int column) const {
    const LiveRun& run = *cursor_.run();
    switch (column) {
        case Number: return QString::number(number + 1);
        case Time:
            return QString::fromStdString((run.scene().stages.size() > 1 ? stageName(run.scene(), event.stage) + "  " : "") +
                                          timeText(run.scene(), event.stage, event.time));
        case What: return nameOf(event.kind);
        case Where: {
            QString where = event.bolt >= 0 ? QString::fromStdString(boltName(run.scene(), event.bolt))
                                            : QString::fromStdString(blockName(run.blockNames(), event.block));
            if (event.bolt >= 0 && event.node >= 0) where += tr(" · node %1").arg(event.node);
            else if (event.bolt >= 0 && event.element >= 0) where += tr(" · element %1").arg(event.element);
            else if (event.otherBlock >= 0)
                where += QStringLiteral(" · ") + QString::fromStdString(blockName(run.blockNames(), event.otherBlock));
            return where;
        }
        case Force: {
            // a shear force is unsigned here
            const double force = rowOf(event.kind).isOfShear ? std::abs(event.shearForce) : event.axialForce;
            const ShownUnit unit = display_.shown("N");
            return force == 0.0 ? QString() : Display::number(unit.factor * force, 4) + ' ' + unit.symbol;
        }
        case Cause: return event.cause >= 0 ? QString::number(event.cause + 1) : QString();
        default: return {};
    }
}

/// The chain of causes from the load to this event, with one cause per line.
QString EventsModel::chainOf(std::size_t number) const {
    const std::vector<Event>& events = cursor_.run()->eventList();
    QStringList lines;
    long at = static_cast<long>(number);
    for (int i = 0; i < 12 && at >= 0 && static_cast<std::size_t>(at) < events.size(); ++i) {
        const Event& event = events[at];
        lines.prepend(QStringLiteral("%1  %2 · %3")
                          .arg(at + 1)
                          .arg(nameOf(event.kind), text(event, static_cast<std::size_t>(at), Where).toString()));
        if (event.cause >= at) break;
        at = event.cause;
    }
    if (at < 0) lines.prepend(tr("load"));
    return lines.join(QStringLiteral("\n→ "));
}

EventsList::EventsList(const Themes& themes, const Display& display, TimeCursor& cursor, BoltChoice& choice,
                       QWidget* parent)
    : QWidget(parent), cursor_(cursor), choice_(choice), model_(new EventsModel(themes, display, cursor, this)),
      view_(new QTreeView(this)), empty_(new QLabel(tr("Failures are listed here as they occur."), this)) {
    setObjectName("eventsList");
    setAttribute(Qt::WA_StyledBackground);
    setAccessibleName(tr("Events"));
    view_->setObjectName("events");
    view_->setAccessibleName(tr("Events"));
    view_->setModel(model_);
    view_->setRootIsDecorated(false);
    view_->setUniformRowHeights(true);
    view_->setAlternatingRowColors(false);
    view_->setEditTriggers(QAbstractItemView::NoEditTriggers);
    view_->header()->setMinimumSectionSize(24);
    view_->header()->setStretchLastSection(false);
    view_->setColumnWidth(EventsModel::Number, 34);
    view_->setColumnWidth(EventsModel::Force, 72);
    view_->setColumnWidth(EventsModel::Cause, 40);
    for (const auto column : {EventsModel::Time, EventsModel::What, EventsModel::Where})  // share the remaining width
        view_->header()->setSectionResizeMode(column, QHeaderView::Stretch);
    empty_->setAlignment(Qt::AlignCenter);
    empty_->setWordWrap(true);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(view_);
    column->addWidget(empty_, 1);
    const auto takeAll = [this] {
        model_->takeRun();
        showMoment();
    };
    connect(&cursor, &TimeCursor::runChanged, this, takeAll);
    connect(&cursor, &TimeCursor::runGrew, this, &EventsList::grow);
    connect(&cursor, &TimeCursor::moved, this, &EventsList::showMoment);
    connect(&cursor, &TimeCursor::changed, this, [this, hidden = std::set<EventKind>()]() mutable {
        if (hidden == cursor_.hiddenKinds()) return;
        hidden = cursor_.hiddenKinds();
        model_->takeRun();
        showMoment();
    });
    connect(&themes, &Themes::changed, view_->viewport(), QOverload<>::of(&QWidget::update));
    connect(&display, &Display::changed, view_->viewport(), QOverload<>::of(&QWidget::update));
    connect(view_, &QTreeView::clicked, this, &EventsList::open);
    connect(view_, &QTreeView::activated, this, &EventsList::open);
    takeAll();
}

std::size_t EventsList::count() const { return cursor_.run() ? cursor_.run()->eventList().size() : 0; }

/// Adds the new events. A list that showed its end during a run still shows its end afterwards.
void EventsList::grow() {
    const QScrollBar* bar = view_->verticalScrollBar();
    const bool atEnd = bar->value() >= bar->maximum();
    const int before = model_->rowCount();
    model_->takeMore();
    if (model_->rowCount() == before) return;
    showMoment();
    if (atEnd && cursor_.isLive()) view_->scrollToBottom();
}

void EventsList::showMoment() {
    const bool any = model_->rowCount() > 0;
    view_->setVisible(any);
    empty_->setVisible(!any);
    view_->viewport()->update();
    if (any && cursor_.hasMoment() && !cursor_.isLive() && !opening_) followMoment();
    Q_EMIT countChanged();
}

/// Makes the last event up to the time shown the current row, and scrolls to it.
void EventsList::followMoment() {
    const int row = model_->lastRowUntil(cursor_.head().events);
    const QModelIndex index = model_->index(std::max(row, 0), 0);
    if (row >= 0) view_->setCurrentIndex(index);
    else view_->setCurrentIndex({});
    view_->scrollTo(index);
}

void EventsList::open(const QModelIndex& index) {
    if (!index.isValid() || !cursor_.run()) return;
    const std::vector<Event>& events = cursor_.run()->eventList();
    const std::size_t number = model_->eventAt(index.row());
    if (number >= events.size()) return;
    const Event event = events[number];
    cursor_.pause();
    opening_ = true;  // the row that was clicked stays the current one
    cursor_.goToEvent(event);
    opening_ = false;
    if (event.bolt >= 0) choice_.choose(event.bolt);
    else if (event.block >= 0) Q_EMIT blockAsked(event.block, nameOf(event.kind));
}

}  // namespace keyblock
