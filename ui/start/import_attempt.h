// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The result of reading a drawing with certain import settings.
#pragma once

#include "solver/files/drawing/section_import.h"
#include "ui/picture/section/section.h"

#include <memory>
#include <optional>
#include <string>

namespace keyblock {

struct ImportAttempt {
    Import import;
    std::optional<SectionPicture> picture;  // drawing of the resulting scene
    std::string unreadable;  // why there is no scene; empty if there is one
};

/// Reads the drawing at `path`. Does not throw; if the drawing cannot be read, `unreadable` holds the error message.
std::shared_ptr<const ImportAttempt> attemptImport(const std::string& path, const ImportSettings& settings);

}  // namespace keyblock
