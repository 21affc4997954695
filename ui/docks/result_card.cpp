// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/result_card.h"

#include "ui/look/display.h"
#include "ui/look/theme.h"
#include "ui/picture/event_list.h"
#include "ui/runs/block_choice.h"
#include "ui/runs/bolt_choice.h"
#include "ui/runs/live_run.h"
#include "ui/runs/time_cursor.h"

#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QVBoxLayout>
#include <QVariant>

#include <algorithm>
#include <exception>

namespace keyblock {

namespace {

constexpr int nameWidth = 138;  // [px]

/// A bar that shows the utilisation of a strength; amber from 80 %, red from 100 %.
class UseBar : public QWidget {
public:
    UseBar(double use, const Themes& themes, QWidget* parent) : QWidget(parent), use_(use), themes_(themes) {
        setFixedHeight(6);
        setMinimumWidth(40);
    }

protected:
    void paintEvent(QPaintEvent*) override {
        const Theme& theme = themes_.current();
        QPainter painter(this);
        painter.fillRect(rect(), theme.separator);
        const QColor colour = use_ >= 0.9995 ? theme.error : use_ >= 0.8 ? theme.warningFill : theme.accent;
        painter.fillRect(QRectF(0.0, 0.0, width() * std::clamp(use_, 0.0, 1.0), height()), colour);
    }

private:
    double use_;
    const Themes& themes_;
};

QLabel* label(const QString& text, const char* role, QWidget* parent) {
    auto* made = new QLabel(text, parent);
    made->setProperty("role", role);
    made->setWordWrap(true);
    made->setTextFormat(Qt::PlainText);
    made->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return made;
}

}  // namespace

ResultCard::ResultCard(const Themes& themes, const Display& display, TimeCursor& cursor, const BoltChoice& bolts,
                       const BlockChoice& blocks, QWidget* parent)
    : QWidget(parent), themes_(themes), display_(display), cursor_(cursor), bolts_(bolts), blocks_(blocks) {
    setObjectName("resultCard");
    setAccessibleName(tr("Results"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    auto* heading = new QLabel(tr("Results"), this);
    heading->setObjectName("resultHeading");
    column->addWidget(heading);
    for (const auto signal : {&TimeCursor::runChanged, &TimeCursor::moved}) connect(&cursor, signal, this, &ResultCard::make);
    connect(&bolts, &BoltChoice::changed, this, &ResultCard::make);
    connect(&blocks, &BlockChoice::changed, this, &ResultCard::make);
    connect(&display, &Display::changed, this, &ResultCard::make);
    hide();
}

ResultCard::~ResultCard() = default;

void ResultCard::setOn(bool on) {
    if (on == on_) return;
    on_ = on;
    make();
}

void ResultCard::make() {
    const int bolt = bolts_.bolt(), block = blocks_.block();
    if (!on_ || !cursor_.hasMoment() || (bolt < 0 && block < 0)) return show(nullptr);
    reading_.ask([this, moment = cursor_.moment(), bolt, block, numbers = display_.numbers()]() -> Background::Result {
        std::shared_ptr<const ResultReport> made;
        try {
            const auto frame = moment->sharedFrame();
            const std::vector<Event> events = eventsUntil(moment->events(), moment->frames().front());
            made = std::make_shared<const ResultReport>(bolt >= 0
                                                            ? boltResults(*moment, *frame, bolt, events, numbers)
                                                            : blockResults(*moment, *frame, block, events, numbers));
        } catch (const std::exception&) {
            return {};  // the run's files were deleted, which is reported elsewhere
        }
        return [this, made, bolt, block] {
            if (on_ && bolts_.bolt() == bolt && blocks_.block() == block) show(made);
        };
    });
}

void ResultCard::show(std::shared_ptr<const ResultReport> report) {
    const bool isOther = !report_ != !report || (report && report->title != report_->title);
    report_ = std::move(report);
    delete rows_;
    rows_ = nullptr;
    setVisible(report_ != nullptr);
    if (report_) {
        rows_ = new QWidget(this);
        grid_ = new QGridLayout(rows_);
        grid_->setContentsMargins(12, 4, 12, 10);
        grid_->setHorizontalSpacing(10);
        grid_->setVerticalSpacing(3);
        grid_->setColumnMinimumWidth(0, nameWidth);
        grid_->setColumnStretch(1, 1);
        for (const ResultRow& row : report_->rows) addRow(row);
        addEvents();
        layout()->addWidget(rows_);
    }
    if (isOther) Q_EMIT subjectChanged(report_ ? report_->title : QString(), report_ ? report_->detail : QString());
}

void ResultCard::addRow(const ResultRow& row) {
    const int at = grid_->rowCount();
    QLabel* name = label(row.name, "detail", rows_);
    name->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    grid_->addWidget(name, at, 0);
    QLabel* value = label(row.value, "title", rows_);
    value->setAlignment(Qt::AlignRight | Qt::AlignTop);
    value->setAccessibleName(row.name);
    grid_->addWidget(value, at, 1);
    if (row.use) grid_->addWidget(new UseBar(*row.use, themes_, rows_), at + 1, 0, Qt::AlignVCenter);
    if (row.detail.isEmpty()) return;
    QLabel* detail = label(row.detail, "hint", rows_);
    detail->setAlignment(Qt::AlignRight | Qt::AlignTop);
    grid_->addWidget(detail, at + 1, row.use ? 1 : 0, 1, row.use ? 1 : 2);
}

/// Lists events; a click on one moves the time to it.
void ResultCard::addEvents() {
    if (report_->events.empty()) return;
    int at = grid_->rowCount();
    QLabel* heading = label(tr("Events"), "detail", rows_);
    heading->setContentsMargins(0, 6, 0, 0);
    grid_->addWidget(heading, at++, 0, 1, 2);
    for (const ResultEvent& event : report_->events) {
        auto* link = new QLabel(rows_);
        link->setTextFormat(Qt::RichText);
        link->setWordWrap(true);
        link->setText(QStringLiteral("<a style='color:%1; text-decoration:none' href='go'>%2</a> %3")
                          .arg(themes_.current().accent.name(), event.when.toHtmlEscaped(), event.what.toHtmlEscaped()));
        link->setToolTip(tr("Go to this event"));
        connect(link, &QLabel::linkActivated, this, [this, first = event.event] { cursor_.goToEvent(first); });
        grid_->addWidget(link, at++, 0, 1, 2);
    }
}

}  // namespace keyblock
