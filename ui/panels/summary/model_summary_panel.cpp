// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/summary/model_summary_panel.h"

#include "ui/document/background.h"
#include "ui/document/document.h"
#include "ui/document/free_memory.h"
#include "ui/look/commands.h"
#include "ui/look/plain_text.h"
#include "ui/look/theme.h"
#include "solver/trade/trade_next.h"
#include "ui/panels/summary/model_summary_rows.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QStyle>
#include <QTimer>
#include <QVariant>
#include <QVBoxLayout>

#include <algorithm>
#include <exception>
#include <initializer_list>
#include <filesystem>
#include <optional>
#include <utility>

namespace keyblock {

namespace {

constexpr int calmBefore = 500;  // [ms] without an edit before counting begins
constexpr int costWidth = 176, roomForReasons = 440, roomForRange = 190, leastWidth = 470;  // [px]

QLabel* labelOf(QWidget* parent, const char* role, const QString& text = {}) {
    auto* label = new QLabel(text, parent);
    label->setProperty("role", role);
    return label;
}

/// Quotes a trade of the scene: the one measured in the window, or else one stored next to its file.
void quoteTrade(ModelSummary& summary, const Scene& scene, const std::filesystem::path& file,
                const MeasuredTrade* trade) {
    if (trade && *trade->scene == scene)
        summary.next = withMeasured(std::move(summary.next), scene, trade->points, trade->quantities);
    else if (const auto stored = file.empty() ? std::nullopt : findStoredTrade(file, scene))
        summary.next = withMeasured(std::move(summary.next), scene, stored->points, stored->quantities);
}

/// Null if the count was stopped or memory ran out.
/// \param file of the scene; empty: none. \param trade null: none.
std::shared_ptr<const ModelSummary> modelSummaryOf(const Scene& scene, const SceneCut* cut,
                                                   const std::filesystem::path& file, const MeasuredTrade* trade,
                                                   const std::atomic<bool>& stop) {
    try {
        std::optional<ModelSummary> summary = makeModelSummary(cut ? cut->scene : scene, cut, &stop);
        if (!summary) return nullptr;
        quoteTrade(*summary, scene, file, trade);
        return std::make_shared<const ModelSummary>(std::move(*summary));
    } catch (const std::exception&) {
        return nullptr;
    }
}

}  // namespace

ModelSummaryPanel::ModelSummaryPanel(Document& document, const Commands& commands, const Themes& themes,
                                     QWidget* parent)
    : QWidget(parent), document_(document), commands_(commands), themes_(themes), counting_(new Background(this)),
      calm_(new QTimer(this)) {
    setObjectName("modelSummaryPanel");
    setAccessibleName(tr("Model summary"));
    setAttribute(Qt::WA_StyledBackground);
    setMinimumWidth(leastWidth);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(0);
    auto* scroll = new QScrollArea(this);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    page_ = new QWidget(scroll);
    page_->setObjectName("modelSummaryPage");
    auto* column = new QVBoxLayout(page_);
    column->setContentsMargins(12, 8, 12, 8);
    state_ = labelOf(page_, "detail");
    state_->setWordWrap(true);
    column->addWidget(state_);
    column->addStretch(1);
    scroll->setWidget(page_);
    row->addWidget(scroll, 1);
    row->addWidget(makeCosts());
    calm_->setSingleShot(true);
    calm_->setInterval(calmBefore);
    connect(calm_, &QTimer::timeout, this, &ModelSummaryPanel::ask);
    connect(&document, &Document::changed, this, &ModelSummaryPanel::askLater);
    connect(&document, &Document::checkedChanged, this, &ModelSummaryPanel::askLater);
    askLater();
}

ModelSummaryPanel::~ModelSummaryPanel() { cancel(); }

QWidget* ModelSummaryPanel::makeCosts() {
    costs_ = new QWidget(this);
    costs_->setObjectName("modelSummaryCosts");
    costs_->setAttribute(Qt::WA_StyledBackground);
    costs_->setFixedWidth(costWidth);
    timeName_ = labelOf(costs_, "detail", tr("Estimated time"));
    time_ = labelOf(costs_, "big");
    range_ = labelOf(costs_, "hint");
    memoryName_ = labelOf(costs_, "detail", tr("Memory"));
    memory_ = labelOf(costs_, "title");
    time_->setObjectName("estimatedTime");
    memory_->setObjectName("estimatedMemory");
    makeRunButton();
    placeCosts();
    return costs_;
}

/// Places the costs one below the other. In a low panel, names and values share lines, so that the button is never
/// clipped.
void ModelSummaryPanel::placeCosts() {
    delete costs_->layout();
    auto* grid = new QGridLayout(costs_);
    grid->setContentsMargins(16, low_ ? 6 : 12, 16, low_ ? 6 : 12);
    grid->setVerticalSpacing(low_ ? 4 : 2);
    grid->setHorizontalSpacing(8);
    timeName_->setText(low_ ? tr("Est. time") : tr("Estimated time"));
    time_->setProperty("role", low_ ? "title" : "big");
    time_->style()->polish(time_);
    range_->setVisible(!low_);
    for (QLabel* value : {time_, memory_}) value->setAlignment((low_ ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    int row = 0;
    const auto add = [&](QLabel* name, QLabel* value) {
        grid->addWidget(name, row, 0, 1, low_ ? 1 : 2);
        if (!low_) ++row;
        grid->addWidget(value, row++, low_ ? 1 : 0, 1, low_ ? 1 : 2);
    };
    add(timeName_, time_);
    if (!low_) grid->addWidget(range_, row++, 0, 1, 2);
    if (!low_) grid->setRowMinimumHeight(row++, 8);
    add(memoryName_, memory_);
    grid->setRowMinimumHeight(row++, low_ ? 0 : 10);
    grid->addWidget(run_, row++, 0, 1, 2);
    grid->setRowStretch(row, 1);
}

void ModelSummaryPanel::makeRunButton() {
    run_ = new QPushButton(costs_);
    run_->setAccessibleName(tr("Run the scene"));
    run_->setEnabled(false);
    const auto name = [this] {
        const QString keys = commands_.has("run.start") ? keysOf(*commands_.action("run.start")) : QString();
        run_->setText(keys.isEmpty() ? tr("Run") : tr("Run  %1").arg(keys));
    };
    name();
    connect(&commands_, &Commands::keysChanged, run_, name);
    const auto icon = [this] { run_->setIcon(themes_.icon("play", themes_.current().ok)); };
    icon();
    connect(&themes_, &Themes::changed, run_, icon);
    connect(run_, &QPushButton::clicked, this, [this] {
        if (commands_.has("run.start")) commands_.action("run.start")->trigger();
    });
}

void ModelSummaryPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    chooseCosts();  // fonts are known from here on
    if (!summary_) askLater();
}

void ModelSummaryPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    chooseCosts();
    const bool narrow = width() - costWidth < roomForReasons;
    if (narrow == narrow_) return;
    narrow_ = narrow;
    if (summary_) present();
}

/// Chooses whether the costs are placed one below the other or share lines. The height that the former needs depends on
/// fonts, so it is measured while they are placed in this way.
void ModelSummaryPanel::chooseCosts() {
    if (!low_) {
        for (QWidget* part : std::initializer_list<QWidget*>{timeName_, time_, range_, memoryName_, memory_, run_})
            part->ensurePolished();
        costs_->layout()->invalidate();
        heightOfCosts_ = std::max(roomForRange, costs_->layout()->sizeHint().height());
    }
    const bool low = height() < heightOfCosts_;
    if (std::exchange(low_, low) != low) placeCosts();
}

void ModelSummaryPanel::setBusy(bool busy) {
    busy_ = busy;
    if (!busy) return askLater();
    cancel();
    calm_->stop();
    run_->setEnabled(false);
}

void ModelSummaryPanel::setTrade(MeasuredTrade trade) {
    trade_ = std::make_shared<const MeasuredTrade>(std::move(trade));
    if (*trade_->scene == *document_.committed()) askLater();
}

/// Cancels the count in progress and discards its result.
void ModelSummaryPanel::cancel() {
    if (stop_) *stop_ = true;
    stop_.reset();
}

void ModelSummaryPanel::askLater() {
    cancel();
    summary_.reset();
    if (!busy_) calm_->start();
}

void ModelSummaryPanel::ask() {
    const Checked& checked = document_.checked();
    if (!document_.checkIsCurrent() || document_.isPreviewing() || !isVisible()) return;  // requested again then
    if (hasErrors(checked.problems))
        return tell(tr("Fix the errors under Problems to see the model summary."));
    const Scene& solved = checked.cut ? checked.cut->scene : *checked.scene;
    if (solved.blocks.empty()) return tell(tr("Nothing to model yet: draw an outline or a block."));
    tell(tr("Counting…"));
    stop_ = std::make_shared<std::atomic<bool>>(false);
    const std::filesystem::path file = document_.path().toStdString();
    counting_->ask([this, stop = stop_, scene = checked.scene, cut = checked.cut, file,
                    trade = trade_]() -> Background::Result {
        auto summary = modelSummaryOf(*scene, cut.get(), file, trade.get(), *stop);
        returnFreeMemory();
        return [this, stop, summary] {
            if (*stop) return;
            summary_ = summary;
            summary_ ? present() : tell(tr("The model summary could not be computed. Reduce the size of the model."));
            Q_EMIT taken();
        };
    });
}

void ModelSummaryPanel::tell(const QString& why) {
    delete table_;
    table_ = nullptr;
    state_->setText(why);
    state_->show();
    time_->setText(QString::fromUtf8("–"));
    memory_->setText(QString::fromUtf8("–"));
    range_->clear();
    run_->setEnabled(false);
}

void ModelSummaryPanel::addRow(int row, const QStringList& texts, const char* role, bool bold) {
    for (int i = 0; i < 3; ++i) {
        auto* cell = labelOf(table_, role, texts[i]);
        QFont font = cell->font();
        font.setWeight(bold ? QFont::DemiBold : QFont::Normal);
        cell->setFont(font);
        cell->setAlignment((i == 1 || i == 2 ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
        cell->setToolTip(asTip(texts.value(3)));
        grid_->addWidget(cell, row, i);
    }
    if (!narrow_) addWhy(row, texts.value(3));
}

void ModelSummaryPanel::addWhy(int row, const QString& why) {
    auto* cell = labelOf(table_, "detail", why);
    cell->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    cell->setWordWrap(true);
    cell->setToolTip(asTip(why));
    grid_->addWidget(cell, row, 3);
}

void ModelSummaryPanel::present() {
    delete table_;
    table_ = new QWidget(page_);
    grid_ = new QGridLayout(table_);
    grid_->setContentsMargins(0, 0, 0, 0);
    grid_->setHorizontalSpacing(16);
    grid_->setVerticalSpacing(7);
    grid_->setColumnStretch(3, 1);
    grid_->setColumnMinimumWidth(0, 80);
    state_->hide();
    int row = 0;
    addRow(row++, {tr("Modelled"), tr("Count"), tr("Unknowns"), tr("Remarks")}, "detail", false);
    bool hasHeading = false, hasNext = false;
    for (const ModelSummaryRow& part : modelSummaryRows(*summary_)) {
        if (part.leftOut && !std::exchange(hasHeading, true))
            addRow(row++, {tr("Not modelled"), {}, {}, {}}, "detail", false);
        if (part.next && !std::exchange(hasNext, true))
            addRow(row++, {tr("Could be left out next"), {}, {}, {}}, "detail", false);
        if (part.leftOut || part.next) {
            const bool inOne = narrow_ && part.next;  // what a setting costs and saves is the reason to read on
            auto* what = labelOf(table_, "cell", inOne ? tr("%1: %2").arg(part.what, part.why) : part.what);
            what->setWordWrap(true);
            what->setToolTip(asTip(part.why));
            grid_->addWidget(what, row, 0, 1, 3);
            if (!narrow_) addWhy(row, part.why);
            ++row;
        } else {
            addRow(row++, {part.what, part.count, part.unknowns, part.why}, "cell", part.total);
        }
    }
    static_cast<QVBoxLayout*>(page_->layout())->insertWidget(0, table_);
    const CostEstimate& estimate = summary_->estimate;
    const bool runs = !estimate.stages.empty();
    time_->setText(runs ? costText(estimate.seconds) : QString::fromUtf8("–"));
    range_->setText(runs && estimate.secondsMost >= 1.0
                        ? tr("%1 to %2").arg(costText(estimate.secondsLeast), costText(estimate.secondsMost))
                        : QString());
    memory_->setText(runs ? memoryText(estimate.memory) : QString::fromUtf8("–"));
    const QString details = runs ? range_->text() + '\n' + estimateDetails(estimate) : QString();
    for (QLabel* label : {time_, range_, memory_}) label->setToolTip(asTip(details));
    run_->setEnabled(runs && commands_.has("run.start"));
    chooseCosts();
}

}  // namespace keyblock
