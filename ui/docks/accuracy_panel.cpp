// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/accuracy_panel.h"

#include "solver/trade/trade_errors.h"
#include "solver/trade/trade_page.h"
#include "ui/docks/trade_view.h"
#include "ui/document/document.h"
#include "ui/edit/settle.h"
#include "ui/look/display.h"
#include "ui/runs/trade_runs.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QVariant>
#include <QVBoxLayout>

namespace keyblock {

namespace {

constexpr int leastWidthForButton = 340;  // [px] next to the text

bool hasResult(const Trade& trade) { return !trade.points.empty() && trade.points.front().failure.empty(); }

}  // namespace

AccuracyPanel::AccuracyPanel(const Themes& themes, Document& document, TradeRuns& runs, QWidget* parent)
    : QWidget(parent), document_(document), runs_(runs), answer_(new QLabel(this)), detail_(new QLabel(this)),
      progress_(new QProgressBar(this)), start_(new QPushButton(tr("Measure accuracy"), this)),
      stop_(new QPushButton(tr("Stop"), this)), chart_(new TradeView(themes, this)) {
    setObjectName("accuracyPanel");
    setAttribute(Qt::WA_StyledBackground);
    setAccessibleName(tr("Accuracy"));
    answer_->setObjectName("accuracyAnswer");
    answer_->setProperty("role", "title");
    detail_->setObjectName("accuracyDetail");
    detail_->setProperty("role", "detail");
    for (QLabel* label : {answer_, detail_}) {
        label->setWordWrap(true);
        label->setTextFormat(Qt::PlainText);
    }
    detail_->setMinimumHeight(detail_->fontMetrics().lineSpacing());  // the chart stays where it is
    progress_->setTextVisible(false);
    progress_->setFixedHeight(6);
    start_->setObjectName("accuracy.start");
    stop_->setObjectName("accuracy.stop");
    for (QPushButton* button : {start_, stop_}) {
        button->setAccessibleName(button->text());
        button->setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    }
    row_ = new QHBoxLayout;
    row_->addWidget(answer_, 1);
    row_->addWidget(stop_, 0, Qt::AlignTop);
    row_->addWidget(start_, 0, Qt::AlignTop);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(12, 6, 12, 6);
    column->setSpacing(4);
    column->addLayout(row_);
    column->addWidget(progress_);
    column->addWidget(detail_);
    column->addWidget(chart_, 1);
    connect(start_, &QPushButton::clicked, this, [this] {
        used_.clear();
        runs_.start();
    });
    connect(stop_, &QPushButton::clicked, &runs, &TradeRuns::stop);
    connect(&runs, &TradeRuns::changed, this, &AccuracyPanel::fill);
    connect(&document, &Document::changed, this, &AccuracyPanel::fill);
    connect(chart_, &TradeView::picked, this, &AccuracyPanel::use);
    fill();
}

void AccuracyPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    row_->setDirection(width() < leastWidthForButton ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
}

void AccuracyPanel::fill() {
    const bool busy = runs_.isBusy();
    start_->setVisible(!busy);
    stop_->setVisible(busy);
    progress_->setVisible(busy);
    progress_->setValue(static_cast<int>(100.0 * runs_.fraction()));
    answer_->setText(answer());
    detail_->setText(detail());
    if (hasResult(runs_.trade())) chart_->show(tradeChartOf(runs_.trade()));
    else chart_->clear(busy ? tr("The first run has not ended yet.")
                            : tr("Runs the scene with coarser and finer numerical settings, and shows what each costs "
                                 "and changes."));
}

QString AccuracyPanel::answer() const {
    if (!runs_.problem().isEmpty()) return runs_.problem();
    const Trade& trade = runs_.trade();
    if (runs_.isBusy()) return runs_.label().isEmpty() ? tr("Starting") : runs_.label();
    if (trade.points.empty()) return tr("Not measured");
    if (!hasResult(trade))
        return tr("The scene has no result to compare with: %1")
            .arg(QString::fromStdString(trade.points.front().failure));
    const int best = recommendedPreset(trade, recommendedError);
    const QString most = Display::number(100.0 * recommendedError, 2);
    if (best < 0)
        return tr("No preset is recommended: %1.")
            .arg(QString::fromStdString(withoutRecommendation(trade, recommendedError)));
    return tr("Recommended, within %1 % of the finest run: %2")
        .arg(most, QString::fromStdString(sentenceOn(trade, static_cast<std::size_t>(best))));
}

QString AccuracyPanel::detail() const {
    QStringList lines;
    if (!used_.isEmpty()) lines << used_;
    const Trade& trade = runs_.trade();
    if (!runs_.isBusy() && trade.interrupted && hasResult(trade))
        lines << tr("Stopped; these are the runs made so far.");
    if (!runs_.isBusy() && hasResult(trade) && used_.isEmpty() && !runs_.isCurrent())
        lines << tr("The scene has changed since these runs.");
    return lines.join('\n');
}

void AccuracyPanel::use(int point) {
    const auto index = static_cast<std::size_t>(point);
    const TradePoint& chosen = runs_.trade().points[index];
    const QString name = QString::fromStdString(nameOf(chosen));
    if (chosen.axis == bondAxisName) {
        used_ = tr("%1 is another bolt, not another way to compute it; it is not used.").arg(name);
        return fill();
    }
    Scene scene = *document_.committed();
    runs_.trade().settings[index].apply(scene);
    settle(scene);
    used_ = scene == *document_.committed() ? tr("The scene already uses: %1").arg(name)
                                            : tr("The scene now uses: %1. Undo goes back.").arg(name);
    document_.apply(tr("use %1").arg(name), std::move(scene));
    fill();
}

}  // namespace keyblock
