// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Forces between blocks as lines: each through its contact, along normal and shear
// force together, longer and thicker the larger it is. Where blocks are many, the
// largest of each neighbourhood stands for it, and the legend says so.
#pragma once

#include "geometry/polygon.h"
#include "solver/results/results.h"

#include <string>
#include <string_view>
#include <vector>

namespace keyblock {

/// What a person asks for to see them.
inline constexpr std::string_view contactWord = "contact-forces";

/// Open contacts bear nothing and have no line. A bonded one may be pulled at.
enum class ContactKind { Locked, Sliding, Bonded, Pulled };

struct ContactLine {
    ContactKind kind = ContactKind::Locked;
    Point place{0.0, 0.0};  // [m], as drawn
    Point force{0.0, 0.0};  // on block a, in the unit shown
};

/// What all frames of a run share.
struct ContactScale {
    double longest = 0.0;  // force that the longest line stands for, in the unit shown; larger ones are cut to it
    double largest = 0.0;  // of the run, in the unit shown
    double spacing = 0.0;  // side of a square as large as a block is on average [m]
    std::vector<ContactKind> kinds;  // that the run has, in their order
};

struct ContactField {
    ContactScale scale;
    std::vector<ContactLine> lines;  // the largest last
    double largest = 0.0;  // of this frame, in the unit shown
    double thickness = 1.0;  // of rock that the forces act over [m]
    std::string unit = "kN";
    std::vector<std::string> notes;
};

/// A contact that bears something as a line where it is now.
ContactLine contactLine(const ContactFrame& contact);

/// Adds what a frame's contacts bear to the scale, but for its `longest` and `spacing`.
void widen(ContactScale& scale, const Frame& frame, std::vector<double>& sizes);

/// The force that all but the largest 2 % of what the contacts bear together stay below, rounded up; 0 of none.
double longestOf(std::vector<double> sizes);

// Sizes on paper [mm].

/// Of the longest line, where a block is `block` wide on average: neither a dot nor across half the picture.
double longestContactLine(double block);

/// Length and width of the line of a force of this size, where the longest is `longest`.
double contactLength(const ContactScale& scale, double force, double longest);
double contactWidth(const ContactScale& scale, double force, double longest);

/// Every contact that bears something. `places` are the contacts' places as drawn [m], a row each.
ContactField contactField(const ContactScale& scale, const Frame& frame, const std::vector<Point>& places);

/// Those within a window, thinned out where they are many, with a note that says how many are drawn.
ContactField seenWithin(const ContactField& field, const Box& window);

}  // namespace keyblock
