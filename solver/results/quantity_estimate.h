// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Estimated errors of quantities of interest, from runs with finer settings.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace keyblock {

struct QuantityEstimate {
    std::string quantity;  // as in the scene's `quantities`
    std::optional<double> value;  // SI; none for an order
    std::optional<double> error;  // as `value`; of an order, the share that is missing or out of order
    std::string remark;  // reason why there is no value or no error; empty: there are both

    bool operator==(const QuantityEstimate&) const = default;
};

struct ErrorEstimate {
    std::vector<std::string> refinements;  // what each of the finer runs changed, e.g. "half the time step"
    std::vector<QuantityEstimate> quantities;

    bool operator==(const ErrorEstimate&) const = default;
};

}  // namespace keyblock
