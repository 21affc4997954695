// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/command_palette.h"

#include "ui/help/command_match.h"
#include "ui/look/commands.h"
#include "ui/look/theme.h"

#include <QAction>
#include <QApplication>
#include <QCursor>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QSettings>
#include <QStyledItemDelegate>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <vector>

namespace keyblock {

namespace {

constexpr int widest = 560, rowHeight = 30, mostRows = 12, mostRecent = 20, top = 72;  // [px]
constexpr char recentKey[] = "palette/recent";

QString nameOf(const QAction* action) { return action->text().remove(QStringLiteral("…")).remove('&'); }

/// Paints the icon, name, menu and keys of a command in one row.
class Row : public QStyledItemDelegate {
public:
    Row(const Commands& commands, const Themes& themes, QObject* parent)
        : QStyledItemDelegate(parent), commands_(commands), themes_(themes) {}

    QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override { return {widest - 20, rowHeight}; }

    void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
        const Theme& t = themes_.current();
        const QAction* action = commands_.action(index.data(Qt::UserRole).toString());
        const bool isChosen = option.state & QStyle::State_Selected;
        if (isChosen) painter->fillRect(option.rect, t.accentRow);
        if (isChosen) painter->fillRect(QRect(option.rect.topLeft(), QSize(2, rowHeight)), t.accent);
        const QRect inner = option.rect.adjusted(36, 0, -12, 0);
        action->icon().paint(painter, QRect(option.rect.left() + 12, option.rect.top() + 7, 16, 16));
        const int keys = side(*painter, inner, keysOf(*action), t.text2);
        painter->setPen(action->isEnabled() ? t.text : t.text3);
        const QRect room = inner.adjusted(0, 0, -keys - 12, 0);
        const QString name = painter->fontMetrics().elidedText(nameOf(action), Qt::ElideRight, room.width());
        painter->drawText(room, Qt::AlignVCenter | Qt::AlignLeft, name);
        const int used = painter->fontMetrics().horizontalAdvance(name) + 10;
        painter->setPen(t.text3);
        const QRect rest = room.adjusted(used, 0, 0, 0);
        const QString why = commands_.whyNot(action);
        const QString more = action->isEnabled() ? commands_.menuOf(action) : why.isEmpty() ? CommandPalette::tr("unavailable") : why;
        if (rest.width() > 40)
            painter->drawText(rest, Qt::AlignVCenter | Qt::AlignLeft,
                              painter->fontMetrics().elidedText(more, Qt::ElideRight, rest.width()));
    }

private:
    static int side(QPainter& painter, const QRect& room, const QString& keys, const QColor& colour) {
        painter.setPen(colour);
        painter.drawText(room, Qt::AlignVCenter | Qt::AlignRight, keys);
        return painter.fontMetrics().horizontalAdvance(keys);
    }

    const Commands& commands_;
    const Themes& themes_;
};

}  // namespace

QList<QAction*> commandsFor(const QString& typed, const Commands& commands, const QStringList& recent) {
    struct Fit {
        QAction* action;
        int match, age;
    };
    std::vector<Fit> fits;
    for (QAction* action : commands.all()) {
        const int byName = matchOf(typed, nameOf(action));
        const int byHelp = typed.size() > 2 && action->statusTip().contains(typed, Qt::CaseInsensitive) ? 5 : -1;
        const int match = std::max(byName, byHelp);
        const int age = recent.indexOf(action->objectName());
        if (match >= 0 && action->isVisible()) fits.push_back({action, match, age < 0 ? mostRecent : age});
    }
    std::ranges::stable_sort(fits, [](const Fit& a, const Fit& b) {
        if (a.match != b.match) return a.match > b.match;
        if (a.action->isEnabled() != b.action->isEnabled()) return a.action->isEnabled();
        return a.age < b.age;
    });
    QList<QAction*> found;
    for (const Fit& fit : fits) found << fit.action;
    return found;
}

CommandPalette::CommandPalette(const Commands& commands, const Themes& themes, QWidget* window)
    : QFrame(window), commands_(commands), themes_(themes), typed_(new QLineEdit(this)), found_(new QListWidget(this)),
      none_(new QLabel(this)),      recent_(QSettings().value(recentKey).toStringList()) {
    setObjectName("palette");
    typed_->setObjectName("palette.typed");
    typed_->setAccessibleName(tr("Search commands"));
    typed_->setPlaceholderText(tr("Type the name of a command"));
    typed_->addAction(themes.icon("search"), QLineEdit::LeadingPosition);
    found_->setObjectName("palette.found");
    found_->setAccessibleName(tr("Commands found"));
    found_->setItemDelegate(new Row(commands, themes, this));
    found_->setFocusPolicy(Qt::NoFocus);
    found_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    found_->setMouseTracking(true);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 8, 8, 8);
    column->setSpacing(6);
    column->addWidget(typed_);
    column->addWidget(found_);
    none_->setObjectName("palette.none");
    none_->setProperty("role", "detail");
    none_->setContentsMargins(12, 6, 12, 8);
    none_->setWordWrap(true);
    none_->setTextFormat(Qt::PlainText);
    column->addWidget(none_);
    typed_->installEventFilter(this);
    connect(typed_, &QLineEdit::textChanged, this, &CommandPalette::list);
    // Deferred: scrolling to the current item emits the same signal and must not change the choice meanwhile.
    connect(found_, &QListWidget::itemEntered, this, [this] { QTimer::singleShot(0, this, &CommandPalette::chooseUnderMouse); });
    connect(found_, &QListWidget::itemClicked, this, &CommandPalette::run);
    hide();
}

void CommandPalette::open() {
    if (!isVisible()) before_ = QApplication::focusWidget();
    mouse_ = QCursor::pos();
    typed_->clear();
    list();
    raise();
    show();
    typed_->setFocus();
}

/// Gives the focus back; otherwise Qt gives it to the search box, where Space opens the palette again instead of playing
/// the frames.
void CommandPalette::leave() {
    if (before_ && before_->isVisible()) before_->setFocus();
    else typed_->clearFocus();
    hide();
}

void CommandPalette::list() {
    found_->clear();
    for (QAction* action : commandsFor(typed_->text(), commands_, recent_)) {
        auto* item = new QListWidgetItem(nameOf(action), found_);
        item->setData(Qt::UserRole, action->objectName());
        item->setToolTip(action->statusTip());
    }
    found_->setCurrentRow(0);
    const bool isEmpty = found_->count() == 0;
    none_->setText(tr("No command matches “%1”. Try another word.").arg(typed_->text()));
    found_->setVisible(!isEmpty);
    none_->setVisible(isEmpty);
    place();
}

void CommandPalette::place() {
    const int rows = std::clamp(found_->count(), 1, mostRows);
    const int room = parentWidget()->width() - 16;
    found_->setFixedHeight(rows * rowHeight + 2);
    layout()->activate();
    resize(std::min(widest, room), layout()->sizeHint().height());
    move((parentWidget()->width() - this->width()) / 2, top);
}

/// Selects the row under the mouse, but only if the mouse has moved and not the list under it.
void CommandPalette::chooseUnderMouse() {
    const QPoint mouse = QCursor::pos();
    if (mouse == mouse_) return;
    mouse_ = mouse;
    if (QListWidgetItem* item = found_->itemAt(found_->viewport()->mapFromGlobal(mouse))) found_->setCurrentItem(item);
}

/// The command runs after the palette has closed, so that the focus is restored first.
void CommandPalette::run() {
    const QListWidgetItem* item = found_->currentItem();
    if (!item) return;
    QAction* action = commands_.action(item->data(Qt::UserRole).toString());
    if (!action->isEnabled()) return;
    recent_.removeAll(action->objectName());
    recent_.prepend(action->objectName());
    while (recent_.size() > mostRecent) recent_.removeLast();
    QSettings().setValue(recentKey, recent_);
    leave();
    QTimer::singleShot(0, action, &QAction::trigger);
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::FocusOut && !underMouse()) hide();
    if (event->type() != QEvent::KeyPress) return QFrame::eventFilter(watched, event);
    const int rows = found_->count(), row = found_->currentRow();
    switch (static_cast<QKeyEvent*>(event)->key()) {
        case Qt::Key_Escape: leave(); return true;
        case Qt::Key_Return:
        case Qt::Key_Enter: run(); return true;
        case Qt::Key_Down: found_->setCurrentRow(std::min(row + 1, rows - 1)); return true;
        case Qt::Key_Up: found_->setCurrentRow(std::max(row - 1, 0)); return true;
        default: return false;
    }
}

}  // namespace keyblock
