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

double legendArrowsHeight(const ArrowField& field, double width);  // [px]
void paintLegendArrows(QPainter& painter, const Theme& theme, const ArrowField& field, const QPointF& at, double width);

double legendContactsHeight(const ContactField& field, double width);  // [px]
/// \param scale scale of the view [px/m].
void paintLegendContacts(QPainter& painter, const Theme& theme, const ContactField& field, double scale,
                         const QPointF& at, double width);

}  // namespace keyblock
