// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Draws contact forces on paper. Length and width of a line both show the magnitude, so
// that larger forces look thicker even where lines overlap. Colour and shape both show
// the kind of contact, so that it can be recognised in greyscale prints.
#pragma once

#include "ui/figure/column.h"
#include "ui/figure/ink.h"
#include "ui/picture/section/contact_lines.h"

namespace keyblock {

class ContactPainter {
public:
    /// \param length length of the longest line on paper [mm].
    ContactPainter(const ContactScale& scale, double length) : scale_(scale), length_(length) {}

    /// Draws a line centred at `at` [mm, y downwards] in the direction of `force` [display unit], clipped to `frame`.
    void draw(Ink& ink, ContactKind kind, const Point& at, const Point& force, const Box& frame) const;

    /// Length and width [mm] on paper of the line that represents a force.
    double lengthOf(double force) const;
    double widthOf(double force) const;

private:
    const ContactScale& scale_;
    double length_;
};

/// Creates the legend of contact forces for a column of width `width` [mm].
/// \param length length of the longest line [mm].
/// \pre the field outlives the item.
ColumnItem contactItem(const ContactField& field, double length, double width);

}  // namespace keyblock
