// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/study/thin_store.h"

#include "solver/files/atomic_file.h"
#include "solver/files/run_store/run_store.h"
#include "solver/files/run_store/run_store_writer.h"

#include <algorithm>
#include <vector>

namespace keyblock {

namespace {

namespace fs = std::filesystem;

/// Indices of the first and last frame of a stage.
std::vector<std::size_t> endsOf(const std::vector<FrameHead>& frames, int stage) {
    std::vector<std::size_t> ends;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        if (frames[i].stage != stage) continue;
        if (ends.size() == 2) ends.pop_back();
        ends.push_back(i);
    }
    return ends;
}

/// Passes the rows of a stage on in the order in which the run gave them: an event follows its row of the history.
void replay(const RunStore& from, int stage, Sink& to) {
    const std::vector<HistoryRow> history = from.history();
    std::size_t next = std::ranges::find(history, stage, &HistoryRow::stage) - history.begin();
    const auto rowsUpTo = [&](std::size_t end) {
        for (; next < std::min(end, history.size()) && history[next].stage == stage; ++next) to.history(history[next]);
    };
    to.stageBegins(stage);
    for (const Event& event : from.events()) {
        if (event.stage != stage) continue;
        rowsUpTo(static_cast<std::size_t>(event.historyRow + 1));
        to.event(event);
    }
    rowsUpTo(history.size());
    for (const std::size_t frame : endsOf(from.frames(), stage)) to.frame(from.frame(frame));
}

}  // namespace

void thinStore(const fs::path& path, const Scene& scene) {
    fs::path thin = path;
    thin.replace_extension(".thin.kbrun");
    {
        const RunStore whole(path);
        RunStoreWriter writer(thin, true);
        writer.begin(scene, whole.columns());
        for (const StageRecord& record : whole.stages()) {
            replay(whole, record.result.stage, writer);
            if (record.ended) writer.stageEnds(record.result);
        }
        writer.close();
    }
    std::error_code error;
    fs::rename(thin, path, error);
    if (error) throw CannotWrite(cannotWriteText(path, error.value()));
}

}  // namespace keyblock
