// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Marks of events on the screen: both shape and colour show the kind of event. Sizes in
// px.
#pragma once

#include "solver/scene/event_kinds.h"

#include <QPointF>
#include <QString>

class QPainter;

namespace keyblock {

struct Theme;

QString nameOf(EventGroup group);  // e.g. "yield"
QString nameOf(EventKind kind);  // e.g. "plastic hinge"

/// Draws the mark at its on-screen size, centred at `at`.
void drawEventMark(QPainter& painter, const Theme& theme, EventMark mark, const QPointF& at);

}  // namespace keyblock
