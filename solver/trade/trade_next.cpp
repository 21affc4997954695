// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/trade/trade_next.h"

#include "solver/scene/enum_names.h"
#include "solver/scene/number_text.h"
#include "solver/scene/preset.h"
#include "solver/trade/change_text.h"
#include "solver/trade/trade_errors.h"
#include "solver/trade/trade_folder.h"

#include <algorithm>
#include <set>
#include <system_error>

namespace keyblock {

namespace {

namespace fs = std::filesystem;

constexpr int mostFolders = 500;  // in which a trade is searched for

bool isAxis(const TradePoint& point) {
    return point.axis != ownPoint && point.axis != referencePoint && point.axis != combinationPoint &&
           point.axis != bondAxisName && point.axis != threadsAxisName;
}

/// Value of the scene itself, where one number or word says it.
std::string ownText(const Scene& scene, const std::string& axis) {
    const Numerics numerics = numericsOf(scene.analysis);
    if (axis == "divisions") {
        if (scene.bolts.empty() || !scene.bolts.front().divisions) return "automatic";
        return std::to_string(*scene.bolts.front().divisions);
    }
    if (axis == "tolerance") return shortest(numerics.tolerance);
    if (axis == "penalty_ratio") return rounded(numerics.penaltyRatio);
    if (axis == sleepAxisName) return shortest(numerics.sleepTolerance);
    if (axis == presetAxisName)
        return std::string(wordsOf(scene.analysis.preset)[static_cast<std::size_t>(scene.analysis.preset)]);
    return {};
}

std::string whatText(const Scene& scene, const TradePoint& point) {
    const std::string own = ownText(scene, point.axis);
    return point.axis + " " + (own.empty() ? "" : own + " → ") + point.setting;
}

/// Largest change against the scene's own settings with its quantity.
std::string costText(const TradePoint& point, const TradePoint& own, const std::vector<std::string>& quantities) {
    double largest = 0.0;
    std::string quantity;
    for (std::size_t q = 0; q < quantities.size(); ++q)
        if (const double error = errorOf(point, own, quantities, q).value_or(0.0); error > largest) {
            largest = error;
            quantity = quantities[q];
        }
    const std::string change = quantity.empty() ? "no change of any quantity" : changeText(largest) + " in " + quantity;
    return change + ", measured by 'trade'";
}

std::string joined(const std::vector<std::string>& words) {
    std::string text;
    for (const std::string& word : words) text += (text.empty() ? "" : " ") + word;
    return text;
}

/// The cheapest point of an axis that changes little; null if there is none.
const TradePoint* cheapestOf(const std::string& axis, const std::vector<TradePoint>& points,
                             const std::vector<std::string>& quantities) {
    const TradePoint* best = nullptr;
    for (const TradePoint& point : points) {
        if (point.axis != axis || !isCheaper(point, points.front())) continue;
        if (largestError(point, points.front(), quantities) > mostNextError) continue;
        if (!best || point.seconds < best->seconds) best = &point;
    }
    return best;
}

std::vector<fs::path> foldersIn(const fs::path& parent) {
    std::vector<fs::path> folders;
    std::error_code error;
    int left = mostFolders;
    for (fs::directory_iterator at(parent.empty() ? "." : parent, error), end; !error && at != end && left > 0;
         at.increment(error), --left)
        if (at->is_directory(error)) folders.push_back(at->path());
    std::sort(folders.begin(), folders.end());
    return folders;
}

}  // namespace

std::vector<NextLeftOut> measuredNext(const Scene& scene, const std::vector<TradePoint>& points,
                                      const std::vector<std::string>& quantities) {
    if (points.empty() || points.front().axis != ownPoint || !points.front().failure.empty()) return {};
    const TradePoint& own = points.front();
    std::set<std::string> axes;
    for (const TradePoint& point : points)
        if (isAxis(point)) axes.insert(point.axis);
    std::vector<const TradePoint*> chosen;
    for (const std::string& axis : axes)
        if (const TradePoint* point = cheapestOf(axis, points, quantities)) chosen.push_back(point);
    std::sort(chosen.begin(), chosen.end(), [](const auto* a, const auto* b) { return a->seconds < b->seconds; });
    std::vector<NextLeftOut> list;
    for (const TradePoint* point : chosen)
        list.push_back({point->axis, whatText(scene, *point), costText(*point, own, quantities),
                        changeText(1.0 - point->seconds / own.seconds) + " of the time", joined(point->overrides),
                        true});
    return list;
}

std::vector<NextLeftOut> withMeasured(std::vector<NextLeftOut> candidates, const Scene& scene,
                                      const std::vector<TradePoint>& points,
                                      const std::vector<std::string>& quantities) {
    std::vector<NextLeftOut> list = measuredNext(scene, points, quantities);
    const auto wasMeasured = [&](const NextLeftOut& next) {
        return std::any_of(points.begin(), points.end(), [&](const TradePoint& p) { return p.axis == next.axis; });
    };
    for (NextLeftOut& next : candidates)
        if (!wasMeasured(next)) list.push_back(std::move(next));
    return list;
}

std::optional<StoredTrade> findStoredTrade(const fs::path& file, const Scene& scene) {
    std::vector<fs::path> folders = foldersIn(file.parent_path());
    const std::vector<fs::path> here = foldersIn({});
    folders.insert(folders.end(), here.begin(), here.end());
    std::optional<StoredTrade> best;
    for (const fs::path& folder : folders) {
        if (!TradeFolder::holdsTrade(folder)) continue;
        try {
            const TradeFolder trade(folder, scene);
            if (!best || trade.knownPoints() > best->points.size()) best = {folder, trade.quantities(), trade.points()};
        } catch (const std::exception&) {
            continue;  // of another scene or by another version of the program
        }
    }
    return best;
}

}  // namespace keyblock
