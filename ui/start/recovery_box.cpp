// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/start/recovery_box.h"

#include "ui/look/plain_text.h"
#include "ui/look/theme.h"
#include "ui/start/start_buttons.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVariant>

namespace keyblock {

namespace {

QPushButton* link(const char* id, const QString& text, const QString& tip, QWidget* parent) {
    auto* button = new QPushButton(text, parent);
    button->setProperty("link", true);
    button->setCursor(Qt::PointingHandCursor);
    button->setToolTip(tip);
    button->setAccessibleName(text);
    button->setObjectName(QStringLiteral("recovery.") + id);
    return button;
}

}  // namespace

RecoveryBox::RecoveryBox(const Abandoned& abandoned, const Themes& themes, QWidget* parent)
    : QFrame(parent), abandoned_(abandoned) {
    setObjectName("recoveryBox");
    auto* icon = new QLabel(this);
    icon->setPixmap(themes.icon("warning", themes.current().warningFill).pixmap(16, 16));
    auto* title = new QLabel(tr("%1 was not closed properly.").arg(abandoned.title), this);
    title->setObjectName("recoveryTitle");
    title->setToolTip(asTip(abandoned.path));
    title->setTextFormat(Qt::PlainText);
    const QString edits = abandoned.changes == 1 ? tr("1 edit")
                                                 : tr("%1 edits").arg(abandoned.changes);
    QString text = tr("%1; last edited %2. Edits made just before the crash may be missing.")
                       .arg(edits, whenText(abandoned.last));
    if (!abandoned.damage.isEmpty()) text += " " + tr("Journal: %1.").arg(abandoned.damage);
    auto* detail = new QLabel(text, this);
    detail->setObjectName("recoveryDetail");
    detail->setWordWrap(true);
    auto* grid = new QGridLayout(this);
    grid->setContentsMargins(12, 9, 12, 8);
    grid->setHorizontalSpacing(10);
    grid->setVerticalSpacing(3);
    grid->addWidget(icon, 0, 0, Qt::AlignTop);
    grid->addWidget(title, 0, 1);
    grid->addWidget(detail, 1, 1);
    grid->addWidget(makeLinks(), 2, 1);
    grid->setColumnStretch(1, 1);
}

QWidget* RecoveryBox::makeLinks() {
    auto* links = new QWidget(this);
    auto* row = new QHBoxLayout(links);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(12);
    auto* all = link("Recover", tr("Recover"), tr("Opens the scene with all edits, which can still be undone."), links);
    auto* less = link("Without the last command", tr("Recover without last edit"),
                      tr("Omits “%1”, in case it caused the crash.").arg(abandoned_.lastStep), links);
    auto* none = link("Discard", tr("Discard"), tr("Deletes these edits permanently."), links);
    connect(all, &QPushButton::clicked, this, [this] { Q_EMIT recoverWanted(abandoned_, Recover::Everything); });
    connect(less, &QPushButton::clicked, this,
            [this] { Q_EMIT recoverWanted(abandoned_, Recover::WithoutLastCommand); });
    connect(none, &QPushButton::clicked, this, [this] { Q_EMIT giveUpWanted(abandoned_); });
    less->setVisible(abandoned_.changes > 0);
    row->addWidget(all);
    row->addWidget(less);
    row->addStretch(1);
    row->addWidget(none);
    return links;
}

}  // namespace keyblock
