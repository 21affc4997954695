// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A trade on disk. Each point is written when it has been measured, so that an
// interrupted trade continues where it stopped.
#pragma once

#include "solver/trade/trade.h"

#include <filesystem>
#include <string>
#include <vector>

namespace keyblock {

class TradeFolder {
public:
    /// Opens the folder, or makes it. Points that the same program has measured for the same scene are read.
    /// \throws CannotWrite if the folder holds anything but a trade of this scene by this program, or cannot be made.
    TradeFolder(std::filesystem::path folder, const Scene& scene);

    /// Whether a folder holds a trade of any scene.
    static bool holdsTrade(const std::filesystem::path& folder);

    std::optional<TradePoint> known(const TradeSetting& setting) const;
    std::size_t knownPoints() const { return points_.size(); }
    const std::vector<TradePoint>& points() const { return points_; }
    /// Quantities of the points that are known; empty if there are none.
    const std::vector<std::string>& quantities() const { return quantities_; }

    /// Adds a point to the folder. \throws CannotWrite
    void keep(const TradePoint& point, const std::vector<std::string>& quantities);

    /// Writes trade.csv and trade.md. \throws CannotWrite
    void writeTables(const Trade& trade, const Scene& scene) const;

    const std::filesystem::path& path() const { return folder_; }

private:
    std::filesystem::path folder_;
    std::string scene_;  // hash
    std::vector<TradePoint> points_;
    std::vector<std::string> quantities_;
};

}  // namespace keyblock
