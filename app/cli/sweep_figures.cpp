// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/sweep_figures.h"

#include "app/cli/output.h"
#include "solver/files/atomic_file.h"
#include "solver/run/write_error.h"
#include "solver/scene/number_text.h"
#include "solver/scene/suggest.h"

#ifdef KEYBLOCK_HAS_FIGURES
#include "ui/figure/sweep_figure.h"
#endif

#include <algorithm>
#include <cmath>
#include <set>

namespace keyblock::cli {

namespace {

const SweepColumn& columnNamed(const std::string& name, const SweepResults& results) {
    if (const SweepColumn* column = findColumn(results, name)) return *column;
    std::vector<std::string_view> names;
    for (const SweepColumn& column : results.columns) names.push_back(column.name);
    throw UsageError("--scatter: there is no column " + inQuotes(name) + "; " + suggestion(name, names));
}

#ifdef KEYBLOCK_HAS_FIGURES

namespace fs = std::filesystem;

/// Name of a column as part of a file name.
std::string fileWord(const std::string& name) {
    std::string word;
    for (const char c : name) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '.';
        word += plain ? c : '-';
    }
    return word.substr(0, 60);
}

bool isVaried(const SweepColumn& column) {
    const std::vector<double> sorted = sortedValues(column);
    return sorted.size() > 1 && sorted.front() < sorted.back();
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

    void drawAll(const std::vector<ScatterPair>& pairs) {
        for (const SweepColumn& column : results_.columns) {
            if (column.role == ColumnRole::Result && isVaried(column)) {
                put("histogram-" + fileWord(column.name), [&] { return histogram(column); });
                if (const SweepColumn* input = strongestInput(column)) drawScatter({input, &column});
            }
            const bool judged = column.role == ColumnRole::Result || column.role == ColumnRole::Verdict;
            if (judged && isVaried(column) && strongestInput(column))
                put("tornado-" + fileWord(column.name), [&] { return tornado(column); });
        }
        for (const ScatterPair& pair : pairs) drawScatter(pair);
        if (!convergence(results_).empty()) put("convergence", [&] { return convergenceFigure(); });
    }

    long count() const { return static_cast<long>(names_.size()); }

private:
    template <typename Draw>
    void put(const std::string& name, Draw draw) {
        try {
            const std::string bytes = draw();
            writeAtomically(folder_ / (name + ".svg"), [&](std::ostream& out) { out << bytes; });
            names_.insert(name);
        } catch (const CannotDraw& problem) {
            print("no figure " + name + ": " + problem.what() + "\n");
        }
    }

    void drawScatter(const ScatterPair& pair) {
        put("scatter-" + fileWord(pair.x->name) + "-" + fileWord(pair.y->name), [&] { return scatter(pair); });
    }

    /// The varied input with the largest rank correlation; null if there is none.
    const SweepColumn* strongestInput(const SweepColumn& result) const {
        const SweepColumn* strongest = nullptr;
        double largest = -1.0;
        for (const SweepColumn* input : inputs())
            if (const double correlation = std::abs(correlationOf(*input, result)); correlation > largest) {
                largest = correlation;
                strongest = input;
            }
        return strongest;
    }

    std::vector<const SweepColumn*> inputs() const {
        std::vector<const SweepColumn*> inputs;
        for (const SweepColumn& column : results_.columns)
            if ((column.role == ColumnRole::Parameter || column.role == ColumnRole::Fault) && isVaried(column))
                inputs.push_back(&column);
        return inputs;
    }

    std::string histogram(const SweepColumn& column) const {
        const std::vector<double> sorted = sortedValues(column);
        return paintHistogram(
            {title_, column.name + " in " + std::to_string(sorted.size()) + " cases", column.name, sorted},
            PaperFormat::Svg);
    }

    std::string scatter(const ScatterPair& pair) const {
        ScatterChart chart{
            title_, "rank correlation " + rounded(correlationOf(*pair.x, *pair.y)), pair.x->name, pair.y->name, {}};
        const SweepColumn* fails = findColumn(results_, "fails");
        for (std::size_t i = 0; i < pair.x->values.size(); ++i)
            if (std::isfinite(pair.x->values[i]) && std::isfinite(pair.y->values[i]))
                chart.dots.push_back({pair.x->values[i], pair.y->values[i], fails && fails->values[i] == 1.0});
        return paintScatter(chart, PaperFormat::Svg);
    }

    std::string tornado(const SweepColumn& column) const {
        TornadoChart chart{title_, "Rank correlation of " + column.name + " with what varies", {}};
        for (const SweepColumn* input : inputs()) chart.bars.push_back({input->name, correlationOf(*input, column)});
        std::ranges::stable_sort(chart.bars, std::ranges::greater{},
                                 [](const TornadoBar& bar) { return std::abs(bar.value); });
        return paintTornado(chart, PaperFormat::Svg);
    }

    std::string convergenceFigure() const {
        ConvergenceChart chart{
            title_, "Probability of failure with its 95 % interval; failure: " + results_.criterion, {}};
        for (const ConvergencePoint& p : convergence(results_))
            chart.points.push_back({static_cast<double>(p.cases), p.probability, p.interval.low, p.interval.high});
        return paintConvergence(chart, PaperFormat::Svg);
    }

    const SweepResults& results_;
    fs::path folder_;
    std::string title_;
    std::set<std::string> names_;  // of the figures drawn
};

#endif

}  // namespace

std::vector<ScatterPair> scatterPairs(const std::vector<std::string>& texts, const SweepResults& results) {
    std::vector<ScatterPair> pairs;
    for (const std::string& text : texts) {
        const auto comma = text.find(',');
        if (comma == std::string::npos)
            throw UsageError("--scatter: " + inQuotes(text) + " is not of the form X,Y: two columns of results.csv");
        pairs.push_back({&columnNamed(text.substr(0, comma), results), &columnNamed(text.substr(comma + 1), results)});
    }
    return pairs;
}

#ifdef KEYBLOCK_HAS_FIGURES

long writeSweepFigures(const SweepResults& results, const Sweep& sweep, const std::vector<ScatterPair>& pairs) {
    SweepFigures figures(results, sweep);
    figures.drawAll(pairs);
    return figures.count();
}

#else

long writeSweepFigures(const SweepResults&, const Sweep&, const std::vector<ScatterPair>&) {
    print("this program was built without figures, so figures are left out\n");
    return 0;
}

#endif

}  // namespace keyblock::cli
