// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/sweep_figures.h"

#include "app/cli/output.h"
#include "solver/scene/suggest.h"

#ifdef KEYBLOCK_HAS_FIGURES
#include "ui/report/stored/sweep_figures.h"
#endif

namespace keyblock::cli {

namespace {

const SweepColumn& columnNamed(const std::string& name, const SweepResults& results) {
    if (const SweepColumn* column = findColumn(results, name)) return *column;
    std::vector<std::string_view> names;
    for (const SweepColumn& column : results.columns) names.push_back(column.name);
    throw UsageError("--scatter: there is no column " + inQuotes(name) + "; " + suggestion(name, names));
}

}  // namespace

std::vector<ColumnPair> scatterPairs(const std::vector<std::string>& texts, const SweepResults& results) {
    std::vector<ColumnPair> pairs;
    for (const std::string& text : texts) {
        const auto comma = text.find(',');
        if (comma == std::string::npos)
            throw UsageError("--scatter: " + inQuotes(text) + " is not of the form X,Y: two columns of results.csv");
        pairs.push_back({&columnNamed(text.substr(0, comma), results), &columnNamed(text.substr(comma + 1), results)});
    }
    return pairs;
}

#ifdef KEYBLOCK_HAS_FIGURES

long drawSweepFigures(const SweepResults& results, const Sweep& sweep, const std::vector<ColumnPair>& pairs) {
    const WrittenFigures written = writeSweepFigures(results, sweep, pairs);
    for (const std::string& leftOut : written.leftOut) print("no figure " + leftOut + "\n");
    return written.count;
}

#else

long drawSweepFigures(const SweepResults&, const Sweep&, const std::vector<ColumnPair>&) {
    print("this program was built without figures, so figures are left out\n");
    return 0;
}

#endif

}  // namespace keyblock::cli
