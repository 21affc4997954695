// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Marks of events on the screen, in px: shape and colour both show the kind.
#pragma once

#include "solver/scene/event_kinds.h"

#include <QPointF>
#include <QString>

class QPainter;

namespace keyblock {

struct Theme;

QString nameOf(EventGroup group);  // "yield"
QString nameOf(EventKind kind);  // "plastic hinge"

/// The mark centred at `at`, in the size given by the look.
void drawEventMark(QPainter& painter, const Theme& theme, EventMark mark, const QPointF& at);

}  // namespace keyblock
