// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The values of each case. They depend only on the study and on the number of the case,
// not on the order in which cases are made.
#pragma once

#include "solver/study/study.h"

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

/// Number that identifies the draws of a parameter or fault by its name (64-bit FNV-1a).
std::int64_t streamOf(std::string_view name);

/// Number of combinations of a full factorial plan; `mostCases` + 1 if there are more cases than that.
long combinationsOf(const Study& study);

/// The plan of a checked study.
class CasePlan {
public:
    explicit CasePlan(const Study& study);

    long cases() const { return cases_; }
    /// Cell of each parameter of a case, counted from 1: a number, a flag or a text.
    std::vector<std::string> row(long number) const;

private:
    std::string cell(std::size_t parameter, long index) const;
    double position(std::size_t parameter, long index) const;

    const Study& study_;
    long cases_ = 0;
    std::vector<std::vector<std::uint32_t>> strata_;  // of a Latin hypercube: by parameter, then case
};

/// Cell of a listed value: its text without the quotes of JSON.
std::string cellOf(const std::string& jsonValue);

/// What a case sets, as for `--set`: one `path=value` for each path of each parameter.
/// \param row the cells of the case, in the order of the parameters.
std::vector<std::string> overridesOf(const Study& study, const std::vector<std::string>& row);

}  // namespace keyblock
