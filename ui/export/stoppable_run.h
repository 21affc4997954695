// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Figures and animations read many frames; work that is no longer wanted ends with the
// next one.
#pragma once

#include "solver/results/run_source.h"
#include "ui/export/export_write.h"

#include <atomic>
#include <string>
#include <vector>

namespace keyblock {

/// A run that throws `ExportStopped` at the next frame once `stop` is set.
class StoppableRun : public RunSource {
public:
    StoppableRun(const RunSource& run, const std::atomic<bool>& stop) : run_(run), stop_(stop) {}

    const Scene& scene() const override { return run_.scene(); }
    const std::vector<std::string>& blockNames() const override { return run_.blockNames(); }
    const HistoryColumns& columns() const override { return run_.columns(); }
    std::vector<StageRecord> stages() const override { return run_.stages(); }
    std::vector<Event> events() const override { return run_.events(); }
    std::vector<HistoryRow> history() const override { return run_.history(); }
    const std::vector<FrameHead>& frames() const override { return run_.frames(); }
    Frame frame(std::size_t index) const override {
        if (stop_) throw ExportStopped();
        return run_.frame(index);
    }

private:
    const RunSource& run_;
    const std::atomic<bool>& stop_;
};

}  // namespace keyblock
