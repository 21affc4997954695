// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `import`: lists what a drawing contains, what became of every part of
// it, and what was guessed or assumed. Writes the scene if it can be cut.
#include "app/cli/cli_commands.h"
#include "app/cli/output.h"
#include "app/cli/output_files.h"
#include "app/cli/text_table.h"
#include "solver/scene/number_text.h"
#include "solver/scene/suggest.h"
#include "solver/scene/visible_text.h"

#include <algorithm>
#include <map>

namespace keyblock::cli {

namespace {

constexpr int mostNotTaken = 10;

std::string countedThings(std::size_t count, const std::string& what) {
    return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

std::string layerLines(const Import& import) {
    std::vector<TextRow> rows;
    for (const ImportedLayer& layer : import.layers)
        rows.push_back({layer.name, layer.known ? std::string(wordOf(layer.role)) : "?", layer.source});
    return rows.empty() ? "" : textTable({{"layer"}, {"role"}, {"source"}}, rows);
}

std::string rowLines(const Import& import) {
    std::vector<TextRow> rows;
    for (const ImportRow& row : import.rows)
        rows.push_back({row.kind, row.layer, std::to_string(row.count), row.became});
    return rows.empty() ? "" : textTable({{"entity"}, {"layer"}, {"count", Align::Right}, {"imported as"}}, rows);
}

std::string placeText(const NotTaken& item) {
    return "line " + std::to_string(item.place.line) +
           (item.place.handle.empty() ? "" : " (handle " + item.place.handle + ")");
}

/// Prints each skipped entity with its position and reason: ten for each kind, layer and reason, or all.
void tellNotTaken(const Import& import, bool all) {
    if (import.notTaken.empty())
        return;
    print("skipped:\n");
    std::map<std::tuple<std::string, std::string, std::string>, int> counts;
    for (const NotTaken& item : import.notTaken) {
        const int count = ++counts[{item.kind, item.layer, item.why}];
        if (all || count <= mostNotTaken)
            print(visibleText("  " + item.kind + " on layer " + inQuotes(item.layer) + ", " + placeText(item) + ": " +
                              item.why) +
                  '\n');
    }
    for (const auto& [key, count] : counts)
        if (!all && count > mostNotTaken)
            print(visibleText("  and " + std::to_string(count - mostNotTaken) + " more " + std::get<0>(key) +
                              " on layer " + inQuotes(std::get<1>(key)) + ": " + std::get<2>(key)) +
                  "; --all lists them\n");
}

void tellProblems(const Import& import) {
    for (const Problem& problem : import.problems)
        if (problem.severity == Severity::Error)
            printToError(oneLine(problem) + '\n');
        else
            print(oneLine(problem) + '\n');
}

std::string sceneLine(const Import& import, const std::filesystem::path& out) {
    const Scene& scene = *import.scene;
    std::string line = out.string() + ": " + countedThings(scene.joints.size(), "joint") + ", " +
                       countedThings(scene.tunnels.size(), "tunnel") + ", " + countedThings(scene.bolts.size(), "bolt");
    if (import.cut)
        line += "; cut into " + countedThings(static_cast<std::size_t>(import.cut->blocks), "block") + " of " +
                rounded(import.cut->area) + " m²" +
                (import.cut->notes.empty() ? "" : "; 'keyblock check' lists what was changed");
    return line + '\n';
}

}  // namespace

ExitCode perform(const ImportOptions& options) {
    const OutputFile file{options.out, options.overwrite, Scenes::Replaced};
    if (!mayBeWritten({&file, 1}, {&options.file, 1})) return Usage;
    const Import import = importFile(options.file, options.settings);
    if (!import.unit.empty())
        print(options.file.string() + ": units " + import.unit + '\n');
    print(layerLines(import));
    print(rowLines(import));
    tellNotTaken(import, options.all);
    tellProblems(import);
    if (!import.scene)
        return Invalid;
    for (const std::string& assumed : import.assumed) print("assumed: " + visibleText(assumed) + '\n');
    writeSceneFile(options.out, *import.scene);
    print(sceneLine(import, options.out));
    return Done;
}

}  // namespace keyblock::cli
