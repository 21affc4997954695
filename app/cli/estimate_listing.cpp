// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/estimate_listing.h"

#include "app/cli/text_table.h"
#include "solver/scene/visible_text.h"

#include <cmath>

namespace keyblock::cli {

namespace {

TextRow estimateRow(const QuantityEstimate& one) {
    const bool isOrder = one.error && !one.value;
    TextRow row{visibleText(one.quantity), one.value ? shown(*one.value) : "–", "", "", visibleText(one.remark)};
    if (!one.remark.empty() || !one.error) return row;
    if (isOrder) {
        row[3] = shown(100.0 * *one.error) + " %";
        row[4] = *one.error > 0.0 ? "of the order differs" : "same order";
        return row;
    }
    row[2] = "± " + shown(*one.error);
    if (*one.value != 0.0) row[3] = shown(100.0 * *one.error / std::abs(*one.value)) + " %";
    return row;
}

}  // namespace

std::string errorEstimateLines(const ErrorEstimate& estimate) {
    std::string runs;
    for (const std::string& text : estimate.refinements) runs += (runs.empty() ? "" : "; ") + text;
    std::vector<TextRow> rows;
    for (const QuantityEstimate& one : estimate.quantities) rows.push_back(estimateRow(one));
    const std::string from = runs.empty() ? "" : ", from runs with " + visibleText(runs);
    return "\nestimated errors" + from + "\n" +
           textTable(
               {{"quantity"}, {"value (SI)", Align::Right}, {"error", Align::Right}, {"share", Align::Right}, {""}},
               rows);
}

}  // namespace keyblock::cli
