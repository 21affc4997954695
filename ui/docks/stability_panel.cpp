// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/stability_panel.h"

#include "solver/results/result_names.h"
#include "ui/look/display.h"
#include "ui/look/plain_text.h"
#include "ui/look/qt_text.h"
#include "ui/look/theme.h"
#include "ui/picture/captions.h"
#include "ui/runs/bolt_choice.h"
#include "ui/runs/live_run.h"
#include "ui/runs/time_cursor.h"

#include <QHeaderView>
#include <QLabel>
#include <QScrollArea>
#include <QScrollBar>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>
#include <cmath>
#include <exception>

namespace keyblock {

namespace {

enum BlockColumn { BlockName, How, Moved, Weight, StageOf };
enum BoltColumn { BoltName, State, Governs, Holds, AxialPeak, ShearPeak, MomentPeak, SteelUse, ShearUse, BondUse, PlateUse, EnergyTaken };

constexpr double nothing = 1e-9;  // relative to the axial force; smaller values are round-off
constexpr int betweenUpdates = 500;  // ms, while a run grows: filling tables takes the window's time
constexpr int mostInACell = 3;  // blocks listed in a cell

QTreeWidget* table(const char* name, const QString& says, const QStringList& heads, int firstNumber, int lastNumber,
                   QWidget* parent) {
    auto* tree = new QTreeWidget(parent);
    tree->setObjectName(name);
    tree->setAccessibleName(says);
    tree->setRootIsDecorated(false);
    tree->setUniformRowHeights(true);
    tree->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Ignored);  // as high as there is room, see fitRows()
    tree->setHeaderLabels(heads);
    tree->header()->setStretchLastSection(true);
    for (int c = firstNumber; c <= lastNumber; ++c) tree->headerItem()->setTextAlignment(c, Qt::AlignRight | Qt::AlignVCenter);
    return tree;
}

QTreeWidgetItem* addRow(QTreeWidget* tree, const QStringList& cells, int key) {
    auto* item = new QTreeWidgetItem(tree, cells);
    item->setData(0, Qt::UserRole, key);
    for (int c = 0; c < tree->columnCount(); ++c)
        item->setTextAlignment(c, Qt::AlignVCenter | tree->headerItem()->textAlignment(c));
    return item;
}

void fitColumns(QTreeWidget* tree) {
    for (int c = 0; c + 1 < tree->columnCount(); ++c) tree->resizeColumnToContents(c);
}

/// Height of a table with its header and this number of rows [px].
int heightWith(const QTreeWidget* tree, int rows) { return tree->header()->sizeHint().height() + 26 * rows + 4; }

int barHeight(const QTreeWidget* tree) { return tree->horizontalScrollBar()->sizeHint().height(); }

/// Gives the table the height of its rows, at most three, and of its scroll bar if columns are out of sight; it takes
/// more only if no other table needs the space below.
void fitRows(QTreeWidget* tree, bool leavesRoom) {
    const bool needsBar = tree->header()->length() > tree->viewport()->width();
    const int height = heightWith(tree, std::min(3, tree->topLevelItemCount())) + (needsBar ? barHeight(tree) : 0);
    tree->setMinimumHeight(height);
    tree->setMaximumHeight(leavesRoom ? height : QWIDGETSIZE_MAX);
}

QString utilisationText(const std::optional<double>& use) {
    if (!use) return QStringLiteral("–");
    const double shown = 100.0 * *use;
    return Display::number(shown, shown < 10.0 ? 2 : 3);
}

/// State of every bolt at the last frame.
std::vector<BoltEnd> endsOf(const RunSource& run) {
    std::vector<BoltEnd> ends;
    if (run.frames().empty()) return ends;
    const Frame last = run.frame(run.frames().size() - 1);
    const std::vector<Event> events = run.events();
    for (std::size_t bolt = 0; bolt < last.bolts.size(); ++bolt) {
        const BoltFrame& state = last.bolts[bolt];
        ends.push_back({boltReport(run.scene(), last, static_cast<int>(bolt), events).condition, state.elasticEnergy,
                        state.plasticEnergy, state.bondEnergy});
    }
    return ends;
}

}  // namespace

StabilityPanel::StabilityPanel(const Themes& themes, const Display& display, TimeCursor& cursor, BoltChoice& choice,
                               QWidget* parent)
    : QWidget(parent), themes_(themes), display_(display), cursor_(cursor), answer_(new QLabel(this)), worst_(new QLabel(this)),
      blocks_(table("unstableBlocks", tr("Unstable blocks"),
                    {tr("Block"), tr("Mode"), tr("Displacement"), tr("Weight"), tr("Stage")}, Moved, Weight, this)),
      bolts_(table("boltUses", tr("Largest forces and utilisation of each bolt"),
                   {tr("Bolt"), tr("State"), tr("Governed by"), tr("Supports"), tr("N"), tr("Q"), tr("M"), tr("Steel, %"), tr("Shear, %"),
                    tr("Bond, %"), tr("Plate, %"), tr("Energy")},
                   AxialPeak, EnergyTaken, this)) {
    bolts_->headerItem()->setToolTip(SteelUse, tr("Percentage of the ultimate strength"));
    bolts_->headerItem()->setToolTip(EnergyTaken, tr("Energy absorbed by the bolt during the run"));
    setObjectName("stabilityPanel");
    setAttribute(Qt::WA_StyledBackground);
    setAccessibleName(tr("Stability"));
    answer_->setObjectName("stabilityAnswer");
    answer_->setContentsMargins(12, 4, 12, 0);
    worst_->setContentsMargins(12, 0, 12, 4);
    for (QLabel* label : {answer_, worst_}) {
        label->setWordWrap(true);
        label->setTextFormat(Qt::PlainText);
    }
    // In a low window the panel scrolls, so that each table keeps at least a row in sight.
    auto* content = new QWidget;
    content->setObjectName("stabilityContent");
    content->setAttribute(Qt::WA_StyledBackground);
    auto* scroll = new QScrollArea(this);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidget(content);
    auto* all = new QVBoxLayout(this);
    all->setContentsMargins(0, 0, 0, 0);
    all->addWidget(scroll);
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(answer_);
    column->addWidget(worst_);
    column->addWidget(blocks_, 3);  // gets the height of its rows first
    column->addWidget(bolts_, 1);
    bolts_->setMinimumHeight(heightWith(bolts_, 1) + barHeight(bolts_));
    column->addStretch(0);
    growth_.setSingleShot(true);
    growth_.setInterval(betweenUpdates);
    connect(&growth_, &QTimer::timeout, this, &StabilityPanel::takeGrowth);
    connect(&cursor, &TimeCursor::runChanged, this, &StabilityPanel::takeRun);
    connect(&cursor, &TimeCursor::runGrew, this, [this] {
        if (run_ && isFinished(*run_)) takeGrowth();
        else if (!growth_.isActive()) growth_.start();
    });
    connect(&themes, &Themes::changed, this, &StabilityPanel::fill);
    connect(&display, &Display::changed, this, &StabilityPanel::fill);
    connect(blocks_, &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem* item) {
        Q_EMIT blockAsked(item->data(0, Qt::UserRole).toInt(), item->text(How));
    });
    connect(bolts_, &QTreeWidget::itemClicked, this,
            [&choice](QTreeWidgetItem* item) { choice.choose(item->data(0, Qt::UserRole).toInt()); });
    takeRun();
}

void StabilityPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    takeRun();
}

void StabilityPanel::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fitRows(blocks_, !uses_.empty());
}

void StabilityPanel::takeRun() {
    if (run_ != cursor_.run()) {
        run_ = cursor_.run();
        read_ = 0;
        uses_.clear();
    }
    if (!isVisible()) return;
    readBolts();
    fill();
}

void StabilityPanel::takeGrowth() {
    if (!isVisible()) return;
    readBolts();
    fillVerdict();
}

/// Extremes are read on another thread, because reading them would block the window for too long.
void StabilityPanel::readBolts() {
    if (!run_ || run_->frames().size() == read_ || run_->scene().bolts.empty()) return;
    read_ = run_->frames().size();
    reader_.ask([this, run = run_, soFar = std::make_shared<const RunSoFar>(run_)]() -> Background::Result {
        std::vector<BoltUse> uses;
        std::vector<BoltEnd> ends;
        try {
            uses = boltUses(*soFar);
            ends = endsOf(*soFar);
        } catch (const std::exception&) {
            return {};  // the run's files were deleted, which is reported elsewhere
        }
        std::stable_sort(uses.begin(), uses.end(),
                         [](const BoltUse& a, const BoltUse& b) { return a.highest() > b.highest(); });
        return [this, run, uses = std::move(uses), ends = std::move(ends)] {
            if (run != run_ || ends.size() < uses.size()) return;
            uses_ = uses;
            ends_ = ends;
            fillBolts();
        };
    });
}

void StabilityPanel::fill() {
    fillVerdict();
    fillBolts();
}

void StabilityPanel::fillVerdict() {
    const Verdict verdict = run_ ? verdictOf(run_->stageList(), run_->scene()) : Verdict{};
    const bool over = run_ && isFinished(*run_);
    QString answer = tr("Run the scene to see whether it is stable.");
    QColor colour = themes_.current().text2;
    if (run_ && verdict.stands) {
        answer = *verdict.stands ? tr("Stable: yes") : tr("Stable: no");
        colour = *verdict.stands ? themes_.current().ok : themes_.current().error;
    } else if (run_) {
        answer = over ? tr("Stability: undecided") : tr("Stability: not known yet");
    }
    answer_->setText(answer);
    const QString look = QStringLiteral("color: %1; font-weight: 600;").arg(colour.name());
    if (answer_->styleSheet() != look) answer_->setStyleSheet(look);
    const auto worst = run_ ? worstBalanced(run_->stageList()) : std::nullopt;
    if (worst)
        worst_->setText(tr("Largest unbalanced force: block %1, %2 % of its weight")
                            .arg(QString::fromStdString(blockName(run_->blockNames(), worst->health.worst.block)),
                                 Display::number(100.0 * worst->health.worst.share, 2)));
    worst_->setVisible(worst.has_value());
    fillBlocks(verdict);
}

void StabilityPanel::fillBlocks(const Verdict& verdict) {
    blocks_->clear();
    const ShownUnit force = display_.shown("N"), length = display_.shown("m");
    for (const StageUnstable& one : verdict.blocks)
        addRow(blocks_,
               {QString::fromStdString(blockName(run_->blockNames(), one.block.block)), qt(wordOf(one.block.mode)),
                Display::number(length.factor * one.block.moved, 3) + ' ' + length.symbol,
                Display::number(force.factor * one.block.weight, 3) + ' ' + force.symbol,
                QString::fromStdString(stageName(run_->scene(), one.stage))},
               one.block.block);
    blocks_->setVisible(blocks_->topLevelItemCount() > 0);
    fitColumns(blocks_);
}

void StabilityPanel::fillBolts() {
    bolts_->clear();
    for (const BoltUse& use : uses_) {
        const BoltExtremes& peaks = use.extremes;
        const double axial = peaks.axialForce.value;
        const BoltEnd& end = ends_[use.bolt];
        const auto share = [&](BoltStrength strength) {
            return utilisationText(use.use[static_cast<std::size_t>(strength)]);
        };
        QTreeWidgetItem* row = addRow(
            bolts_,
            {QString::fromStdString(boltName(run_->scene(), use.bolt)), qt(wordOf(end.condition)),
             use.governs ? tr("%1 %2 %").arg(qt(rowOf(*use.governs).key), utilisationText(use.highest()))
                         : QStringLiteral("–"),
             namesOf(use.holds), peakText(peaks.axialForce, "N", axial), peakText(peaks.shearForce, "N", axial),
             peakText(peaks.moment, "N m", axial), share(BoltStrength::Steel), share(BoltStrength::Shear),
             share(BoltStrength::Bond), share(BoltStrength::Plate), energyText(end.elastic + end.plastic + end.bond)},
            use.bolt);
        row->setToolTip(EnergyTaken, tr("elastic %1, plastic %2, bond %3")
                                         .arg(energyText(end.elastic), energyText(end.plastic), energyText(end.bond)));
        row->setToolTip(AxialPeak, asTip(whenText(peaks.axialForce)));
        row->setToolTip(ShearPeak, asTip(whenText(peaks.shearForce)));
        row->setToolTip(MomentPeak, asTip(whenText(peaks.moment)));
    }
    bolts_->setVisible(!uses_.empty());
    fitColumns(bolts_);
    fitRows(blocks_, !uses_.empty());
}

/// The peak as text, for example "62.1 kN at 1.25 m", measured from the far end.
QString StabilityPanel::peakText(const BoltPeak& peak, const char* unit, double axial) const {
    if (peak.stage < 0) return QStringLiteral("–");
    if (std::abs(peak.value) < nothing * std::abs(axial)) return QStringLiteral("0");
    const ShownUnit shown = display_.shown(unit);
    return tr("%1 %2 at %3 m").arg(Display::number(shown.factor * peak.value, 3), shown.symbol, Display::number(peak.at, 3));
}

QString StabilityPanel::energyText(double joules) const {
    const ShownUnit shown = display_.shown("J");
    return Display::number(shown.factor * joules, 3) + ' ' + shown.symbol;
}

QString StabilityPanel::whenText(const BoltPeak& peak) const {
    if (peak.stage < 0) return {};
    const QString stage = qt(stageTitle(run_->scene(), peak.stage));
    const QString time = qt(timeText(run_->scene(), peak.stage, peak.time));
    return asTip(tr("Reached in %1 at t = %2; position measured from the far end").arg(stage, time));
}

QString StabilityPanel::namesOf(const std::vector<int>& blocks) const {
    QStringList names;
    for (const int block : blocks) {
        if (names.size() == mostInACell) return tr("%1 and %2 more").arg(names.join(", ")).arg(blocks.size() - mostInACell);
        names += QString::fromStdString(blockName(run_->blockNames(), block));
    }
    return names.isEmpty() ? tr("nothing") : names.join(", ");
}

}  // namespace keyblock
