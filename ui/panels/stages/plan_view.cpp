// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/stages/plan_view.h"

#include "ui/look/theme.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

namespace keyblock {

namespace {

constexpr int lineHeight = 24, cellWidth = 92, barHeight = 12;

QString eventWord(const PlanCell& cell) {
    switch (cell.event) {
        case PlanCell::Event::Excavated: return PlanModel::tr("excavated");
        case PlanCell::Event::Installed: return PlanModel::tr("installed");
        case PlanCell::Event::Removed: return PlanModel::tr("removed");
        case PlanCell::Event::None: break;
    }
    return {};
}

}  // namespace

void PlanModel::show(std::vector<PlanRow> rows, QStringList stages) {
    const bool same = rows.size() == rows_.size() && stages.size() == stages_.size();
    if (!same) beginResetModel();
    rows_ = std::move(rows);
    stages_ = std::move(stages);
    if (!same) return endResetModel();
    if (rows_.empty() || stages_.isEmpty()) return;
    Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
    Q_EMIT headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
    Q_EMIT headerDataChanged(Qt::Vertical, 0, rowCount() - 1);
}

int PlanModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

int PlanModel::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : stages_.size(); }

QVariant PlanModel::data(const QModelIndex& index, int role) const {
    const PlanRow& row = planRow(index.row());
    const PlanCell& cell = row.cells[index.column()];
    const QString there = row.isBolt ? (cell.there ? tr("in place") : tr("not in place"))
                                     : (cell.there ? tr("not excavated") : tr("excavated"));
    const QString word = eventWord(cell).isEmpty() ? there : eventWord(cell);
    if (role == Qt::AccessibleTextRole)
        return QString("%1 %2: %3").arg(QString::fromStdString(row.name), stages_[index.column()], word);
    if (role == Qt::ToolTipRole)
        return tr("%1 in %2: %3. Click to change.")
            .arg(QString::fromStdString(row.name), stages_[index.column()], word);
    return {};
}

QVariant PlanModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (role != Qt::DisplayRole && role != Qt::ToolTipRole) return {};
    if (orientation == Qt::Horizontal) return stages_.value(section);
    return section < rowCount() ? QString::fromStdString(planRow(section).name) : QString();
}

void PlanCells::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const PlanRow& row = static_cast<const PlanModel*>(index.model())->planRow(index.row());
    const std::size_t stage = index.column();
    const PlanCell& cell = row.cells[stage];
    const Theme& t = themes_.current();
    painter->save();
    if (option.state & (QStyle::State_MouseOver | QStyle::State_HasFocus)) painter->fillRect(option.rect, t.header);
    if (option.state & QStyle::State_HasFocus) {
        painter->setPen(QPen(t.accent, 2));
        painter->drawRect(option.rect.adjusted(1, 1, -2, -2));
    }
    const QRect bar(option.rect.left(), option.rect.center().y() - barHeight / 2 + 1, option.rect.width() + 1,
                    barHeight);
    if (cell.there) {
        painter->fillRect(bar, row.isBolt ? t.text3 : t.rock);
        if (!row.isBolt) {
            painter->setPen(t.border);
            painter->drawLine(bar.topLeft(), bar.topRight());
            painter->drawLine(bar.bottomLeft(), bar.bottomRight());
        }
    }
    const QString word = eventWord(cell);
    if (!word.isEmpty()) {
        QFont font = option.font;
        font.setPixelSize(11);
        font.setWeight(QFont::DemiBold);
        painter->setFont(font);
        const int width = QFontMetrics(font).horizontalAdvance(word) + 14;
        const QRect tag(option.rect.left() + 3, option.rect.top() + 3, std::min(width, option.rect.width() - 6),
                        option.rect.height() - 6);
        painter->setRenderHint(QPainter::Antialiasing);
        painter->setPen(t.border);
        painter->setBrush(t.panel);
        painter->drawRoundedRect(QRectF(tag).adjusted(0.5, 0.5, -0.5, -0.5), 3, 3);
        painter->setPen(cell.event == PlanCell::Event::Removed ? t.error : t.text);
        painter->drawText(tag, Qt::AlignCenter, word);
    }
    painter->restore();
}

PlanView::PlanView(const Themes& themes, QWidget* parent) : QTableView(parent), plan_(new PlanModel(this)) {
    setObjectName("stagePlan");
    setAccessibleName(tr("Excavation and support by stage"));
    setModel(plan_);
    setItemDelegate(new PlanCells(themes, this));
    setShowGrid(false);
    setMouseTracking(true);
    setSelectionMode(SingleSelection);
    horizontalHeader()->setDefaultSectionSize(cellWidth);
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    verticalHeader()->setDefaultSectionSize(lineHeight);
    verticalHeader()->setMinimumSectionSize(lineHeight);
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    verticalHeader()->setHighlightSections(false);
    verticalHeader()->setFixedWidth(120);
    connect(&themes, &Themes::changed, viewport(), QOverload<>::of(&QWidget::update));
}

void PlanView::mouseReleaseEvent(QMouseEvent* event) {
    QTableView::mouseReleaseEvent(event);
    const QModelIndex index = indexAt(event->pos());
    if (event->button() == Qt::LeftButton && index.isValid()) Q_EMIT cellChosen(index.row(), index.column());
}

void PlanView::keyPressEvent(QKeyEvent* event) {
    const bool enters = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter ||
                        event->key() == Qt::Key_Space;
    if (enters && currentIndex().isValid()) return Q_EMIT cellChosen(currentIndex().row(), currentIndex().column());
    QTableView::keyPressEvent(event);
}

}  // namespace keyblock
