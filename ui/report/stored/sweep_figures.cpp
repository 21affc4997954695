// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/stored/sweep_figures.h"

#include "solver/files/atomic_file.h"
#include "solver/run/write_error.h"
#include "solver/study/case_run.h"
#include "ui/figure/sweep_charts.h"

#include <set>

namespace keyblock {

namespace {

namespace fs = std::filesystem;

/// Name of a column as part of a file name.
std::string figureWord(const std::string& name) {
    std::string word;
    for (const char c : name) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.';
        word += plain ? c : '-';
    }
    return word.substr(0, 60);
}

/// The figures of one sweep while they are drawn.
class SweepFigures {
public:
    SweepFigures(const SweepResults& results, const Sweep& sweep)
        : results_(results), folder_(sweep.folder / "figures"),
          title_(sweep.study.title.empty() ? "Sweep" : sweep.study.title) {
        std::error_code error;
        fs::create_directories(folder_, error);
        if (error) throw CannotWrite(cannotWriteText(folder_, error.value()));
    }

    WrittenFigures drawAll(const std::vector<ColumnPair>& pairs) {
        for (const SweepColumn& column : results_.columns) {
            if (isResult(column) && isVaried(column)) {
                put("histogram-" + figureWord(column.name), [&] { return histogram(column); });
                if (const SweepColumn* input = strongestInput(results_, column)) putScatter({input, &column});
            }
            const bool judged = isResult(column) || column.role == ColumnRole::Verdict;
            if (judged && isVaried(column) && !variedInputs(results_).empty())
                put("tornado-" + figureWord(column.name), [&] { return tornado(column); });
        }
        for (const ColumnPair& pair : pairs) putScatter(pair);
        if (!convergence(results_).empty())
            put("convergence",
                [&] { return paintConvergence(convergenceChartOf(title_, results_), PaperFormat::Svg); });
        written_.count = static_cast<long>(names_.size());
        return written_;
    }

private:
    template <typename Draw>
    void put(const std::string& name, Draw draw) {
        try {
            const std::string bytes = draw();
            writeAtomically(folder_ / (name + ".svg"), [&](std::ostream& out) { out << bytes; });
            names_.insert(name);
        } catch (const CannotDraw& problem) {
            written_.leftOut.push_back(name + ": " + problem.what());
        }
    }

    void putScatter(const ColumnPair& pair) {
        put("scatter-" + figureWord(pair.x->name) + "-" + figureWord(pair.y->name),
            [&] { return paintScatter(scatterOf(title_, results_, pair), PaperFormat::Svg); });
    }

    std::string histogram(const SweepColumn& column) const {
        return paintHistogram(histogramOf(title_, column), PaperFormat::Svg);
    }

    std::string tornado(const SweepColumn& column) const {
        return paintTornado(tornadoOf(title_, results_, column), PaperFormat::Svg);
    }

    const SweepResults& results_;
    fs::path folder_;
    std::string title_;
    std::set<std::string> names_;  // of the figures drawn
    WrittenFigures written_;
};

}  // namespace

WrittenFigures writeSweepFigures(const SweepResults& results, const Sweep& sweep,
                                 const std::vector<ColumnPair>& pairs) {
    return SweepFigures(results, sweep).drawAll(pairs);
}

void collectSweep(const fs::path& folder) {
    const Sweep sweep = openSweep(folder);
    const SweepResults results = collectResults(sweep, sweepRunOf(sweep, 1).quantities);
    writeSweepTables(results, sweep);
    writeSweepFigures(results, sweep, {});
}

}  // namespace keyblock
