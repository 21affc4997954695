// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Marks of events on the screen, in px: shape and colour both tell the kind. Kinds
// that a person does not tell apart at a glance share a mark and a count.
#pragma once

#include "solver/results/results.h"

#include <QPointF>
#include <QString>

#include <array>

class QPainter;

namespace keyblock {

struct Theme;

/// What the time line tells apart.
enum class EventGroup { Slip, Debonding, Yield, Rupture, Plate, PulledOut, Falls };
inline constexpr std::size_t eventGroups = 7;

/// Restick belongs to debonding, hinges to yield, an opened joint to slip, a collapse to falls.
EventGroup groupOf(EventKind kind);
/// The kinds of a group.
std::array<EventKind, 3> kindsOf(EventGroup group);  // the last ones repeat where there are fewer
QString nameOf(EventGroup group);  // "debonding"

/// The mark about `at`, as large as the look's page says.
void drawEventMark(QPainter& painter, const Theme& theme, EventGroup group, const QPointF& at);

}  // namespace keyblock
