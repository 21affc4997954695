// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Forces between blocks as lines: each through its contact, along the resultant of
// normal and shear force, longer and thicker for larger forces. Among many blocks, only
// the largest of each neighbourhood is drawn, and the legend says so.
#pragma once

#include "geometry/polygon.h"
#include "solver/results/results.h"

#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

/// The user's word for this display.
inline constexpr std::string_view contactWord = "contact-forces";

/// Open contacts carry no force and have no line. A bonded one may be in tension.
enum class ContactKind { Locked, Sliding, Bonded, Pulled };

struct ContactLine {
    ContactKind kind = ContactKind::Locked;
    Point place{0.0, 0.0};  // [m], as drawn
    Point force{0.0, 0.0};  // on block a, in the unit shown
};

/// Values shared by all frames of a run.
struct ContactScale {
    double longest = 0.0;  // force of the longest line, in the unit shown; longer lines are clipped to it
    double largest = 0.0;  // of the run, in the unit shown
    double spacing = 0.0;  // side of a square as large as an average block [m]
    std::vector<ContactKind> kinds;  // present in the run, in their order
};

struct ContactField {
    ContactScale scale;
    std::vector<ContactLine> lines;  // the largest last
    double largest = 0.0;  // of this frame, in the unit shown
    double thickness = 1.0;  // thickness of rock that the forces refer to [m]
    std::string unit = "kN";
    std::vector<std::string> notes;
};

/// The line of a contact force at its current position.
ContactLine contactLine(const ContactFrame& contact);

/// Adds the contact forces of a frame to the scale, except for its `longest` and `spacing`.
void widen(ContactScale& scale, const Frame& frame, std::vector<double>& sizes);

/// Upper bound of all contact forces except the largest, which make up 2 % of their sum, rounded up; 0 if there are
/// none.
double longestOf(std::vector<double> sizes);

// Sizes on paper [mm].

/// Length of the longest line if blocks are `block` wide on average: larger than a dot, and less than half the
/// picture.
double longestContactLine(double block);

/// Length and width of the line of a force of this size, if the longest is `longest`.
double contactLength(const ContactScale& scale, double force, double longest);
double contactWidth(const ContactScale& scale, double force, double longest);

/// All contacts that carry a force. `places` are the contacts' positions as drawn [m], one row each.
ContactField contactField(const ContactScale& scale, const Frame& frame, const std::vector<Point>& places);

/// Those within a window, thinned out if there are many, with a note on how many are drawn.
ContactField seenWithin(const ContactField& field, const Box& window);

}  // namespace keyblock
