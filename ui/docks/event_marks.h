// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Marks of events on the screen, in px: shape and colour both show the kind. Kinds that
// look alike to the user share a mark and a count.
#pragma once

#include "solver/results/event_groups.h"

#include <QPointF>
#include <QString>

class QPainter;

namespace keyblock {

struct Theme;

QString nameOf(EventGroup group);  // "debonding"

/// The mark centred at `at`, in the size given by the look.
void drawEventMark(QPainter& painter, const Theme& theme, EventGroup group, const QPointF& at);
/// The same for one kind: a joint opening has its own mark in lists.
void drawEventMark(QPainter& painter, const Theme& theme, EventKind kind, const QPointF& at);

}  // namespace keyblock
