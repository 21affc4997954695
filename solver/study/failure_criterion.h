// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// What counts as failure of a case, read from text such as `max key.u > 0.05 or lost
// bolt`.
#pragma once

#include "solver/results/quantity.h"
#include "solver/scene/scene.h"

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

/// One condition: a comparison of a quantity with a number, or a lost bolt.
struct FailureTerm {
    enum class Compare { Above, AtLeast, Below, AtMost };
    std::string quantity;  // empty: a bolt ruptured or was lost
    Compare compare = Compare::Above;
    double number = 0.0;
    bool negated = false;
};

/// Fails if all terms of any of the lists are met.
struct FailureCriterion {
    std::vector<std::vector<FailureTerm>> anyOf;
};

struct FailureReading {
    std::optional<FailureCriterion> criterion;
    std::string problem, remedy;
};

/// Reads a criterion; each of its quantities is read for `scene`.
FailureReading readFailure(std::string_view text, const Scene& scene);

/// Quantities that the criterion compares.
std::vector<std::string> quantitiesOf(const FailureCriterion& criterion);

/// Whether a bolt ruptured or was lost in a run.
bool lostBolt(std::span<const Event> events);

/// Whether a case fails. None if this depends on a quantity that has no value.
/// \param value the value of a quantity; none if it has none.
std::optional<bool> fails(const FailureCriterion& criterion,
                          const std::function<std::optional<double>(const std::string&)>& value, bool lostBolt);

}  // namespace keyblock
