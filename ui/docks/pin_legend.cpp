// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/pin_legend.h"

#include "ui/look/plain_text.h"
#include "ui/look/theme.h"
#include "ui/runs/pinned_values.h"

#include <QHBoxLayout>
#include <QToolButton>
#include <QVariant>

namespace keyblock {

PinLegend::PinLegend(const Themes& themes, Pins& pins, QWidget* parent)
    : QWidget(parent), themes_(themes), pins_(pins), row_(new QHBoxLayout(this)) {
    setObjectName("pinLegend");
    setAccessibleName(tr("Pins"));
    row_->setContentsMargins(0, 0, 0, 0);
    row_->setSpacing(4);
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);  // so that many pins do not widen the dock
    connect(&pins, &Pins::changed, this, &PinLegend::fill);
    connect(&themes, &Themes::changed, this, &PinLegend::fill);
    fill();
}

void PinLegend::fill() {
    while (QLayoutItem* item = row_->takeAt(0)) {
        if (item->widget()) item->widget()->deleteLater();
        delete item;
    }
    for (const Pin& pin : pins_.pins()) {
        auto* chip = new QToolButton(this);
        chip->setObjectName(QStringLiteral("pin%1").arg(pin.number));
        chip->setText(QString::fromStdString(nameOf(pin)));
        chip->setAccessibleName(tr("Unpin %1").arg(chip->text()));
        chip->setToolTip(asTip(tr("Unpin %1: %2").arg(chip->text(), QString::fromStdString(titleOf(pin)))));
        chip->setIcon(themes_.icon("close"));
        chip->setIconSize({10, 10});
        chip->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
        chip->setLayoutDirection(Qt::RightToLeft);  // puts the cross to the right of the name
        chip->setProperty("framed", true);
        chip->setFixedHeight(22);
        const int number = pin.number;
        connect(chip, &QToolButton::clicked, this, [this, number] { pins_.remove(number); }, Qt::QueuedConnection);
        row_->addWidget(chip);
    }
    row_->addStretch(1);
    setVisible(!pins_.tracks().empty());
}

}  // namespace keyblock
