// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver/verify/extremes/extreme_axes.h"

#include "solver/scene/number_text.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace keyblock {

namespace {

template <double Conditions::*Member>
void set(Conditions& conditions, double value) {
    conditions.*Member = value;
}

template <double Conditions::*Member>
double get(const Conditions& conditions) {
    return conditions.*Member;
}

/// An axis of one number.
template <double Conditions::*Member>
ExtremeAxis numberAxis(std::string name, std::string title, std::string unit, std::vector<double> values, double least,
                       double most, bool logarithmic, std::string reason) {
    return {std::move(name), std::move(title), std::move(unit), std::move(values), least, most,
            logarithmic,     set<Member>,      get<Member>,     std::move(reason)};
}

template <typename Enum, Enum Conditions::*Member>
ExtremeAxis choiceAxis(std::string name, std::string title, std::vector<std::string> words, std::string reason) {
    ExtremeAxis axis{std::move(name),
                     std::move(title),
                     "",
                     {},
                     0.0,
                     static_cast<double>(words.size()) - 1e-9,
                     false,
                     [](Conditions& c, double value) { c.*Member = static_cast<Enum>(static_cast<int>(value)); },
                     [](const Conditions& c) { return static_cast<double>(static_cast<int>(c.*Member)); },
                     std::move(reason),
                     {}};
    for (std::size_t i = 0; i < words.size(); ++i) axis.values.push_back(static_cast<double>(i));
    axis.words = std::move(words);
    return axis;
}

template <Integration Scheme>
ExtremeAxis stepAxis(const char* name, const char* scheme, const std::string& reason) {
    return {name,
            std::string("Time step, ") + scheme,
            "s",
            {1e-12, 1e-9, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3, 3e-3, 1e-2, 3e-2, 0.1, 0.3, 1.0, 10.0},
            1e-6,
            3e-2,
            true,
            [](Conditions& c, double value) {
                c.timeStep = value;
                c.integration = Scheme;
            },
            get<&Conditions::timeStep>,
            reason};
}

const std::string digits =
    "A double has 16 digits: positions are taken relative to an origin in the scene, but the "
    "coordinates of the file themselves are rounded to 1e-16 of their size.";

std::vector<ExtremeAxis> sectionRows() {
    return {
        numberAxis<&Conditions::offset>("offset", "Coordinates", "m",
                                        {-1e6, 0.0, 1.0, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e12, 1e15, 1e18},
                                        1.0, 1e6, true, digits),
        numberAxis<&Conditions::turn>("turn", "Turn of the scene", "°",
                                      {0.0, 1e-9, 1e-3, 1.0, 30.0, 45.0, 90.0, 180.0, 270.0, -123.4, 360.0, 3601.0},
                                      0.0, 360.0, false, "No direction is preferred: there is no edge."),
        {"mirror",
         "Mirror image",
         "",
         {0.0, 1.0},
         0.0,
         2.0 - 1e-9,
         false,
         [](Conditions& c, double value) { c.mirrored = value >= 1.0; },
         [](const Conditions& c) { return c.mirrored ? 1.0 : 0.0; },
         "A mirrored scene has the mirrored result: there is no edge.",
         {"as drawn", "mirrored"}},
        numberAxis<&Conditions::size>(
            "size", "Size of the block", "m", {1e-9, 1e-6, 1e-4, 1e-3, 1e-2, 0.1, 1.0, 10.0, 100.0, 1e3, 1e4, 1e6},
            1e-2, 100.0, true,
            "Strain under its own weight grows with the size, ρgL/E; small strains are assumed. Below, "
            "automatic tolerances in metres are no longer small compared with the block."),
        numberAxis<&Conditions::ratio>(
            "size-ratio", "Ratio of block sizes", "", {2.5, 5.0, 10.0, 100.0, 1e3, 1e4, 1e5, 1e6, 1e8, 1e10}, 2.5, 1e4,
            true, "Corners closer than the geometric tolerance, 1e-9 of the scene, are one point."),
        numberAxis<&Conditions::ratio>("sliver-angle", "Angle of a sliver", "°",
                                       {45.0, 20.0, 10.0, 1.0, 0.1, 0.01, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8, 1e-10}, 0.05,
                                       45.0, true, "A sliver thinner than the geometric tolerance has no area."),
        numberAxis<&Conditions::ratio>(
            "gap", "Gap between parallel faces over the size of the block", "",
            {0.0, 1e-15, 1e-12, 1e-9, 1e-6, 1e-4, 1e-3, 0.01, 0.05, 0.09}, 1e-6, 0.05, true,
            "A gap below the geometric tolerance is closed. A static stage whose blocks move by "
            "more than `until.move` is reported as displaced."),
        numberAxis<&Conditions::ratio>(
            "distance", "Distance from a joint, a wall or an edge", "m",
            {1.0, 0.3, 0.1, 0.03, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6, 1e-8, 1e-10, 1e-12, 0.0, -1e-12, -1e-3}, 1e-3, 1.0,
            true,
            "The cut joins points that are closer than its tolerance; a bolt on a joint belongs to "
            "neither block."),
        numberAxis<&Conditions::ratio>("number", "Number of blocks or joints", "", {1, 2, 3, 5, 10, 20, 50, 100, 150},
                                       1, 40, true,
                                       "Time and memory; the loads of all blocks add up in the lowest contacts."),
        numberAxis<&Conditions::ratio>("bolts", "Number of bolts", "", {1, 2, 3, 5, 10, 20, 40, 80}, 1, 12, true,
                                       "Time: each failure is located by itself."),
        numberAxis<&Conditions::ratio>("opening", "Opening of a joint across a bolt", "m",
                                       {1e-9, 1e-6, 1e-4, 1e-3, 0.01, 0.1, 0.2, 0.5, 0.8, 0.95, 0.999, 1.001, 1.5, 3.0},
                                       1e-4, 1.5, true, "Past 1 m the bolt has left its hole."),
        numberAxis<&Conditions::ratio>("cell-size", "Size of cells", "m",
                                       {4.0, 2.0, 1.0, 0.5, 0.25, 0.2, 0.1, 1e-3, 1e-5}, 0.25, 4.0, true,
                                       "A block may have at most a million cells."),
        numberAxis<&Conditions::ratio>("number-of-steps", "Steps at rest", "", {1, 10, 100, 1e3, 1e4, 1e5, 1e6}, 1, 1e3,
                                       true, "Time; sleeping blocks cost nothing."),
        numberAxis<&Conditions::thickness>("thickness", "Thickness of the section", "m",
                                           {1e-9, 1e-6, 1e-3, 0.1, 1.0, 10.0, 1e3, 1e6, 1e7}, 0.1, 10.0, true,
                                           "Thicknesses from 1e-6 to 1e6 m are accepted."),
        choiceAxis<Plane, &Conditions::plane>("plane", "Plane stress or strain", {"stress", "strain"}, "No edge."),
        {"invalid",
         "Invalid values",
         "",
         {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20},
         0.0,
         20.99,
         false,
         set<&Conditions::ratio>,
         get<&Conditions::ratio>,
         "The check refuses values that have no meaning, all at once, with their place.",
         {"none",
          "a corner at NaN",
          "a corner at infinity",
          "density NaN",
          "density 0",
          "Young's modulus infinite",
          "Young's modulus negative",
          "Poisson's ratio 0.5",
          "gravity NaN",
          "a block without area",
          "a block of two corners",
          "a block that crosses itself",
          "a corner given twice",
          "blocks that overlap",
          "tolerance NaN",
          "penalty ratio 0",
          "friction angle 90°",
          "an unknown material",
          "a support in no block",
          "a negative limit",
          "thickness infinite"}},
    };
}

std::vector<ExtremeAxis> rockRows() {
    return {
        numberAxis<&Conditions::modulus>(
            "modulus", "Young's modulus", "Pa", {1.0, 1e3, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e15, 1e18},
            1e7, 1e13, true,
            "Small strains are assumed: rock that is strained by more than some per cent under "
            "its load is outside the method. Upwards, displacements drown in round-off."),
        numberAxis<&Conditions::contrast>(
            "contrast", "Ratio of Young's moduli of neighbours", "",
            {1e-10, 1e-8, 1e-6, 1e-4, 1e-2, 0.1, 1.0, 10.0, 100.0, 1e4, 1e6, 1e8, 1e10}, 1e-4, 1e8, true,
            "Contacts take the stiffness of the softer block, so its own weight may press it "
            "into the stiffer one; a matrix keeps 16 digits between its stiffest and its softest part."),
        numberAxis<&Conditions::density>(
            "density", "Density", "kg/m³", {1e-30, 1e-12, 1e-6, 1.0, 100.0, 2700.0, 1e4, 1e5, 1e6, 1e8, 1e10, 1e12},
            100.0, 1e5, true, "Strain under its own weight, ρgL/E, is assumed to be small."),
        numberAxis<&Conditions::poisson>(
            "poisson", "Poisson's ratio", "", {-1.0, -0.999, -0.5, 0.0, 0.2, 0.4, 0.49, 0.499, 0.4999, 0.499999, 0.5},
            0.0, 0.49, false, "At 0.5 rock is incompressible, and plane strain has no stiffness matrix."),
        numberAxis<&Conditions::friction>(
            "friction", "Friction angle", "°",
            {0.0, 1e-6, 1.0, 10.0, 19.0, 21.0, 30.0, 45.0, 60.0, 80.0, 89.0, 89.9, 89.999, 90.0}, 0.0, 80.0, false,
            "At 90° the tangent is infinite."),
        numberAxis<&Conditions::cohesion>("cohesion", "Cohesion", "Pa", {0.0, 1.0, 1e3, 1e5, 1e6, 1e9, 1e12, 1e18}, 1e3,
                                          1e7, true,
                                          "Cohesion only adds to a limit; there is no edge for contacts that stick."),
    };
}

std::vector<ExtremeAxis> loadRows() {
    return {
        numberAxis<&Conditions::gravity>("gravity", "Gravity", "m/s²",
                                         {0.0, 1e-12, 1e-6, 1e-3, 0.1, 1.0, 9.81, 100.0, 1e3, 1e4, 1e5, 1e6, 1e7}, 0.1,
                                         1e3, true,
                                         "Strain under its own weight, ρgL/E, is assumed to be small; 1e6 m/s² is the "
                                         "largest that a scene may have."),
        numberAxis<&Conditions::slope>(
            "slope", "Slope", "°",
            {0.0, 1.0, 10.0, 19.0, 19.9, 20.1, 21.0, 29.0, 29.9, 30.1, 31.0, 45.0, 60.0, 80.0, 89.0}, 0.0, 60.0, false,
            "Near the friction angle the verdict depends on the tolerance of "
            "equilibrium; a dynamic stage decides it."),
        numberAxis<&Conditions::slope>(
            "flank-angle", "Angle of the flanks of a key block", "°",
            {60.0, 45.0, 20.0, 10.0, 5.0, 2.0, 1.0, 0.5, 0.1, 0.01, 1e-3, 1e-4}, 2.0, 45.0, true,
            "The forces grow as W/(2 sin β), and their penetration lets the block sink by 1/sin² β."),
        numberAxis<&Conditions::load>("pressure", "Pressure", "MPa",
                                      {1e-12, 1e-9, 1e-6, 1e-3, 0.1, 1.0, 10.0, 100.0, 500.0, 1e3, 3e3, 1e4, 1e5}, 1e-3,
                                      100.0, true,
                                      "Small strains are assumed: a pressure of some per cent of Young's modulus is "
                                      "outside the method."),
        numberAxis<&Conditions::load>(
            "force", "Force on a bolt", "kN", {1e-12, 1e-6, 1e-3, 0.1, 1.0, 10.0, 100.0, 1e3, 1e4, 1e5}, 1e-3, 100.0,
            true,
            "An elastic bond has no strength: its slip grows with the force until the bar has "
            "left its hole."),
        numberAxis<&Conditions::speed>(
            "speed", "Speed", "m/s", {1e-9, 1e-6, 1e-3, 0.1, 1.0, 10.0, 30.0, 100.0, 300.0, 1e3, 1e4, 1e5, 1e7}, 1e-2,
            30.0, true,
            "A time step must resolve the duration of an impact; rock is strained by v/c, where c is "
            "its wave velocity of some km/s."),
        numberAxis<&Conditions::speed>(
            "spin", "Spin", "rad/s", {1e-6, 1e-3, 0.1, 1.0, 10.0, 100.0, 300.0, 1e3, 1e4, 1e6}, 1e-2, 100.0, true,
            "Centrifugal strain, ρω²L²/E, is assumed to be small; a step that turns a block by more than "
            "some tenths cannot be resolved."),
    };
}

std::vector<ExtremeAxis> boltRows() {
    return {
        numberAxis<&Conditions::bond>(
            "bond", "Bond stiffness", "N/m²",
            {1.0, 1e2, 1e4, 1e5, 1e6, 1e7, 1e8, 2.5e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e15}, 1e6, 1e10, true,
            "The transfer length √(EA/k) falls below the length of the elements; the joint then opens "
            "too far."),
        numberAxis<&Conditions::divisions>(
            "divisions", "Divisions of a bolt (0: automatic)", "",
            {0, 1, 3, 5, 11, 21, 40, 41, 80, 81, 200, 201, 1000, 1001}, 4, 80, true,
            "Elements longer than the transfer length of the bond, or a node on the joint, give an opening that is too large."),
        numberAxis<&Conditions::barModulus>("bar-modulus", "Young's modulus of a bar", "Pa",
                                            {1e3, 1e6, 1e8, 1e9, 1e10, 1e11, 2e11, 1e12, 1e14, 1e16, 1e18}, 1e10, 1e13,
                                            true, "A soft bar has a short transfer length, √(EA/k)."),
    };
}

std::vector<ExtremeAxis> numericalRows() {
    const std::string step =
        "A step must resolve what happens in it: an impact, a swing, a turn. Shorter steps lose digits: a step's "
        "displacement must not drown in the coordinates.";
    return {
        stepAxis<Integration::Shi>("time-step", "shi", step),
        stepAxis<Integration::Newmark>("time-step-newmark", "newmark", step),
        stepAxis<Integration::BackwardEuler>("time-step-backward", "backward-euler", step),
        stepAxis<Integration::GeneralizedAlpha>("time-step-alpha", "generalized-alpha", step),
        numberAxis<&Conditions::steps>("steps", "Number of steps", "", {1, 2, 10, 100, 1e3, 5e3, 1.5e4}, 10, 400, true,
                                       "Time; round-off grows with the number of steps."),
        numberAxis<&Conditions::penalty>(
            "penalty", "Penalty ratio", "",
            {1e-6, 1e-4, 1e-3, 1e-2, 0.1, 1.0, 10.0, 40.0, 100.0, 1e3, 1e4, 1e5, 1e6, 1e8, 1e10}, 1.0, 1e4, true,
            "Soft contacts let blocks penetrate by W/k; stiff ones leave 16 digits minus those of the ratio "
            "for the rock."),
        numberAxis<&Conditions::shearRatio>("shear-ratio", "Shear over normal stiffness", "",
                                            {1e-8, 1e-6, 1e-4, 1e-2, 0.1, 0.4, 1.0, 10.0, 1e2, 1e4, 1e6, 1e8}, 1e-2,
                                            100.0, true,
                                            "Soft shear springs let a block move by T/k before it sticks."),
        numberAxis<&Conditions::tolerance>(
            "tolerance", "Iteration tolerance", "",
            {1e-16, 1e-15, 1e-13, 1e-12, 1e-10, 1e-8, 1e-6, 1e-4, 1e-3, 1e-2, 0.1, 0.2}, 1e-10, 1e-3, true,
            "Below some 1e-12 round-off decides; above 1e-3 forces are no longer those of statics."),
        numberAxis<&Conditions::iterations>(
            "max-passes", "Iterations before a step is shortened", "", {1, 2, 3, 5, 10, 40, 100, 1e3, 1e5, 1e6}, 10,
            100, true, "A step that may take one iteration only cannot change the states of contacts."),
        numberAxis<&Conditions::damping>("damping", "Damping by mass", "1/s",
                                         {0.0, 1e-3, 0.1, 1.0, 10.0, 100.0, 1e4, 1e8, 1e12}, 1e-3, 1.0, true,
                                         "Damping only slows motion down; at rest there is no edge."),
        choiceAxis<Integration, &Conditions::integration>(
            "integration", "Time integration", {"shi", "backward-euler", "newmark", "generalized-alpha"}, "No edge."),
        choiceAxis<ContactMethod, &Conditions::contact>("contact", "Contact method",
                                                        {"penalty", "augmented-lagrangian"}, "No edge."),
        choiceAxis<Iteration, &Conditions::iteration>("iteration", "Iteration of contact states",
                                                      {"convex", "open-close"},
                                                      "The classical iteration may never settle where contacts slide."),
    };
}

std::vector<ExtremeAxis> allRows() {
    std::vector<ExtremeAxis> all;
    for (const auto& rows : {numericalRows(), sectionRows(), rockRows(), loadRows(), boltRows()})
        all.insert(all.end(), rows.begin(), rows.end());
    return all;
}

}  // namespace

const std::vector<ExtremeAxis>& extremeAxes() {
    static const std::vector<ExtremeAxis> all = allRows();
    return all;
}

const ExtremeAxis& extremeAxis(const std::string& name) {
    const auto found = std::find_if(extremeAxes().begin(), extremeAxes().end(),
                                    [&](const ExtremeAxis& axis) { return axis.name == name; });
    assert(found != extremeAxes().end());
    return *found;
}

std::string valueText(const ExtremeAxis& axis, double value) {
    if (!axis.words.empty()) return axis.words.at(static_cast<std::size_t>(value));
    return rounded(value) + (axis.unit.empty() ? "" : axis.unit == "°" ? "°" : " " + axis.unit);
}

}  // namespace keyblock
