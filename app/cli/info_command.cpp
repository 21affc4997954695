// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The command `info`: prints what a run store contains, even while it is being written
// or after its run was killed.
#include "app/cli/cli_commands.h"
#include "app/cli/estimate_listing.h"
#include "app/cli/json_answers.h"
#include "app/cli/output.h"
#include "app/cli/store_warning.h"
#include "app/cli/summary_text.h"
#include "solver/files/run_store/stored_estimate.h"

namespace keyblock::cli {

namespace {

std::string estimateText(const std::filesystem::path& run) {
    const std::optional<ErrorEstimate> estimate = storedEstimate(run);
    return estimate ? errorEstimateLines(*estimate) : "";
}

}  // namespace

ExitCode perform(const InfoOptions& options) {
    const RunStore store(options.run);
    warnOfMissingResults(store, options.run);
    if (options.json) print(infoJson(store, storedEstimate(options.run)));
    else
        print(summaryOf(store, {}) + estimateText(options.run) + "\nscene   " + store.sceneHash() +
              "\nwritten by keyblock " + store.programVersion() + "\n");
    return Done;
}

}  // namespace keyblock::cli
