// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Rows arrive a few at a time, thirty times a second. The last chunk is copied and
// extended with them as long as it is small, so chunks that were handed out do not
// change.
#include "ui/runs/history_log.h"

#include <algorithm>
#include <cassert>
#include <iterator>
#include <utility>

namespace keyblock {

namespace {

constexpr std::size_t smallChunk = 256;  // rows

}  // namespace

void HistoryLog::append(std::vector<HistoryRow> rows) {
    if (rows.empty()) return;
    size_ += rows.size();
    if (!chunks_.empty() && chunks_.back().rows->size() + rows.size() <= smallChunk) {
        std::vector<HistoryRow> joined = *chunks_.back().rows;
        joined.insert(joined.end(), std::make_move_iterator(rows.begin()), std::make_move_iterator(rows.end()));
        chunks_.back().rows = std::make_shared<const std::vector<HistoryRow>>(std::move(joined));
        return;
    }
    const std::size_t first = size_ - rows.size();
    chunks_.push_back({first, std::make_shared<const std::vector<HistoryRow>>(std::move(rows))});
}

const HistoryRow& HistoryLog::operator[](std::size_t row) const {
    assert(row < size_);
    const Chunk& chunk = *(std::ranges::upper_bound(chunks_, row, {}, &Chunk::first) - 1);
    return (*chunk.rows)[row - chunk.first];
}

std::vector<HistoryRow> HistoryLog::all() const {
    std::vector<HistoryRow> rows;
    rows.reserve(size_);
    for (const Chunk& chunk : chunks_) rows.insert(rows.end(), chunk.rows->begin(), chunk.rows->end());
    return rows;
}

}  // namespace keyblock
