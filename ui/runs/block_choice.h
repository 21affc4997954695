// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The selected block of the run. The blocks of a run are not objects of the scene,
// which may have been edited and cut differently since, so the document cannot select
// them.
#pragma once

#include <QObject>

namespace keyblock {

class BoltChoice;
class TimeCursor;

class BlockChoice : public QObject {
    Q_OBJECT

public:
    /// Selecting a bolt in `bolts` deselects the block.
    BlockChoice(const TimeCursor& cursor, BoltChoice& bolts, QObject* parent = nullptr);

    /// Index of the selected block among the solved blocks of the run shown; −1: none.
    int block() const { return block_; }
    void choose(int block);

Q_SIGNALS:
    void changed();

private:
    const TimeCursor& cursor_;
    BoltChoice& bolts_;
    int block_ = -1;
};

}  // namespace keyblock
