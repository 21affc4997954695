// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A drawing read once with some settings, and what would come of it.
#pragma once

#include "solver/files/section_import.h"
#include "ui/picture/section.h"

#include <memory>
#include <optional>
#include <string>

namespace keyblock {

struct ImportAttempt {
    Import import;
    std::optional<SectionPicture> picture;  // of the scene that would be made
    std::string unreadable;  // why nothing came of it; empty: something did
};

/// Never throws: whatever goes wrong is in `unreadable`.
std::shared_ptr<const ImportAttempt> attemptImport(const std::string& path, const ImportSettings& settings);

}  // namespace keyblock
