// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figure/sheet.h"

#include "solver/results/verdict.h"
#include "ui/picture/captions.h"
#include "ui/picture/ticks.h"

#include <algorithm>

namespace keyblock {

namespace {

using namespace paper_theme;

constexpr double titleRow = 4.2, subtitleRow = 3.2, warningRow = 3.0, footRoom = 6.5;  // [mm]
constexpr std::size_t mostWarnings = 3;  // the summary of the run lists all warnings

const TextStyle warningStyle{2.0, false, error};

}  // namespace

Sheet::Sheet(double width, const std::string& title, const std::string& subtitle,
             const std::vector<std::string>& warnings)
    : width_(width), title_(wrapped(title, text_style::title, inner(), 2)),
      subtitle_(wrapped(subtitle, text_style::subtitle, inner(), 2)) {
    const std::size_t shown = std::min(warnings.size(), mostWarnings);
    for (std::size_t i = 0; i < shown; ++i) {
        const bool last = i + 1 == shown && warnings.size() > shown;
        const std::string more = last ? "; " + std::to_string(warnings.size() - shown) + " more in the summary" : "";
        for (const std::string& line : wrapped("Warning: " + warnings[i] + more + ".", warningStyle, inner(), 2))
            warnings_.push_back(line);
    }
}

double Sheet::top() const {
    return 2.6 + titleRow * static_cast<double>(title_.size()) + subtitleRow * static_cast<double>(subtitle_.size()) +
           warningRow * static_cast<double>(warnings_.size()) + 2.4;
}

double Sheet::heightAround(double content) const { return top() + content + footRoom + 2.5; }

void Sheet::draw(Ink& ink, double height, const std::string& foot) const {
    double y = 2.6;
    for (const std::string& line : title_) ink.text({margin, y += titleRow}, line, text_style::title);
    for (const std::string& line : subtitle_) ink.text({margin, y += subtitleRow}, line, text_style::subtitle);
    for (const std::string& line : warnings_) ink.text({margin, y += warningRow}, line, warningStyle);
    ink.text({margin, height - 4.0}, elided(foot, text_style::foot, inner()), text_style::foot);
}

std::vector<std::string> warningsOf(const RunSource& run, std::optional<std::size_t> frame,
                                    const std::string& notFinite) {
    std::vector<std::string> texts;
    for (const StageWarning& warning : stageWarnings(run))
        if (!frame || warning.stage < 0 || warning.stage == run.frames()[*frame].stage) texts.push_back(warning.text);
    if (!notFinite.empty()) texts.push_back(notFinite);
    return texts;
}

std::string footOf(const RunSource& run, const FigureRequest& request, std::optional<std::size_t> frame,
                   double height) {
    std::string text = "Keyblock · " + request.runName;
    if (frame)
        text += ", frame " + std::to_string(*frame + 1) + " of " + std::to_string(run.frames().size());
    const std::string size = " · " + numberText(request.width, 0) + " × " + numberText(height, 0) + " mm";
    const std::string whole = text + " · " + analysisText(run.scene()) + size;
    const bool fits = textWidth(whole, text_style::foot) <= request.width - 2.0 * margin;
    return fits ? whole : text + size;
}

}  // namespace keyblock
