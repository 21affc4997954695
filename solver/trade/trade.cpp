// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/trade/trade.h"

#include "solver/trade/change_text.h"
#include "solver/trade/trade_errors.h"

#include <algorithm>
#include <array>

namespace keyblock {

namespace {

constexpr std::array combinedErrors{0.1, 0.03, 0.01,
                                    0.003};  // largest error of a combination, shared among its settings

class Measuring {
public:
    Measuring(const Scene& scene, const TradeSettings& settings, Trade& trade)
        : scene_(scene), settings_(settings), trade_(trade), axes_(tradeAxes(scene, tradeModelOf(scene))) {
        for (const TradeAxis& axis : axes_) {
            planned_ += axis.settings.size();
            for (const TradeSetting& setting : axis.settings) cost_ += setting.cost;
            if (axis.refines && axis.ownSize > 0.0) trade_.ownSizes[axis.name] = axis.ownSize;
        }
        planned_ += 2 + combinedErrors.size();
        trade_.planned = planned_;
    }

    bool all() {
        if (trade_.quantities.empty()) trade_.quantities = scene_.quantities;
        trade_.proposed = scene_.quantities.empty();
        TradeSetting own{ownPoint, "", {}, [](Scene&) {}};
        if (!add(own)) return false;
        if (!trade_.points.front().failure.empty()) return true;
        if (!addReference() || !addAxes()) return false;
        if (trade_.reference == 0) chooseReference();
        return addCombinations();
    }

private:
    /// Measures a setting unless its estimated time exceeds what is left. \return false if it was stopped.
    bool add(const TradeSetting& setting) {
        ++done_;
        if (std::optional<TradePoint> before = settings_.known ? settings_.known(setting) : std::nullopt) {
            take(std::move(*before), setting);
            return true;
        }
        if (const double expected = expectedSeconds(setting);
            settings_.budget && spent_ + expected > *settings_.budget) {
            trade_.leftOut.push_back({setting.axis, setting.text,
                                      "would take some " + threeDigits(expected) + " s, of which " +
                                          threeDigits(std::max(0.0, *settings_.budget - spent_)) + " s are left"});
            return true;
        }
        const TradeRun run = [&](const Scene& scene, const SceneCut& cut, int threads, Sink& sink) {
            settings_.run(scene, cut, threads, labelOf(setting), sink);
        };
        std::optional<TradePoint> point = measurePoint(scene_, setting, trade_.quantities, run);
        if (!point) return false;
        take(std::move(*point), setting);
        if (settings_.measured) settings_.measured(trade_.points.back());
        return true;
    }

    void take(TradePoint point, const TradeSetting& setting) {
        spent_ += point.seconds;
        trade_.points.push_back(std::move(point));
        trade_.settings.push_back(setting);
    }

    /// What is run, e.g. "run 3 of 31, some 40 s left in all, divisions 60".
    std::string labelOf(const TradeSetting& setting) const {
        std::string text = "run " + std::to_string(done_) + " of " + std::to_string(std::max(done_, planned_));
        if (!trade_.points.empty())
            text += ", some " + threeDigits(std::max(0.0, cost_ * trade_.points.front().seconds - spent_)) +
                    " s left in all";
        return text + ", " + setting.axis + (setting.text.empty() ? "" : " " + setting.text);
    }

    double expectedSeconds(const TradeSetting& setting) const {
        return trade_.points.empty() ? 0.0 : setting.cost * trade_.points.front().seconds;
    }

    /// The finest setting of every axis that refines.
    bool addReference() {
        std::vector<TradeSetting> finest;
        for (const TradeAxis& axis : axes_)
            if (isFiner(axis)) finest.push_back(axis.settings.back());
        if (finest.empty()) return true;
        const std::size_t before = trade_.points.size();
        if (!add(combined(referencePoint, finest))) return false;
        if (trade_.points.size() > before && trade_.points.back().failure.empty())
            trade_.reference = static_cast<int>(before);
        return true;
    }

    /// Without a run with the finest settings together, that with the finest setting of one axis or with the finest
    /// preset takes its place, whichever has most work and unknowns.
    void chooseReference() {
        const auto effort = [](const TradePoint& point) { return workOf(point.work) * point.unknowns; };
        for (std::size_t i = 1; i < trade_.points.size(); ++i) {
            const TradePoint& point = trade_.points[i];
            if (isFinest(point) && point.failure.empty() && effort(point) > effort(trade_.points[trade_.reference]))
                trade_.reference = static_cast<int>(i);
        }
    }

    bool isFinest(const TradePoint& point) const {
        return std::any_of(axes_.begin(), axes_.end(), [&](const TradeAxis& axis) {
            if (axis.name != point.axis || axis.name == "penalty_ratio" || axis.settings.empty()) return false;
            const TradeSetting& last = axis.settings.back();
            return last.text == point.setting && (axis.name == presetAxisName || isFiner(axis));
        });
    }

    /// Whether the last setting of an axis refines the scene's own.
    static bool isFiner(const TradeAxis& axis) {
        return axis.refines && !axis.settings.empty() &&
               (axis.ownSize == 0.0 || axis.settings.back().size < axis.ownSize);
    }

    bool addAxes() {
        std::vector<const TradeSetting*> settings;
        for (const TradeAxis& axis : axes_)
            for (const TradeSetting& setting : axis.settings) settings.push_back(&setting);
        return std::all_of(settings.begin(), settings.end(),
                           [&](const TradeSetting* setting) { return add(*setting); });
    }

    static bool isCombined(const TradeAxis& axis) { return axis.name != presetAxisName && axis.name != bondAxisName; }

    /// For each error that may be allowed, the cheapest setting of each axis that changes the results by no more than
    /// its share of it.
    bool addCombinations() {
        std::vector<std::string> made;
        for (const double error : combinedErrors) {
            std::vector<TradeSetting> cheap;
            for (const TradeAxis& axis : axes_)
                if (const TradeSetting* setting = isCombined(axis)
                                                      ? cheapest(axis, error / static_cast<double>(axes_.size()))
                                                      : nullptr)
                    cheap.push_back(*setting);
            const TradeSetting all = combined(combinationPoint, cheap);
            if (cheap.size() < 2 || std::count(made.begin(), made.end(), all.text)) continue;
            made.push_back(all.text);
            if (!add(all)) return false;
        }
        return true;
    }

    /// The fastest setting of an axis that changes no quantity of the scene's own settings by more than `error`; null
    /// if none is cheaper than the scene's own.
    const TradeSetting* cheapest(const TradeAxis& axis, double error) const {
        const TradePoint& own = trade_.points.front();
        const TradeSetting* best = nullptr;
        double least = own.seconds;
        for (const TradeSetting& setting : axis.settings) {
            const auto point = std::find_if(trade_.points.begin(), trade_.points.end(), [&](const TradePoint& p) {
                return p.axis == setting.axis && p.setting == setting.text;
            });
            if (point == trade_.points.end() || !isCheaper(*point, own) || point->seconds >= least) continue;
            if (largestError(*point, own, trade_.quantities) > error) continue;
            least = point->seconds;
            best = &setting;
        }
        return best;
    }

    const Scene& scene_;
    const TradeSettings& settings_;
    Trade& trade_;
    std::vector<TradeAxis> axes_;
    std::size_t planned_ = 0, done_ = 0;
    double spent_ = 0.0;  // [s] in all runs so far
    double cost_ = 2.0 + combinedErrors.size();  // of all runs, in runs with the scene's own settings
};

}  // namespace

bool measureTrade(const Scene& scene, const TradeSettings& settings, Trade& trade) {
    trade.interrupted = !Measuring(scene, settings, trade).all();
    return !trade.interrupted;
}

}  // namespace keyblock
