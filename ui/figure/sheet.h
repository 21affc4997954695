// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The parts around the content of every figure: a title of up to two lines, a subtitle,
// warnings if the values are unreliable, and a footer with the source.
#pragma once

#include "ui/figure/figure.h"
#include "ui/figure/ink.h"

#include <string>
#include <vector>

namespace keyblock {

class Sheet {
public:
    /// A sheet of width `width` [mm]. The title, the subtitle and each warning take up at most two lines; longer ones
    /// are shortened with an ellipsis.
    /// \param warnings the result of `warningsOf`.
    Sheet(double width, const std::string& title, const std::string& subtitle, const std::vector<std::string>& warnings);

    double width() const { return width_; }
    double inner() const { return width_ - 2.0 * paper_theme::margin; }
    double top() const;  // upper edge of the content [mm]
    double heightAround(double content) const;  // height of a sheet whose content has the given height [mm]

    void draw(Ink& ink, double height, const std::string& foot) const;

private:
    double width_;
    std::vector<std::string> title_, subtitle_, warnings_;
};

/// The warnings (from `stageWarnings`) about all stages and about the stage to which the frame with this index belongs; about all stages if
/// `frame` is null. \param notFinite says what of the frame is not shown because it is not finite; empty: nothing.
std::vector<std::string> warningsOf(const RunSource& run, std::optional<std::size_t> frame,
                                    const std::string& notFinite = {});

/// Text of the footer: "Keyblock · RUN, frame 12 of 67 · plane strain · 160 × 107 mm".
/// \param frame index of the frame; null: the figure shows the whole run. \param height height of the figure [mm].
std::string footOf(const RunSource& run, const FigureRequest& request, std::optional<std::size_t> frame, double height);

}  // namespace keyblock
