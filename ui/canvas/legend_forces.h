// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The legend of arrows and contact forces: length scale, kinds, and notes on what is
// omitted.
#pragma once

#include "ui/picture/section/section.h"

#include <QPointF>

class QPainter;

namespace keyblock {

struct Theme;

/// Notes below an entry; a low canvas has no room for them.
enum class ForceNotes { Shown, Omitted };

double legendArrowsHeight(const ArrowField& field, double width, ForceNotes notes);  // [px]
void paintLegendArrows(QPainter& painter, const Theme& theme, const ArrowField& field, const QPointF& at, double width,
                       ForceNotes notes);

double legendContactsHeight(const ContactField& field, double width, ForceNotes notes);  // [px]
/// \param scale scale of the view [px/m].
void paintLegendContacts(QPainter& painter, const Theme& theme, const ContactField& field, double scale,
                         const QPointF& at, double width, ForceNotes notes);

}  // namespace keyblock
