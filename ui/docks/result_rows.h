// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Results of one bolt or block at a time as rows of text, in the units and signs shown:
// plain values, created on any thread.
#pragma once

#include "solver/results/results.h"
#include "ui/picture/bolt_report.h"
#include "ui/picture/shown_numbers.h"

#include <QString>

#include <optional>
#include <vector>

namespace keyblock {

class RunSource;

struct ResultRow {
    QString name, value;
    QString detail{};  // position and time, below the value; empty: none
    std::optional<double> use{};  // share of a strength, drawn as a bar
};

struct ResultEvent {
    QString when, what;
    Event event;  // the first of them, to which a click moves the time
};

struct ResultReport {
    QString title, detail;
    std::vector<ResultRow> rows;
    std::vector<ResultEvent> events;
};

/// \param events events of the run up to the frame. \pre the bolt is a row of the frame.
ResultReport boltResults(const RunSource& run, const Frame& frame, int bolt, const std::vector<Event>& events,
                         const ShownNumbers& numbers);

/// The same for a block, a row of the frame.
ResultReport blockResults(const RunSource& run, const Frame& frame, int block, const std::vector<Event>& events,
                          const ShownNumbers& numbers);

}  // namespace keyblock
