// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Which block of the run is looked at. Blocks of a run are not objects of the scene,
// which may be cut in another way since, so the document cannot select them.
#pragma once

#include <QObject>

namespace keyblock {

class BoltChoice;
class TimeCursor;

class BlockChoice : public QObject {
    Q_OBJECT

public:
    /// A bolt that is chosen takes the place of the block.
    BlockChoice(const TimeCursor& cursor, BoltChoice& bolts, QObject* parent = nullptr);

    /// Row of the solved blocks of the run that is shown; −1: none.
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
