// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Contact forces drawn as lines: each line passes through its contact along the
// resultant of normal and shear force, and is longer and thicker for larger forces. If
// there are very many contacts, only the largest force of each neighbourhood is drawn,
// and the legend says so.
#pragma once

#include "geometry/polygon.h"
#include "solver/results/results.h"

#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

/// Word that the user types to show contact forces.
inline constexpr std::string_view contactWord = "contact-forces";

/// State of a contact that carries a force. Open contacts carry no force, so they have no line. `Pulled` is a bonded
/// contact in tension.
enum class ContactKind { Locked, Sliding, Bonded, Pulled };

struct ContactLine {
    ContactKind kind = ContactKind::Locked;
    Point place{0.0, 0.0};  // position as drawn [m]
    Point force{0.0, 0.0};  // force on block a, in the display unit
};

/// Scale of contact forces, the same for all frames of a run.
struct ContactScale {
    double longest = 0.0;  // force drawn as the longest line, in the display unit; larger forces are drawn no longer
    double largest = 0.0;  // largest force of the run, in the display unit
    double spacing = 0.0;  // side of a square with the average area of a block [m]
    std::vector<ContactKind> kinds;  // kinds that occur in the run, in the order of the enum
};

struct ContactField {
    ContactScale scale;
    std::vector<ContactLine> lines;  // in ascending order of force
    double largest = 0.0;  // largest force of this frame, in the display unit
    double thickness = 1.0;  // out-of-plane thickness to which the forces refer [m]
    std::string unit = "kN";
    std::vector<std::string> notes;
};

/// The line for a contact, placed at the actual position of the contact.
ContactLine contactLine(const ContactFrame& contact);

/// Updates `scale.largest` and `scale.kinds` with the contact forces of a frame.
/// \param sizes list to which the magnitudes of these forces are appended, in the display unit.
void widen(ContactScale& scale, const Frame& frame, std::vector<double>& sizes);

/// Value of `ContactScale::longest` for forces with the magnitudes `sizes`; 0 if there are no forces. The value is the
/// smallest magnitude such that all larger ones add up to at most 2 % of the total, rounded up to a round number.
double longestOf(std::vector<double> sizes);

// Lengths and widths on paper [mm].

/// Length of the longest line, which depends on the average width `block` of a block on paper. The length is limited so
/// that the line is longer than a dot and shorter than half the figure.
double longestContactLine(double block);

/// Length and width of the line for a force of magnitude `force` [display unit]. \param longest length of the longest
/// line.
double contactLength(const ContactScale& scale, double force, double longest);
double contactWidth(const ContactScale& scale, double force, double longest);

/// Lines of all contacts that carry a force.
/// \param places positions of the contacts as drawn [m], one for each contact of the frame, in the same order.
ContactField contactField(const ContactScale& scale, const Frame& frame, const std::vector<Point>& places);

/// The lines of the contacts within `window` [m]. Forces too small to be visible are omitted. If there are very many
/// lines, they are thinned out, and a note says how many are drawn.
ContactField seenWithin(const ContactField& field, const Box& window);

}  // namespace keyblock
