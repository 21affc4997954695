// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/problems/problems_panel.h"

#include "ui/document/document.h"
#include "ui/document/selection.h"
#include "ui/edit/edits.h"
#include "ui/edit/locate.h"
#include "ui/look/display.h"
#include "ui/look/plain_text.h"
#include "ui/look/theme.h"

#include <QKeyEvent>
#include <QLabel>
#include <QListView>
#include <QMouseEvent>
#include <QPainter>
#include <QTimer>
#include <QVBoxLayout>

namespace keyblock {

namespace {

constexpr int problemHeight = 42, noteHeight = 36, problemInset = 12, problemIcon = 16, textLeft = 37, problemStep = 20;

QFont problemFont(const QFont& base, int pixels, QFont::Weight weight) {
    QFont font = base;
    font.setPixelSize(pixels);
    font.setWeight(weight);
    return font;
}

const ProblemRow& problemAt(const QModelIndex& index) {
    return static_cast<const ProblemList*>(index.model())->rowAt(index.row());
}

QIcon signOf(const ProblemRow& row, const Themes& themes) {
    const Theme& t = themes.current();
    switch (row.sign) {
        case ProblemRow::Sign::Error: return themes.icon("error", t.error);
        case ProblemRow::Sign::Warning: return themes.icon("warning", t.warningFill);
        default: return themes.icon(row.depth > 0 ? "minus" : "help", t.text2);
    }
}

}  // namespace

void ProblemList::show(std::vector<ProblemRow> rows) {
    beginResetModel();
    rows_ = std::move(rows);
    endResetModel();
}

int ProblemList::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(rows_.size());
}

QVariant ProblemList::data(const QModelIndex& index, int role) const {
    const ProblemRow& row = rowAt(index.row());
    if (role == Qt::DisplayRole || role == Qt::AccessibleTextRole) return row.title;
    if (role == Qt::AccessibleDescriptionRole) return row.detail;
    if (role == Qt::ToolTipRole) return asTip(row.detail.isEmpty() ? row.title : row.title + "\n" + row.detail);
    return {};
}

QSize ProblemRowPaint::sizeHint(const QStyleOptionViewItem&, const QModelIndex& index) const {
    return {320, problemAt(index).depth > 0 ? noteHeight : problemHeight};
}

QRect ProblemRowPaint::linkOf(const QRect& row, const QString& link, const QFont& font) {
    // Slightly wider than necessary, because eliding works with rounded widths.
    const int width = QFontMetrics(problemFont(font, 12, QFont::DemiBold)).horizontalAdvance(link) + 4;
    return {row.right() - problemInset - width, row.top(), width, row.height()};
}

void ProblemRowPaint::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
    const ProblemRow& row = problemAt(index);
    const Theme& t = themes_.current();
    const QRect& box = option.rect;
    painter->save();
    painter->setClipRect(box);
    const bool chosen = option.state & QStyle::State_Selected;
    if (chosen || option.state & QStyle::State_MouseOver) painter->fillRect(box, chosen ? t.accentRow : t.header);
    painter->setPen(t.separator);
    painter->drawLine(box.bottomLeft(), box.bottomRight());
    const int left = box.left() + row.depth * problemStep;
    const QRect sign(left + problemInset, box.center().y() - problemIcon / 2, problemIcon, problemIcon);
    signOf(row, themes_).paint(painter, sign);
    const QRect link = linkOf(box, row.link, option.font);
    const bool narrow = box.width() < 560;
    const int whereLeft = box.left() + box.width() * 52 / 100;
    const int textEnd = (narrow ? link.left() : whereLeft) - 12;
    const QRect upper(left + textLeft, box.top() + 5, textEnd - left - textLeft, 16);
    const auto line =
        [&](const QRect& place, const QString& text, int pixels, QFont::Weight weight, const QColor& ink) {
        painter->setFont(problemFont(option.font, pixels, weight));
        painter->setPen(ink);
        painter->drawText(place, Qt::AlignVCenter,
                          QFontMetrics(painter->font()).elidedText(text, Qt::ElideRight, place.width()));
    };
    const int lower = box.height() == problemHeight ? 17 : 15;
    line(upper, row.title, 12, row.depth > 0 ? QFont::Normal : QFont::DemiBold, t.text);
    line(upper.translated(0, lower), row.detail, 11, QFont::Normal, t.text2);
    if (!narrow)
        line(QRect(whereLeft, box.top(), link.left() - 12 - whereLeft, box.height()), row.where, 11, QFont::Normal,
             t.text2);
    line(link, row.link, 12, QFont::DemiBold, t.accent);
    painter->restore();
}

ProblemsPanel::ProblemsPanel(Document& document, Selection& selection, const Display& display, const Themes& themes,
                             QWidget* parent)
    : QWidget(parent), document_(document), selection_(selection), display_(display), themes_(themes),
      list_(new ProblemList(this)), view_(new QListView(this)), later_(new QTimer(this)) {
    setObjectName("problemsPanel");
    setAttribute(Qt::WA_StyledBackground);
    view_->setModel(list_);
    view_->setItemDelegate(new ProblemRowPaint(themes, this));
    view_->setObjectName("problemList");
    view_->setAccessibleName(tr("Problems"));
    view_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    view_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
    view_->setResizeMode(QListView::Adjust);
    view_->setMouseTracking(true);
    view_->viewport()->installEventFilter(this);
    view_->installEventFilter(this);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->addWidget(view_);
    none_ = new QLabel(tr("No problems. The scene is checked after every edit."), this);
    none_->setProperty("role", "detail");
    none_->setContentsMargins(problemInset, 12, problemInset, 0);
    none_->setAlignment(Qt::AlignTop);
    column->addWidget(none_, 1);
    later_->setSingleShot(true);
    later_->setInterval(0);
    const auto schedule = [this] { later_->start(); };
    connect(later_, &QTimer::timeout, this, &ProblemsPanel::refresh);
    connect(&document, &Document::checkedChanged, this, schedule);
    connect(&document, &Document::replaced, this, [this] { reportIsOpen_ = false; });
    connect(&display, &Display::changed, this, schedule);
    connect(&themes, &Themes::changed, view_->viewport(), QOverload<>::of(&QWidget::update));
    refresh();
}

void ProblemsPanel::refresh() {
    later_->stop();
    const int before = urgent();
    list_->show(problemRows(document_, display_, reportIsOpen_));
    view_->setVisible(!list_->rows().empty());
    none_->setVisible(list_->rows().empty());
    if (urgent() != before) Q_EMIT countChanged(urgent());
}

void ProblemsPanel::follow(int row) {
    const ProblemRow chosen = list_->rowAt(row);
    if (chosen.opensReport) {
        reportIsOpen_ = !reportIsOpen_;
        return refresh();
    }
    if (!chosen.remedy) return showRow(row);
    // Messages of an outdated check may refer to other objects by now.
    if (document_.checkIsCurrent()) document_.apply(chosen.remedy->text, chosen.remedy->edit(*document_.scene()));
}

void ProblemsPanel::showRow(int row) {
    const ProblemRow chosen = list_->rowAt(row);
    const std::string object = objectPointer(*document_.scene(), chosen.pointer.toStdString());
    if (!object.empty()) {
        selection_.set({QString::fromStdString(object)});
        Q_EMIT fieldAsked(chosen.pointer);
    }
    if (chosen.box) Q_EMIT placeAsked(*chosen.box);
}

bool ProblemsPanel::eventFilter(QObject* object, QEvent* event) {
    if (object == view_->viewport() && event->type() == QEvent::MouseButtonRelease) {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        const QModelIndex index = view_->indexAt(mouse->pos());
        if (!index.isValid() || mouse->button() != Qt::LeftButton) return false;
        const QRect link =
            ProblemRowPaint::linkOf(view_->visualRect(index), list_->rowAt(index.row()).link, view_->font());
        if (link.contains(mouse->pos())) {
            follow(index.row());
            return true;
        }
        showRow(index.row());
    }
    if (object == view_->viewport() && event->type() == QEvent::MouseMove) {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        const QModelIndex index = view_->indexAt(mouse->pos());
        const bool over = index.isValid() &&
                          ProblemRowPaint::linkOf(view_->visualRect(index), list_->rowAt(index.row()).link,
                                                  view_->font())
                              .contains(mouse->pos());
        view_->viewport()->setCursor(over ? Qt::PointingHandCursor : Qt::ArrowCursor);
    }
    if (object == view_ && event->type() == QEvent::KeyPress && view_->currentIndex().isValid()) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Return || key == Qt::Key_Enter) {
            follow(view_->currentIndex().row());
            return true;
        }
    }
    return QWidget::eventFilter(object, event);
}

}  // namespace keyblock
