// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/verify/extremes/limits_page.h"

#include "solver/scene/number_text.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <optional>

namespace keyblock {

namespace {

constexpr const char* introduction =
    R"(<!-- SPDX-FileCopyrightText: The Keyblock contributors -->
<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
# Limits

How far the method can be pushed. Scenes whose answer is known are run with one setting at a time at values to and past its limit, and with random combinations of all settings. This page is written by

```
keyblock verify --extremes --random 2000 --seed 1 --page resources/help/limits.md
```

The answers are checked against closed forms, statics, and conservation of momentum and energy; no check uses code of the solver. Each run ends in one of these ways:

- *right*: the answer is right within the tolerance of its check.
- *refused*: `keyblock check` reports an error, and nothing is run.
- *stopped*: the run ends with a message that names the reason (exit code 4 or 5), and the results so far are kept.
- *warned*: the run ends, its answer is not right, and `keyblock check`, or the summary of the run, gives a warning that the same scene does not get under ordinary conditions. Do not use such results before the cause of the warning is removed.
- *wrong*: none of these. A single such run makes the command exit with 1.
)";

std::string count(int number) {
    std::string text = std::to_string(number);
    for (int at = static_cast<int>(text.size()) - 3; at > 0; at -= 3) text.insert(static_cast<std::size_t>(at), 1, ',');
    return text;
}

std::string countsRow(const std::string& title, const std::vector<ExtremeRun>& runs) {
    const ExtremeCounts counts = countsOf(runs);
    std::string row = "| " + title + " | " + count(counts.all());
    for (const ExtremeEnding ending : {ExtremeEnding::Right, ExtremeEnding::Refused, ExtremeEnding::Stopped,
                                       ExtremeEnding::Warned, ExtremeEnding::Wrong})
        row += " | " + count(counts.of(ending));
    return row + " |\n";
}

std::string countsTable(const std::vector<ExtremeCaseRuns>& cases, const std::vector<RandomExtremes>& random) {
    std::string text =
        "\n| | runs | right | refused | stopped | warned | wrong |\n| --- | --- | --- | --- | --- | --- | --- |\n";
    std::vector<ExtremeRun> all;
    for (const ExtremeCaseRuns& one : cases) all.insert(all.end(), one.runs.begin(), one.runs.end());
    text += countsRow(count(static_cast<int>(cases.size())) + " cases", all);
    for (const RandomExtremes& each : random)
        text += countsRow("random combinations, seed " + std::to_string(each.seed), each.runs);
    return text;
}

/// The last right value in one direction from the ordinary one, and the first that is not right.
struct Edge {
    std::string lastRight;
    const ExtremeRun* first = nullptr;  // null: all are right
};

Edge edgeOf(const ExtremeCaseRuns& one, bool upwards) {
    std::vector<std::size_t> order(one.runs.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
        return upwards ? one.one.values[a] < one.one.values[b] : one.one.values[a] > one.one.values[b];
    });
    const auto usual = std::find_if(order.begin(), order.end(), [&](std::size_t i) { return one.runs[i].usual; });
    Edge edge;
    for (auto at = usual == order.end() ? order.begin() : usual; at != order.end(); ++at) {
        if (one.runs[*at].ending != ExtremeEnding::Right) {
            edge.first = &one.runs[*at];
            break;
        }
        edge.lastRight = one.runs[*at].value;
    }
    return edge;
}

std::string edgeText(const Edge& edge) {
    const std::string last = edge.lastRight.empty() ? "–" : edge.lastRight;
    return last + " | " + (edge.first ? edge.first->value + " " + std::string(wordOf(edge.first->ending)) : "–");
}

std::string sceneOf(const ExtremeCaseRuns& one) { return one.one.name.substr(0, one.one.name.find('/')); }

/// Scenes with the same text, in one row.
class Rows {
public:
    void add(const std::string& scene, const std::string& text) {
        const auto found = std::find_if(rows_.begin(), rows_.end(),
                                        [&](const auto& row) { return row.second == text; });
        if (found == rows_.end()) rows_.emplace_back(scene, text);
        else found->first += ", " + scene;
    }

    std::string text() const {
        std::string all;
        for (const auto& [scenes, text] : rows_) all += "| " + scenes + " | " + text + " |\n";
        return all;
    }

private:
    std::vector<std::pair<std::string, std::string>> rows_;
};

std::string inTable(std::string text) {
    for (std::size_t at = text.find('|'); at != std::string::npos; at = text.find('|', at + 2)) text.insert(at, "\\");
    return text;
}

/// The beginning of a message, up to its first figure, by which alike messages are recognised.
std::string kindOf(const std::string& message) { return message.substr(0, message.find_first_of("0123456789")); }

/// One message of each kind with which runs of an axis ended.
std::string reasonsOf(const std::vector<const ExtremeCaseRuns*>& cases) {
    std::vector<std::string> kinds;
    std::string text;
    for (const ExtremeCaseRuns* one : cases)
        for (const ExtremeRun& run : one->runs) {
            if (run.reason.empty() || run.ending == ExtremeEnding::Right) continue;
            const std::string kind = std::string(wordOf(run.ending)) + kindOf(run.reason);
            if (std::count(kinds.begin(), kinds.end(), kind)) continue;
            kinds.push_back(kind);
            text += "- " + sceneOf(*one) + ", " + run.value + ", " + std::string(wordOf(run.ending)) + ": `" +
                    run.reason + "`\n";
        }
    return text;
}

std::string choiceTable(const std::vector<const ExtremeCaseRuns*>& cases) {
    std::string text = "| scene | value | ending |\n| --- | --- | --- |\n";
    for (const ExtremeCaseRuns* one : cases) {
        std::vector<std::pair<std::string, std::string>> byEnding;
        for (const ExtremeRun& run : one->runs) {
            const std::string ending(wordOf(run.ending));
            const auto found = std::find_if(byEnding.begin(), byEnding.end(),
                                            [&](const auto& each) { return each.first == ending; });
            if (found == byEnding.end()) byEnding.emplace_back(ending, run.value);
            else found->second += ", " + run.value;
        }
        for (const auto& [ending, values] : byEnding)
            text += "| " + sceneOf(*one) + " | " + inTable(values) + " | " + ending + " |\n";
    }
    return text;
}

std::string edgeTable(const std::vector<const ExtremeCaseRuns*>& cases) {
    Rows rows;
    for (const ExtremeCaseRuns* one : cases)
        rows.add(sceneOf(*one), edgeText(edgeOf(*one, false)) + " | " + edgeText(edgeOf(*one, true)));
    return "| scenes | downwards: last right | first other | upwards: last right | first other |\n| --- | --- | --- | --- | --- "
           "|\n" +
           rows.text();
}

std::string axisSection(const std::string& title, const std::vector<const ExtremeCaseRuns*>& cases) {
    const ExtremeCase& first = cases.front()->one;
    std::string text = "\n## " + title + "\n\n" + first.reason + "\n\n";
    text += first.isChoice ? choiceTable(cases) : edgeTable(cases);
    const std::string reasons = reasonsOf(cases);
    if (!reasons.empty()) text += "\n" + reasons;
    return text;
}

std::string sceneTable(const std::vector<ExtremeCaseRuns>& cases) {
    std::string text = "\n## Scenes\n\n| name | scene | checked against |\n| --- | --- | --- |\n", last;
    for (const ExtremeCaseRuns& one : cases) {
        if (sceneOf(one) == last) continue;
        last = sceneOf(one);
        text += "| " + last + " | " + one.one.scene + " | " + inTable(one.one.property) + " |\n";
    }
    return text;
}

std::string randomSection(const std::vector<RandomExtremes>& random) {
    std::string text;
    for (const RandomExtremes& each : random) {
        std::map<std::string, int> kinds;
        for (const ExtremeRun& run : each.runs)
            if (run.ending != ExtremeEnding::Right)
                ++kinds[std::string(wordOf(run.ending)) + ": `" + kindOf(run.reason) + "…`"];
        text +=
            "\n## Random combinations\n\nEach pushes a random scene along two fifths of its axes at once, within ranges that "
            "reach to about the edges above. Those that did not end right, seed " +
            std::to_string(each.seed) + ":\n\n";
        for (const auto& [kind, number] : kinds) text += "- " + std::to_string(number) + " " + kind + "\n";
    }
    return text;
}

}  // namespace

std::string limitsPage(const std::vector<ExtremeCaseRuns>& cases, const std::vector<RandomExtremes>& random) {
    std::vector<std::pair<std::string, std::vector<const ExtremeCaseRuns*>>> axes;
    for (const ExtremeCaseRuns& one : cases) {
        const auto found = std::find_if(axes.begin(), axes.end(),
                                        [&](const auto& axis) { return axis.first == one.one.axis; });
        if (found == axes.end()) axes.push_back({one.one.axis, {&one}});
        else found->second.push_back(&one);
    }
    std::string text = introduction + countsTable(cases, random) + sceneTable(cases);
    for (const auto& [title, each] : axes) text += axisSection(title, each);
    return text + randomSection(random);
}

}  // namespace keyblock
