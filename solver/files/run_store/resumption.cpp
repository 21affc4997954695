// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/files/run_store/resumption.h"

#include "solver/engine/step/blas_kernel.h"
#include "solver/files/run_store/checkpoint_bytes.h"
#include "solver/files/read_error.h"
#include "solver/files/run_store/run_store.h"
#include "solver/files/scene/scene_file.h"
#include "solver/files/sha256.h"
#include "solver/results/run_source.h"

#include <system_error>

namespace keyblock {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void cannotResume(const fs::path& path, const std::string& why) {
    throw CannotRead("cannot resume " + path.string() + ": " + why +
                     "; run the scene again with --overwrite, or choose another --out");
}

bool isEmptyOrMissing(const fs::path& path) {
    std::error_code error;
    const fs::file_status status = fs::status(path, error);
    return !fs::exists(status) || (fs::is_regular_file(status) && fs::file_size(path, error) == 0);
}

/// Results of another kernel may differ in the last digits.
void requireKernel(const fs::path& path, const std::string& kernel) {
    if (kernel == blasKernel()) return;
    const std::string which = "it was begun with the OpenBLAS kernel " + kernel + ", and this process uses " +
                              blasKernel();
    if (!canRunBlasKernel(kernel)) cannotResume(path, which + "; this processor cannot run " + kernel);
    throw CannotRead("cannot resume " + path.string() + ": " + which + "; set " + blasKernelVariable + "=" + kernel +
                     " and resume again");
}

/// Whether the store has the results that had been written at the checkpoint.
bool isWithin(const Written& written, const RunStore& store) {
    const auto within = [](long count, std::size_t stored) { return count >= 0 && count <= static_cast<long>(stored); };
    return within(written.frames, store.frames().size()) && within(written.events, store.events().size()) &&
           within(written.historyRows, store.history().size());
}

}  // namespace

Resumption resumptionOf(const fs::path& path, const Scene& scene) {
    if (isEmptyOrMissing(path))
        return {};
    const RunStore store(path);
    if (store.sceneHash() != sha256(wholeSceneText(scene)))
        cannotResume(path, "it contains a run of another scene, or the scene was changed since then");
    Resumption resumption;
    resumption.finished = isFinished(store);
    const std::optional<StoredCheckpoint> stored = store.checkpoint();
    if (resumption.finished || !stored)
        return resumption;
    if (stored->build != buildName())
        cannotResume(path, "another build of the program wrote it (" + stored->build + "; this build is " + buildName() +
                               "), whose results may differ");
    requireKernel(path, stored->kernel);
    if (stored->hash != sha256(stored->state))
        cannotResume(path, "its checkpoint is damaged");
    resumption.checkpoint = checkpointOf(stored->state);
    if (!resumption.checkpoint || !isWithin(resumption.checkpoint->written, store))
        cannotResume(path, "its checkpoint is damaged");
    return resumption;
}

}  // namespace keyblock
