// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/files/run_store/stored_estimate.h"

#include "solver/files/run_store/run_schema.h"
#include "solver/files/run_store/store_reading.h"
#include "solver/run/write_error.h"

#include <nlohmann/json.hpp>

namespace keyblock {

namespace {

using Json = nlohmann::ordered_json;

constexpr const char* key = "estimated_errors";  // in table about

Json json(const std::optional<double>& number) { return number ? Json(*number) : Json(); }

std::optional<double> numberOf(const Json& json) {
    return json.is_null() ? std::nullopt : std::optional(json.get<double>());
}

std::string textOf(const ErrorEstimate& estimate) {
    Json quantities = Json::array();
    for (const QuantityEstimate& one : estimate.quantities)
        quantities.push_back({{"quantity", one.quantity},
                              {"value", json(one.value)},
                              {"error", json(one.error)},
                              {"remark", one.remark}});
    return Json{{"refinements", estimate.refinements}, {"quantities", quantities}}.dump(-1, ' ', false,
                                                                                        Json::error_handler_t::replace);
}

ErrorEstimate estimateOf(const std::string& text) {
    const Json json = Json::parse(text);
    ErrorEstimate estimate;
    json.at("refinements").get_to(estimate.refinements);
    for (const Json& one : json.at("quantities"))
        estimate.quantities.push_back({one.at("quantity").get<std::string>(), numberOf(one.at("value")),
                                       numberOf(one.at("error")), one.at("remark").get<std::string>()});
    return estimate;
}

}  // namespace

void storeEstimate(const std::filesystem::path& store, const ErrorEstimate& estimate) {
    try {
        const sqlite::Database database(store, sqlite::Access::Write);
        sqlite::Statement insert(database,
                                 "INSERT OR REPLACE INTO about (key, value, checksum) VALUES (?1, ?2, "
                                 "row_checksum(?1, ?2))");
        insert.bind(key).bind(textOf(estimate)).run();
    } catch (const sqlite::Error& error) {
        throw CannotWrite("cannot write " + store.string() + ": " + error.what());
    }
}

std::optional<ErrorEstimate> storedEstimate(const std::filesystem::path& store) {
    using namespace store_reading;
    const sqlite::Database database = opened(store);
    try {
        requireRunStore(database, store);
        sqlite::Statement rows(database, selectChecked(run_schema::aboutColumns, "FROM about WHERE key=?"));
        rows.bind(key);
        if (!nextChecked(rows, 2)) return std::nullopt;
        return estimateOf(rows.text(1));
    } catch (const sqlite::Error&) {
        cannotRead(store, damaged);
    } catch (const Json::exception&) {
        cannotRead(store, damaged);
    }
}

}  // namespace keyblock
