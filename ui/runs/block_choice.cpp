// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/runs/block_choice.h"

#include "ui/runs/bolt_choice.h"
#include "ui/runs/live_run.h"
#include "ui/runs/time_cursor.h"

#include <algorithm>

namespace keyblock {

BlockChoice::BlockChoice(const TimeCursor& cursor, BoltChoice& bolts, QObject* parent)
    : QObject(parent), cursor_(cursor), bolts_(bolts) {
    connect(&cursor, &TimeCursor::runChanged, this, [this] { choose(-1); });
    // If the run changes, the choice of bolts changes first; a block that the new run does not have is dropped then.
    connect(&bolts, &BoltChoice::changed, this, [this] { choose(bolts_.bolt() >= 0 ? -1 : block_); });
}

void BlockChoice::choose(int block) {
    const int count = cursor_.run() ? static_cast<int>(cursor_.run()->blockNames().size()) : 0;
    const int chosen = block < count ? std::max(block, -1) : -1;
    if (chosen == block_) return;
    block_ = chosen;
    if (block_ >= 0 && bolts_.bolt() >= 0) bolts_.choose(-1);
    Q_EMIT changed();
}

}  // namespace keyblock
