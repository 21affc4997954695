// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/trade/trade_folder.h"

#include "solver/files/atomic_file.h"
#include "solver/files/run_store/build_id.h"
#include "solver/files/scene/scene_file.h"
#include "solver/files/text_file.h"
#include "solver/run/write_error.h"
#include "solver/trade/trade_page.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstdint>
#include <system_error>

namespace keyblock {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr const char* pointsName = "points.json";
constexpr std::uint64_t mostBytes = std::uint64_t{64} << 20;  // of this file
constexpr std::array<std::string_view, 4> names{"points.json", "trade.csv", "trade.md", "trade.svg"};

Json json(const Measurement& measurement) {
    return {{"value", measurement.value ? Json(*measurement.value) : Json()},
            {"problem", measurement.problem},
            {"order", measurement.order}};
}

Measurement measurementOf(const Json& json) {
    Measurement result;
    if (!json.at("value").is_null()) result.value = json.at("value").get<double>();
    result.problem = json.at("problem").get<std::string>();
    result.order = json.at("order").get<std::vector<std::string>>();
    return result;
}

Json json(const TradePoint& point) {
    Json values = Json::array();
    for (const Measurement& value : point.values) values.push_back(json(value));
    return {{"axis", point.axis},
            {"setting", point.setting},
            {"set", point.overrides},
            {"preset", point.preset},
            {"values", values},
            {"wall_s", point.seconds},
            {"steps", point.steps},
            {"passes", point.passes},
            {"factorizations", point.work.factorizations},
            {"full_factorizations", point.work.fullFactorizations},
            {"ranks", point.work.ranks},
            {"solves", point.work.solves},
            {"products", point.work.products},
            {"sweeps", point.work.sweeps},
            {"unknowns", point.unknowns},
            {"memory", point.memory},
            {"blocks_moved", point.blocksMoved},
            {"failure", point.failure},
            {"threads", point.threads},
            {"size", point.size}};
}

TradePoint pointOf(const Json& json) {
    TradePoint point;
    json.at("axis").get_to(point.axis);
    json.at("setting").get_to(point.setting);
    json.at("set").get_to(point.overrides);
    json.at("preset").get_to(point.preset);
    for (const Json& value : json.at("values")) point.values.push_back(measurementOf(value));
    json.at("wall_s").get_to(point.seconds);
    json.at("steps").get_to(point.steps);
    json.at("passes").get_to(point.passes);
    json.at("factorizations").get_to(point.work.factorizations);
    json.at("full_factorizations").get_to(point.work.fullFactorizations);
    json.at("ranks").get_to(point.work.ranks);
    json.at("solves").get_to(point.work.solves);
    json.at("products").get_to(point.work.products);
    json.at("sweeps").get_to(point.work.sweeps);
    json.at("unknowns").get_to(point.unknowns);
    json.at("memory").get_to(point.memory);
    json.at("blocks_moved").get_to(point.blocksMoved);
    json.at("failure").get_to(point.failure);
    json.at("threads").get_to(point.threads);
    json.at("size").get_to(point.size);
    return point;
}

/// Refuses to write into a folder with anything but a trade.
void checkContents(const fs::path& folder) {
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (!std::count(names.begin(), names.end(), entry.path().filename().string()))
            throw CannotWrite("cannot write " + folder.string() + ": it contains " + entry.path().filename().string() +
                              ", which is not part of a trade; choose an empty folder or a new one");
}

}  // namespace

TradeFolder::TradeFolder(fs::path folder, const Scene& scene) : folder_(std::move(folder)), scene_(sceneHash(scene)) {
    std::error_code error;
    fs::create_directories(folder_, error);
    if (error || !fs::is_directory(folder_)) throw CannotWrite(cannotWriteText(folder_, error.value()));
    checkContents(folder_);
    if (!fs::exists(folder_ / pointsName)) return;
    const std::string shown = (folder_ / pointsName).string();
    try {
        const Json json = Json::parse(
            readTextFile(folder_ / pointsName, {mostBytes, "choose another folder", "choose another folder"}));
        if (json.at("scene_hash") != scene_)
            throw CannotWrite("cannot write " + folder_.string() +
                              ": it holds the trade of another scene; choose another folder");
        if (json.at("build") != buildId())
            throw CannotWrite("cannot write " + folder_.string() +
                              ": it holds a trade by another version of the program; choose another folder");
        json.at("quantities").get_to(quantities_);
        for (const Json& point : json.at("points")) points_.push_back(pointOf(point));
    } catch (const Json::exception&) {
        throw CannotWrite("cannot write " + folder_.string() + ": " + shown + " is damaged; choose another folder");
    }
    const auto fits = [&](const TradePoint& point) { return point.values.size() == quantities_.size(); };
    if (!std::all_of(points_.begin(), points_.end(), fits))
        throw CannotWrite("cannot write " + folder_.string() + ": " + shown + " is damaged; choose another folder");
}

bool TradeFolder::holdsTrade(const fs::path& folder) {
    std::error_code error;
    return fs::is_regular_file(folder / pointsName, error);
}

std::optional<TradePoint> TradeFolder::known(const TradeSetting& setting) const {
    const auto found = std::find_if(points_.begin(), points_.end(), [&](const TradePoint& point) {
        return point.axis == setting.axis && point.setting == setting.text;
    });
    return found == points_.end() ? std::nullopt : std::optional(*found);
}

void TradeFolder::keep(const TradePoint& point, const std::vector<std::string>& quantities) {
    points_.push_back(point);
    quantities_ = quantities;
    Json list = Json::array();
    for (const TradePoint& kept : points_) list.push_back(json(kept));
    const Json all{{"scene_hash", scene_}, {"build", buildId()}, {"quantities", quantities_}, {"points", list}};
    writeAtomically(folder_ / pointsName, [&](std::ostream& out) { out << all.dump(1) << '\n'; });
}

void TradeFolder::writeTables(const Trade& trade, const Scene& scene) const {
    writeAtomically(folder_ / "trade.csv", [&](std::ostream& out) { writeTradeTable(trade, scene, out); });
    writeAtomically(folder_ / "trade.md", [&](std::ostream& out) { out << tradePage(trade, scene); });
}

}  // namespace keyblock
