// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/store_warning.h"

#include "app/cli/output.h"

namespace keyblock::cli {

void warnOfMissingResults(const RunStore& store, const std::filesystem::path& path) {
    if (store.mayLackResults())
        printToError("warning: " + path.string() +
                     ": the latest results may be missing, because the run did not end and "
                     "the file " +
                     path.filename().string() + "-wal is not next to it; copy both files together\n");
}

}  // namespace keyblock::cli
