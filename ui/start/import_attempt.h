// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A drawing read once with some settings, and the resulting scene.
#pragma once

#include "solver/files/drawing/section_import.h"
#include "ui/picture/section.h"

#include <memory>
#include <optional>
#include <string>

namespace keyblock {

struct ImportAttempt {
    Import import;
    std::optional<SectionPicture> picture;  // of the resulting scene
    std::string unreadable;  // why there is no scene; empty: there is one
};

/// Never throws: errors are in `unreadable`.
std::shared_ptr<const ImportAttempt> attemptImport(const std::string& path, const ImportSettings& settings);

}  // namespace keyblock
