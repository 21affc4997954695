// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// A scene requests numbers in words: `max B1.axial_force`, `first debonding
// opening`, `last crown.uy`. This reads such a text against the scene that holds
// it, so that the check finds a wrong one before a run and the results find the
// right column after it.
#pragma once

#include "solver/scene/event_kinds.h"
#include "solver/scene/scene.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

/// How a quantity makes one number of a column of the history.
enum class Reduction { Max, Min, Last, First };

/// One value of a scene: a component of a monitor, or a quantity of a bolt.
struct Subject {
    int monitor = -1;  // index, or −1 for a bolt
    int component = 0;  // 0: ux or the only value; 1: uy
    int bolt = -1;  // index, or −1 for a monitor
    BoltQuantity boltQuantity = BoltQuantity::AxialForce;

    bool operator==(const Subject&) const = default;
};

struct Quantity {
    Reduction reduction = Reduction::Max;
    int eventKind = -1;  // of `First`: index into `eventKinds`
    Subject subject{};

    bool operator==(const Quantity&) const = default;
};

/// What became of a text: the quantity, or what is wrong with it and what to write instead.
struct QuantityReading {
    std::optional<Quantity> quantity;
    std::string problem;
};

/// Reads `max|min|last MONITOR[.ux|.uy]`, `max|min|last BOLT.QUANTITY` and `first KIND MONITOR[.ux|.uy]`.
/// Names may hold spaces and dots; where a monitor and a bolt share one, the part after the dot tells them apart.
QuantityReading readQuantity(std::string_view text, const Scene& scene);

/// Number of values that a monitor gives: two for a point, else one.
int monitorValueCount(const Monitor& monitor);

}  // namespace keyblock
