// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/start/import_attempt.h"

#include "ui/document/preview.h"

#include <exception>

namespace keyblock {

std::shared_ptr<const ImportAttempt> attemptImport(const std::string& path, const ImportSettings& settings) {
    auto attempt = std::make_shared<ImportAttempt>();
    try {
        attempt->import = importFile(path, settings);
        if (attempt->import.scene)
            attempt->picture = drawingPicture(attempt->import.cut ? attempt->import.cut->scene : *attempt->import.scene);
    } catch (const std::exception& error) {
        attempt->unreadable = error.what();
    }
    return attempt;
}

}  // namespace keyblock
