// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Checks that bolt types are complete and consistent: the stress–strain curve
// of the steel must rise, Young's modulus must agree with it, and anchors need
// a law.
#include "solver/scene/bolt_steel.h"
#include "solver/scene/check_report.h"
#include "solver/scene/number_text.h"
#include "solver/scene/pointer.h"
#include "solver/scene/suggest.h"
#include "solver/scene/units.h"

#include <cmath>

namespace keyblock {

namespace {

// relative difference between `youngs_modulus` and the slope of the first segment of `steel`
constexpr double modulusAgreement = 0.01;
constexpr double areaAgreement = 1e-3;  // relative; allows for areas rounded to whole mm²

bool startsAtOrigin(const Table& table) {
    return !table.empty() && table.front().first == 0.0 && table.front().second == 0.0;
}

// Index of the first row whose abscissa does not exceed the previous one; 0 if all increase.
std::size_t firstNotRising(const Table& table) {
    for (std::size_t i = 1; i < table.size(); ++i)
        if (!(table[i].first > table[i - 1].first))
            return i;
    return 0;
}

std::size_t firstFalling(const Table& table) {
    for (std::size_t i = 1; i < table.size(); ++i)
        if (!(table[i].second >= table[i - 1].second))
            return i;
    return 0;
}

// Index of the first row whose segment is steeper than the first segment; 0 if there is none.
std::size_t firstSteeper(const Table& table) {
    const double slope = table[1].second / table[1].first;
    for (std::size_t i = 2; i < table.size(); ++i)
        if (table[i].second - table[i - 1].second > slope * (table[i].first - table[i - 1].first) * (1.0 + 1e-9))
            return i;
    return 0;
}

// Checks that stress–strain curves and force–slip curves have in common. Returns false if the curve cannot be used.
bool checkCurve(const Table& curve, std::string_view abscissa, std::string_view ordinate, const std::string& pointer,
                CheckReport& report) {
    const std::string first(abscissa);
    const std::string second(ordinate);
    if (!isFinite(curve))
        return false;  // already reported by the field check
    if (curve.size() < 2 || !startsAtOrigin(curve)) {
        report.error(pointer, "the curve must begin with [0, 0] and have at least two points",
                     "Give " + first + " and " + second + ", starting at the origin");
        return false;
    }
    if (const std::size_t row = firstNotRising(curve)) {
        report.error(under(pointer, row), "the " + first + " does not increase",
                     "Sort the points by " + first + " and leave out repeated ones");
        return false;
    }
    if (!(curve[1].second > 0.0)) {
        report.error(under(pointer, 1), "the first segment has no stiffness",
                     "Give a " + second + " above 0 at the first point after the origin");
        return false;
    }
    if (const std::size_t row = firstSteeper(curve)) {
        report.error(under(pointer, row), "the curve becomes steeper than its first segment, which defines unloading",
                     "Make the first segment the steepest one: start the curve where it is stiff");
        return false;
    }
    return true;
}

void checkModulus(const BoltType& type, const std::string& pointer, CheckReport& report) {
    const double fromSteel = type.steel[1].second / type.steel[1].first;
    if (type.youngsModulus && !(std::abs(*type.youngsModulus - fromSteel) <= modulusAgreement * fromSteel))
        report.error(under(pointer, "youngs_modulus"),
                     "Young's modulus " + pressureText(*type.youngsModulus) +
                         " and the modulus of the first segment of 'steel', " + pressureText(fromSteel) +
                         ", differ by more than 1 %",
                     "Leave 'youngs_modulus' out, or correct the first strain and stress of 'steel'");
}

void checkSteel(const BoltType& type, const std::string& pointer, CheckReport& report) {
    if (type.steel.empty()) {
        if (!type.youngsModulus)
            report.error(pointer, "the bolt type has neither 'steel' nor 'youngs_modulus'",
                         "Give one of them, or another type as 'like'");
        else if (type.ruptureRule == RuptureRule::Interaction)
            report.error(under(pointer, "rupture_rule"), "tension and shear cannot break a bolt without 'steel'",
                         "Give 'steel', or omit the rule");
        return;
    }
    const std::string place = under(pointer, "steel");
    if (!checkCurve(type.steel, "strain", "stress", place, report))
        return;
    if (const std::size_t row = firstFalling(type.steel))
        report.error(under(place, row), "the stress decreases", "Let the stress increase or stay constant up to rupture");
    checkModulus(type, pointer, report);
}

void checkSection(const BoltType& type, const std::string& pointer, CheckReport& report) {
    const double circle = fullBarArea(type.diameter);
    const Unit squareMillimetre = *readUnit("mm²");
    if (type.area && *type.area > circle * (1.0 + areaAgreement))
        report.error(under(pointer, "area"),
                     "the area " + rounded(fromSi(*type.area, squareMillimetre)) +
                         " mm² is larger than the full circle of the diameter, " +
                         rounded(fromSi(circle, squareMillimetre)) + " mm²",
                     "Correct the area [m²] or the diameter [m]");
}

void checkPlace(const Anchor& anchor, const std::string& pointer, CheckReport& report) {
    const Anchor whole;
    if (anchor.at && (anchor.from != whole.from || anchor.to != whole.to))
        report.error(pointer, "the anchor has both a position and a range", "Give either 'at', or 'from' and 'to'");
    const bool backwards = anchor.from.head || (!anchor.to.head && anchor.to.s <= anchor.from.s);
    if (!anchor.at && backwards)
        report.error(under(pointer, "to"), "the range ends at its start or before it",
                     "Measure both from the far end, with 'from' less than 'to'; for a single node give 'at'");
}

void checkLimited(const Anchor& anchor, const std::string& pointer, CheckReport& report) {
    if (!anchor.strength)
        report.error(under(pointer, "strength"), "the law needs a strength",
                     "Give 'strength', or use the law 'elastic', which never fails");
    else if (anchor.residual > *anchor.strength)
        report.error(under(pointer, "residual"), "the residual is larger than the strength",
                     "Give at most the strength; for friction at full strength use the law 'frictional'");
}

constexpr double leastSoftening = 1e-3;  // ratio of the softening slip to the slip at the peak

void checkSoftening(const Anchor& anchor, const std::string& pointer, CheckReport& report) {
    if (anchor.softeningSlip == 0.0)
        return;
    const std::string place = under(pointer, "softening_slip");
    if (anchor.frictionAngle != 0.0)
        report.error(place, "a bond whose strength increases with the normal force cannot soften over a slip",
                     "Omit 'softening_slip' or 'friction_angle'");
    if (!anchor.restick)
        report.error(place, "a bond that softens over a slip unloads along its stiffness and always re-sticks",
                     "Omit 'restick' or 'softening_slip'");
    if (anchor.onFailure == OnFailure::BoltLost)
        report.error(place, "a bolt that is lost with this anchor is lost at its peak, before it can soften",
                     "Omit 'on_failure' or 'softening_slip'");
    if (anchor.strength && anchor.softeningSlip * anchor.stiffness < leastSoftening * *anchor.strength)
        report.error(place, "the bond softens over less than a thousandth of the slip at its peak",
                     "Remove it for a brittle bond, or give a longer slip", {RepairKind::Omit, place});
}

void checkAnchorCurve(const Anchor& anchor, const std::string& pointer, CheckReport& report) {
    const std::string place = under(pointer, "points");
    if (!checkCurve(anchor.curve, "slip", "force", place, report))
        return;
    for (std::size_t i = 1; i < anchor.curve.size(); ++i)
        if (anchor.curve[i].second < 0.0)
            report.error(under(place, i), "the force is negative", "Give the resistance to slip, 0 or more");
}

void checkLaw(const Anchor& anchor, const std::string& pointer, CheckReport& report) {
    if (rowOf(anchor.law).hasPoints)
        return checkAnchorCurve(anchor, pointer, report);
    if (anchor.stiffness == 0.0)
        report.error(under(pointer, "stiffness"), "the law needs a stiffness", "Give a stiffness above 0");
    if (rowOf(anchor.law).hasStrength)
        checkLimited(anchor, pointer, report);
    checkSoftening(anchor, pointer, report);
}

}  // namespace

void checkAnchors(const std::vector<Anchor>& anchors, const std::string& pointer, CheckReport& report) {
    for (std::size_t i = 0; i < anchors.size(); ++i) {
        checkPlace(anchors[i], under(pointer, i), report);
        checkLaw(anchors[i], under(pointer, i), report);
    }
}

void checkBoltTypes(CheckContext& context) {
    const std::vector<BoltType>& types = context.scene.boltTypes;
    const auto pointerOf = [&](std::size_t i) { return under("/bolt_types", types[i].name); };
    checkNamesDiffer(
        types.size(), [&](std::size_t i) { return types[i].name; }, pointerOf, "bolt type", context.report);
    for (std::size_t i = 0; i < types.size(); ++i) {
        if (types[i].name.empty())
            context.report.error(pointerOf(i), "a bolt type has an empty name", "Give it a name");
        checkSteel(types[i], pointerOf(i), context.report);
        checkSection(types[i], pointerOf(i), context.report);
        checkAnchors(types[i].anchors, under(pointerOf(i), "anchors"), context.report);
    }
}

}  // namespace keyblock
