// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// Monitors and quantities must refer to something that exists.
#include "solver/scene/check_report.h"
#include "solver/scene/lookup.h"
#include "solver/scene/number_text.h"
#include "solver/scene/pointer.h"
#include "solver/scene/quantity_text.h"
#include "solver/scene/suggest.h"

#include <algorithm>

namespace keyblock {

namespace {

const Bolt* findBolt(const Scene& scene, const std::string& name) {
    const auto found =
        std::find_if(scene.bolts.begin(), scene.bolts.end(), [&](const Bolt& bolt) { return bolt.name == name; });
    return found == scene.bolts.end() ? nullptr : &*found;
}

std::vector<std::string_view> namesOfBolts(const Scene& scene) {
    std::vector<std::string_view> names;
    for (const Bolt& bolt : scene.bolts)
        names.push_back(bolt.name);
    return names;
}

std::string placeKey(const Monitor& monitor) {
    return monitor.at ? "at" : monitor.atFromHead ? "at_from_head" : "at_fraction";
}

void checkMonitorPlace(const Monitor& monitor, const Bolt& bolt, const std::string& pointer, CheckReport& report) {
    const int places = (monitor.at ? 1 : 0) + (monitor.atFromHead ? 1 : 0) + (monitor.atFraction ? 1 : 0);
    if (places > 1)
        return report.error(pointer, "the monitor gives more than one position along the bolt",
                            "Keep one of 'at', 'at_from_head' and 'at_fraction'");
    const double length = lengthOf(bolt);
    if (!(length > 0.0))
        return;  // already reported at the bolt
    const double place = distanceAlong(monitor, length);
    const double tolerance = 1e-9 * length;
    if (places == 1 && (place > length + tolerance || place < -tolerance))
        report.error(under(pointer, placeKey(monitor)),
                     "the position is beyond the end of the bolt " + inQuotes(bolt.name) + ", which is " + rounded(length) +
                         " m long",
                     "Give at most the length of the bolt");
}

void checkBoltMonitor(const Monitor& monitor, const std::string& pointer, CheckContext& context) {
    if (const Bolt* bolt = findBolt(context.scene, *monitor.bolt))
        return checkMonitorPlace(monitor, *bolt, pointer, context.report);
    if (context.isCut && !context.report.isFull())
        context.report.error(under(pointer, "bolt"), "there is no bolt " + inQuotes(*monitor.bolt),
                             suggestion(*monitor.bolt, namesOfBolts(context.scene)));
}

void checkBetween(const Monitor& monitor, const std::string& pointer, CheckContext& context) {
    checkAxis(monitor.axis, under(pointer, "axis"), context.report);
    const std::string place = under(pointer, "between");
    const int first = checkPointOnBlock(context, (*monitor.between)[0], under(place, std::size_t{0}));
    const int second = checkPointOnBlock(context, (*monitor.between)[1], under(place, std::size_t{1}));
    if (first >= 0 && first == second)
        context.report.warning(place,
                               "both points belong to the block " + inQuotes(displayName(context.scene, first)) +
                                   ", so no joint between them can open",
                               "Move them to the two sides of the joint, away from its line");
}

void checkMonitor(const Monitor& monitor, const std::string& pointer, CheckContext& context) {
    const int subjects = (monitor.point ? 1 : 0) + (monitor.between ? 1 : 0) + (monitor.bolt ? 1 : 0);
    if (subjects != 1)
        return context.report.error(pointer, "a monitor needs exactly one of 'point', 'between' and 'bolt'",
                                    subjects == 0 ? "Give one of them" : "Keep only one of them");
    if (monitor.point)
        checkPointOnBlock(context, *monitor.point, under(pointer, "point"));
    else if (monitor.between)
        checkBetween(monitor, pointer, context);
    else
        checkBoltMonitor(monitor, pointer, context);
}

void checkQuantity(const std::string& text, const std::string& pointer, CheckContext& context) {
    const QuantityReading reading = readQuantity(text, context.scene);
    if (!reading.quantity && context.isCut)
        context.report.error(pointer, reading.problem,
                             "Write, for instance, \"max MONITOR\", \"last BOLT.axial_force\", \"first debonding "
                             "MONITOR\" or \"count debonding\"");
}

/// An expected value is a number that one run gives.
void checkExpected(const Expected& expected, const std::string& pointer, CheckContext& context) {
    checkQuantity(expected.quantity, pointer, context);
    const QuantityReading reading = readQuantity(expected.quantity, context.scene);
    if (reading.quantity && reading.quantity->kind == QuantityKind::Order)
        context.report.error(pointer, "an order of events is not a number, so it cannot be expected",
                             "Expect a number of events, as in \"count debonding\"");
    if (reading.quantity && reading.quantity->kind == QuantityKind::FactorOfSafety)
        context.report.error(pointer, "a run does not give a factor of safety, so it cannot be expected",
                             "Expect the quantity 'stands' with the value 1 or 0");
}

}  // namespace

void checkWatch(CheckContext& context) {
    const Scene& scene = context.scene;
    checkNamesDiffer(
        scene.monitors.size(), [&](std::size_t i) { return scene.monitors[i].name; },
        [](std::size_t i) { return under(under("/monitors", i), "name"); }, "monitor", context.report);
    for (std::size_t i = 0; i < scene.monitors.size(); ++i)
        checkMonitor(scene.monitors[i], under("/monitors", i), context);
    for (std::size_t i = 0; i < scene.quantities.size(); ++i)
        checkQuantity(scene.quantities[i], under("/quantities", i), context);
    for (std::size_t i = 0; i < scene.about.expected.size(); ++i)
        checkExpected(scene.about.expected[i], under(under("/about/expected", i), "quantity"), context);
}

}  // namespace keyblock
