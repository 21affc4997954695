// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Forces of contacts on paper. Length and width both show the magnitude, so that
// overlapping lines still look thicker where forces are larger; colour and shape show
// the kind, also in a grey print.
#pragma once

#include "ui/figure/column.h"
#include "ui/figure/ink.h"
#include "ui/picture/contact_lines.h"

namespace keyblock {

class ContactPainter {
public:
    /// The longest line is `length` on paper [mm].
    ContactPainter(const ContactScale& scale, double length) : scale_(scale), length_(length) {}

    /// A line centred at `at` [mm], y downwards, along `force` [unit shown], clipped at the frame.
    void draw(Ink& ink, ContactKind kind, const Point& at, const Point& force, const Box& frame) const;

    /// Length on paper [mm] and width of the line of a force of this size.
    double lengthOf(double force) const;
    double widthOf(double force) const;

private:
    const ContactScale& scale_;
    double length_;
};

/// The legend, for a column of `width` [mm]; the field must outlive it. \param length of the longest line [mm].
ColumnItem contactItem(const ContactField& field, double length, double width);

}  // namespace keyblock
