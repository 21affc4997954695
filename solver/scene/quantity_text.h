// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Reads the quantities that a scene requests as text, e.g. `max B1.axial_force`,
// `first debonding opening` or `last crown.uy`. The check uses it to find invalid
// quantities before a run, the results to find the column of the history.
#pragma once

#include "solver/scene/event_kinds.h"
#include "solver/scene/scene.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

/// What is read from a run. `Max`, `Min` and `Last` reduce a column of the history to one number; `First` takes its value
/// just before the first event of a given kind. `Count` is the number of events of a kind, `Order` the
/// bolts, joints or blocks that they happened to, in order of the first event of each. The others concern the run as a whole.
enum class QuantityKind { Max, Min, Last, First, Count, Order, EnergyError, FactorOfSafety, Stands };

/// Recorded value: a component of a monitor, or a quantity of a bolt.
struct Subject {
    int monitor = -1;  // index of the monitor; −1: a bolt
    int component = 0;  // 0: ux or the only value; 1: uy; 2: magnitude of the displacement
    int bolt = -1;  // index of the bolt; −1: a monitor
    BoltQuantity boltQuantity = BoltQuantity::AxialForce;

    bool operator==(const Subject&) const = default;
};

struct Quantity {
    QuantityKind kind = QuantityKind::Max;
    int eventKind = -1;  // index into `eventKinds`; only for `First`, `Count` and `Order`
    Subject subject{};  // only for `Max`, `Min`, `Last` and `First`

    bool operator==(const Quantity&) const = default;
};

/// Result of reading the text of a quantity: the quantity, or a message that says what is wrong and what to write
/// instead.
struct QuantityReading {
    std::optional<Quantity> quantity;
    std::string problem;
};

/// Reads `max|min|last MONITOR[.ux|.uy|.u]`, `max|min|last BOLT.QUANTITY`, `first KIND MONITOR[.ux|.uy|.u]`,
/// `count|order KIND`, `energy_error`, `factor_of_safety` and `stands`. Names may contain spaces and dots. If a monitor and a bolt have the same name, the part after the dot distinguishes
/// them.
QuantityReading readQuantity(std::string_view text, const Scene& scene);

/// Number of values that a monitor records: two for a point, otherwise one.
int monitorValueCount(const Monitor& monitor);

}  // namespace keyblock
