// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Legends of a section, with ranges over all frames of the run.
#pragma once

#include "ui/picture/section.h"

namespace keyblock {

/// Legends of what the request asks for.
SectionLegends sectionLegends(const RunSource& run, const SectionRequest& request);

/// The same with a note on the values of one frame, if it has any.
SectionLegends withNow(SectionLegends legends, const SectionRequest& request, const Frame& frame);

/// Size of a limit of the bolt's steel that the quantity meets [unit shown]; none for other quantities than N.
std::vector<std::pair<double, std::string>> limitsOf(const Scene& scene, const Bolt& bolt,
                                                     const FrameQuantity<BoltNodeFrame>& quantity);

}  // namespace keyblock
