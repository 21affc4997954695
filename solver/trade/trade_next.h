// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What the user could leave out of a scene next, as a trade of the scene has measured
// it.
#pragma once

#include "solver/run/next_left_out.h"
#include "solver/trade/trade.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace keyblock {

/// Largest change of a quantity by a setting that is named as one to use next.
inline constexpr double mostNextError = 0.1;

/// For each axis, the setting that saves most among those that change no quantity of the scene's own settings by more than
/// `mostNextError`; those that save most first. Empty if the scene has no result with its own settings.
std::vector<NextLeftOut> measuredNext(const Scene& scene, const std::vector<TradePoint>& points,
                                      const std::vector<std::string>& quantities);

/// Candidates with those that were measured in place of the others of the same axis. An axis that was measured without
/// a cheaper setting is left out.
std::vector<NextLeftOut> withMeasured(std::vector<NextLeftOut> candidates, const Scene& scene,
                                      const std::vector<TradePoint>& points,
                                      const std::vector<std::string>& quantities);

/// A trade of a scene by this program in a folder next to the scene's file or in the working directory.
struct StoredTrade {
    std::filesystem::path folder;
    std::vector<std::string> quantities;
    std::vector<TradePoint> points;
};

/// The one with the most points; nothing if there is none. \param file of the scene.
std::optional<StoredTrade> findStoredTrade(const std::filesystem::path& file, const Scene& scene);

}  // namespace keyblock
