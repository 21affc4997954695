// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Results of one bolt or block at a given time as rows of text, in display units and
// with the sign convention of the display. Plain values that any thread can create.
#pragma once

#include "solver/results/results.h"
#include "ui/picture/charts/bolt_report.h"
#include "ui/picture/section/shown_numbers.h"

#include <QString>

#include <optional>
#include <vector>

namespace keyblock {

class RunSource;

struct ResultRow {
    QString name, value;
    QString detail{};  // position and time, shown below the value; empty: none
    std::optional<double> use{};  // utilisation as a fraction of the strength, drawn as a bar
};

struct ResultEvent {
    QString when, what;
    Event event;  // first event of the row; a click moves the time to it
};

struct ResultReport {
    QString title, detail;
    std::vector<ResultRow> rows;
    std::vector<ResultEvent> events;
};

/// The results of a bolt in the frame. \param events events of the run up to the frame.
/// \pre `bolt` is a valid index into the bolts of the frame.
ResultReport boltResults(const RunSource& run, const Frame& frame, int bolt, const std::vector<Event>& events,
                         const ShownNumbers& numbers);

/// The results of a block in the frame. \param events events of the run up to the frame.
/// \pre `block` is a valid index into the blocks of the frame.
ResultReport blockResults(const RunSource& run, const Frame& frame, int block, const std::vector<Event>& events,
                          const ShownNumbers& numbers);

}  // namespace keyblock
