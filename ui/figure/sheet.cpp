// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/figure/sheet.h"

#include "ui/picture/captions.h"
#include "ui/picture/ticks.h"

namespace keyblock {

namespace {

using namespace paper_theme;

constexpr double titleRow = 4.2, subtitleRow = 3.2, footRoom = 6.5;  // [mm]

}  // namespace

Sheet::Sheet(double width, const std::string& title, const std::string& subtitle)
    : width_(width), title_(wrapped(title, text_style::title, inner(), 2)),
      subtitle_(wrapped(subtitle, text_style::subtitle, inner(), 2)) {}

double Sheet::top() const {
    return 2.6 + titleRow * static_cast<double>(title_.size()) + subtitleRow * static_cast<double>(subtitle_.size()) +
           2.4;
}

double Sheet::heightAround(double content) const { return top() + content + footRoom + 2.5; }

void Sheet::draw(Ink& ink, double height, const std::string& foot) const {
    double y = 2.6;
    for (const std::string& line : title_) ink.text({margin, y += titleRow}, line, text_style::title);
    for (const std::string& line : subtitle_) ink.text({margin, y += subtitleRow}, line, text_style::subtitle);
    ink.text({margin, height - 4.0}, elided(foot, text_style::foot, inner()), text_style::foot);
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
