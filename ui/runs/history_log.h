// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rows of a history that are only ever added. A copy costs little and does not grow,
// so that another thread can read what there was when it was made.
#pragma once

#include "solver/results/results.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace keyblock {

class HistoryLog {
public:
    void append(std::vector<HistoryRow> rows);
    std::size_t size() const { return size_; }
    /// \pre `row` counts within them.
    const HistoryRow& operator[](std::size_t row) const;
    std::vector<HistoryRow> all() const;

private:
    struct Chunk {
        std::size_t first = 0;
        std::shared_ptr<const std::vector<HistoryRow>> rows;
    };
    std::vector<Chunk> chunks_;
    std::size_t size_ = 0;
};

}  // namespace keyblock
