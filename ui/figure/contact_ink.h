// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Forces of contacts on paper. Size tells by length and by width, so that columns
// of lines that run into one another still grow thicker where they bear more; the
// kind tells by colour and by form, which a print in grey keeps.
#pragma once

#include "ui/figure/column.h"
#include "ui/figure/ink.h"
#include "ui/picture/contact_lines.h"

namespace keyblock {

class ContactInk {
public:
    /// The longest line is `length` on paper [mm].
    ContactInk(const ContactScale& scale, double length) : scale_(scale), length_(length) {}

    /// A line about `at` [mm], y downwards, along `force` [unit shown], cut off at the frame.
    void draw(Ink& ink, ContactKind kind, const Point& at, const Point& force, const Box& frame) const;

    /// Length on paper [mm] and width of the line of a force of this size.
    double lengthOf(double force) const;
    double widthOf(double force) const;

private:
    const ContactScale& scale_;
    double length_;
};

/// What explains them, for a column of `width` [mm]; the field must outlive it. \param length of the longest line [mm].
ColumnItem contactItem(const ContactField& field, double length, double width);

}  // namespace keyblock
