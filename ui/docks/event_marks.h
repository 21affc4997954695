// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Marks of events on the screen, in px: shape and colour both tell the kind. Kinds
// that a person does not tell apart at a glance share a mark and a count.
#pragma once

#include "solver/results/event_groups.h"

#include <QPointF>
#include <QString>

class QPainter;

namespace keyblock {

struct Theme;

QString nameOf(EventGroup group);  // "debonding"

/// The mark about `at`, as large as the look's page says.
void drawEventMark(QPainter& painter, const Theme& theme, EventGroup group, const QPointF& at);
/// The same of one kind: a joint that opens has a mark of its own in lists.
void drawEventMark(QPainter& painter, const Theme& theme, EventKind kind, const QPointF& at);

}  // namespace keyblock
