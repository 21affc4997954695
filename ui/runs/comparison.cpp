// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/comparison.h"

#include "ui/runs/live_run.h"
#include "ui/runs/time_cursor.h"

#include <QFileInfo>
#include <QRegularExpression>

#include <exception>

namespace keyblock {

Comparison::Comparison(TimeCursor& first, QObject* parent)
    : QObject(parent), first_(first), second_(new TimeCursor(this)) {
    connect(&first, &TimeCursor::moved, this, &Comparison::follow);
    connect(&first, &TimeCursor::runChanged, this, [this] {
        if (!first_.run()) end();
    });
}

Comparison::~Comparison() = default;

bool Comparison::isOn() const { return second_->run() != nullptr; }

QString Comparison::store() const {
    return second_->run() ? QString::fromStdString(second_->run()->store().string()) : QString();
}

void Comparison::begin(const QString& store) {
    opening_.ask([this, store, asked = ++asked_]() -> Background::Result {
        try {
            auto run = LiveRun::opened(store.toStdString());
            return [this, run = std::move(run), asked] {
                if (asked != asked_ || !first_.run()) return;
                second_->setRun(run, false);
                follow();
                Q_EMIT changed();
            };
        } catch (const std::exception& error) {
            return [this, text = QString::fromStdString(error.what())] { Q_EMIT failed(text); };
        }
    });
}

void Comparison::end() {
    ++asked_;
    if (!isOn()) return;
    second_->setRun(nullptr, false);
    Q_EMIT changed();
}

void Comparison::follow() {
    if (!isOn() || !first_.hasMoment()) return;
    const FrameHead head = first_.head();
    second_->goTo(StageTime{head.stage, head.time});
}

QString runTitle(const QString& store) {
    const QString base = QFileInfo(store).completeBaseName();
    const auto match = QRegularExpression("^(.+)-(\\d+)$").match(base);
    if (!match.hasMatch()) return base;
    return Comparison::tr("Run %1").arg(match.captured(2)) + QString::fromUtf8(" · ") + match.captured(1);
}

}  // namespace keyblock
