// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/section/shown_numbers.h"

#include "solver/scene/units.h"
#include "ui/picture/chart.h"
#include "ui/picture/section/section.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <vector>

namespace keyblock {

namespace {

/// A unit used in pictures and the SI unit that can replace it. One of the former equals `factor` of the latter.
struct UnitRow {
    std::string_view usual, si;
    double factor;
};

const std::vector<UnitRow>& units() {
    static const std::vector<UnitRow> rows = [] {
        std::vector<UnitRow> found;
        for (const PracticalUnit& row : practicalUnits())
            if (row.use != UnitUse::Forms)
                found.push_back({row.practical, row.si, toSi(1.0, readUnit(row.practical).value_or(Unit{}))});
        return found;
    }();
    return rows;
}

/// Smaller values are shown as zero: in a section of rock they are round-off and could not be measured.
constexpr double leastForce = 1e-6, leastOther = 1e-9;  // in MPa, kN or kN m; and in other units

constexpr std::string_view compressionPlus = "compression +", per = " per ";

void scale(std::vector<double>& values, double factor) {
    for (double& value : values) value *= factor;
}

void scale(ValueRange& range, double factor) { range = {range.low * factor, range.high * factor}; }

/// Ticks of an ascending or descending range. Its end values are ticks only if they are round.
Ticks ticksOf(const ValueRange& range, int most) {
    Ticks ticks = roundTicks({std::min(range.low, range.high), std::max(range.low, range.high)}, most);
    if (range.high < range.low) std::reverse(ticks.values.begin(), ticks.values.end());
    return ticks;
}

/// Converts a legend bar. With the opposite sign its range descends from left to right, so that each value keeps its
/// colour.
double turn(LegendBar& bar, const ShownNumbers& numbers) {
    const ShownAs shown = shownAs(bar.unit, bar.convention, numbers);
    bar.unit = shown.unit;
    bar.convention = shown.convention;
    if (shown.factor == 1.0) return 1.0;
    scale(bar.range, shown.factor);
    scale(bar.reach, shown.factor);
    bar.ticks = ticksOf(bar.range, static_cast<int>(std::max<std::size_t>(2, bar.ticks.values.size())));
    if (bar.now) scale(*bar.now, shown.factor);
    if (bar.now && shown.factor < 0.0) std::swap(bar.now->low, bar.now->high);
    for (auto& [value, name] : bar.limits) value *= shown.factor;
    return shown.factor;
}

void turnBolts(SectionPicture& picture, double factor) {
    for (BoltShape& bolt : picture.bolts) scale(bolt.values, factor);
    if (!picture.ribbon) return;
    picture.ribbon->scale *= factor;
    if (picture.ribbon->limit) *picture.ribbon->limit *= factor;
    scale(picture.ribbon->limits, factor);
}

void turn(ArrowField& field, const ShownNumbers& numbers) {
    const ShownAs shown = shownAs(field.unit, {}, numbers);
    field.unit = shown.unit;
    field.largest *= shown.factor;
    for (ArrowMark& mark : field.marks) mark.value *= shown.factor;
}

void turn(ContactField& field, const ShownNumbers& numbers) {
    const ShownAs shown = shownAs(field.unit, {}, numbers);
    field.unit = shown.unit;
    for (double* force : {&field.largest, &field.scale.longest, &field.scale.largest}) *force *= shown.factor;
    for (ContactLine& line : field.lines) line.force *= shown.factor;
}

/// Converts `Axial force (kN)` to `Axial force (N)`, with the factor 1000.
double turnTitle(std::string& title, const ShownNumbers& numbers) {
    const std::size_t open = title.rfind(" (");
    if (open == std::string::npos || !title.ends_with(')')) return 1.0;
    const ShownAs shown = shownAs(std::string_view(title).substr(open + 2, title.size() - open - 3), {}, numbers);
    title = title.substr(0, open + 2) + shown.unit + ')';
    return shown.factor;
}

void turnOrdinates(ChartPanel& panel, double factor) {
    for (ChartCurve& curve : panel.curves) scale(curve.y, factor);
    for (ChartLimit& limit : panel.limits) {
        limit.value *= factor;
        scale(limit.y, factor);
    }
    scale(panel.reached, factor);
    scale(panel.range, factor);
}

void turnAbscissas(Chart& chart, double factor) {
    scale(chart.x, factor);
    scale(chart.dividers, factor);
    scale(chart.events, factor);
    for (ChartZone& zone : chart.zones) zone = {zone.from * factor, zone.to * factor};
    for (ChartPanel& panel : chart.panels) {
        for (ChartCurve& curve : panel.curves) scale(curve.x, factor);
        for (ChartLimit& limit : panel.limits) scale(limit.x, factor);
    }
}

}  // namespace

ShownAs shownAs(std::string_view unit, std::string_view convention, const ShownNumbers& numbers) {
    ShownAs shown{std::string(unit), std::string(convention), 1.0};
    if (numbers.tensionPositive && unit == "MPa" && convention.ends_with(compressionPlus)) {
        shown.convention.replace(convention.size() - compressionPlus.size(), std::string::npos, "tension +");
        shown.factor = -1.0;
    }
    if (!numbers.si) return shown;
    const std::string_view alone = unit.substr(0, unit.find(per));
    for (const UnitRow& row : units())
        if (row.usual == alone) {
            shown.unit = std::string(row.si) + std::string(unit.substr(alone.size()));
            shown.factor *= row.factor;
        }
    return shown;
}

double withoutRoundOff(double value, std::string_view unit) {
    const std::string_view alone = unit.substr(0, unit.find(per));
    double least = leastOther;
    for (const UnitRow& row : units()) {
        const bool isForce = row.usual == "MPa" || row.usual.starts_with("kN");
        const double usual = isForce ? leastForce : leastOther;
        if (alone == row.usual) least = usual;
        else if (alone == row.si) least = usual * row.factor;
    }
    return std::abs(value) < least ? 0.0 : value;
}

double factorOf(std::string title, const ShownNumbers& numbers) { return turnTitle(title, numbers); }

std::string shownTitle(const std::string& title, const ShownNumbers& numbers) {
    std::string shown;
    std::size_t from = 0;
    for (std::size_t open = title.find('('); open != std::string::npos; open = title.find('(', from)) {
        const std::size_t close = title.find(')', open);
        if (close == std::string::npos) break;
        shown += title.substr(from, open + 1 - from) + shownAs(title.substr(open + 1, close - open - 1), {}, numbers).unit;
        from = close;
    }
    return shown + title.substr(from);
}

std::string forceText(double force, const ShownNumbers& numbers) {
    return numbers.si ? numberText(force) + " N" : numberText(perSi(namedUnit("kN")) * force) + " kN";
}

std::string lengthText(double length, const ShownNumbers& numbers) {
    const bool metres = numbers.si || std::abs(length) >= 1.0;
    return metres ? numberText(length) + " m" : numberText(perSi(namedUnit("mm")) * length) + " mm";
}

void showAs(SectionPicture& picture, const ShownNumbers& numbers) {
    assert(picture.numbers == ShownNumbers());
    picture.numbers = numbers;
    if (picture.blockLegend) {
        const double factor = turn(*picture.blockLegend, numbers);
        for (BlockShape& block : picture.blocks)
            if (block.value) *block.value *= factor;
    }
    if (picture.boltLegend) turnBolts(picture, turn(*picture.boltLegend, numbers));
    if (picture.arrows) turn(*picture.arrows, numbers);
    if (picture.contacts) turn(*picture.contacts, numbers);
}

void showAs(Chart& chart, const ShownNumbers& numbers) {
    for (ChartPanel& panel : chart.panels)
        if (const double factor = turnTitle(panel.title, numbers); factor != 1.0) turnOrdinates(panel, factor);
    if (const double factor = turnTitle(chart.xTitle, numbers); factor != 1.0) turnAbscissas(chart, factor);
}

}  // namespace keyblock
