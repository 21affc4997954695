// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/run/sink.h"

#include "solver/run/checkpoint.h"

namespace keyblock {

void Sink::resume(const Scene& scene, const HistoryColumns& columns, const Checkpoint&) { begin(scene, columns); }

void MemorySink::resume(const Scene&, const HistoryColumns& columns, const Checkpoint& from) {
    results.columns = columns;
    results.events.resize(from.written.events);
    results.history.resize(from.written.historyRows);
    results.frames.resize(from.written.frames);
    results.stages = from.results;
}

}  // namespace keyblock
