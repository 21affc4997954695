// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A history to which rows are only appended. Copies are cheap and do not grow, so that
// another thread can read the history as it was at the time of the copy.
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
    /// The history row with the index `row`. \pre row < size()
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
