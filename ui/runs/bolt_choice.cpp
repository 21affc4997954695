// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/bolt_choice.h"

#include "ui/document/selection.h"
#include "ui/runs/live_run.h"
#include "ui/runs/time_cursor.h"

#include <algorithm>

namespace keyblock {

namespace {

/// The pattern that a bolt is of, as PATTERN.3; −1: it stands there by itself.
int patternOf(const Scene& scene, const Bolt& bolt) {
    const std::size_t dot = bolt.name.rfind('.');
    if (dot == std::string::npos) return -1;
    for (std::size_t p = 0; p < scene.boltPatterns.size(); ++p)
        if (scene.boltPatterns[p].name == bolt.name.substr(0, dot)) return static_cast<int>(p);
    return -1;
}

}  // namespace

BoltChoice::BoltChoice(Selection& selection, const TimeCursor& cursor, QObject* parent)
    : QObject(parent), selection_(selection), cursor_(cursor) {
    connect(&selection, &Selection::changed, this, &BoltChoice::follow);
    connect(&cursor, &TimeCursor::runChanged, this, [this] {
        bolt_ = selectedRow();
        Q_EMIT changed();
    });
}

/// The first bolt that is selected.
int BoltChoice::selectedRow() const {
    if (!cursor_.run()) return -1;
    const Scene& scene = cursor_.run()->scene();
    for (const QString& pointer : selection_.pointers()) {
        const QStringList parts = pointer.split('/');
        if (parts.size() < 3 || parts[1] != "bolts") continue;
        bool isNumber = false;
        const int row = parts[2].toInt(&isNumber);
        if (!isNumber || row < 0 || static_cast<std::size_t>(row) >= scene.bolts.size()) continue;
        if (patternOf(scene, scene.bolts[static_cast<std::size_t>(row)]) < 0) return row;
    }
    return -1;
}

void BoltChoice::follow() {
    if (choosing_) return;
    const int row = selectedRow();
    if (row == bolt_) return;
    bolt_ = row;
    Q_EMIT changed();
}

void BoltChoice::choose(int bolt) {
    if (!cursor_.run() || bolt >= static_cast<int>(cursor_.run()->scene().bolts.size())) return;
    const Scene& scene = cursor_.run()->scene();
    QStringList pointers;
    if (bolt >= 0) {
        const int pattern = patternOf(scene, scene.bolts[static_cast<std::size_t>(bolt)]);
        pointers += pattern < 0 ? QStringLiteral("/bolts/%1").arg(bolt) : QStringLiteral("/bolt_patterns/%1").arg(pattern);
    }
    bolt_ = std::max(bolt, -1);
    choosing_ = true;
    selection_.set(pointers);
    choosing_ = false;
    Q_EMIT changed();
}

}  // namespace keyblock
