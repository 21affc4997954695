// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/section/section_ranges.h"

#include "solver/scene/bolt_steel.h"
#include "solver/scene/lookup.h"
#include "solver/scene/solved_blocks.h"
#include "ui/picture/section/deformed.h"

#include <algorithm>
#include <cmath>

namespace keyblock {

namespace {

constexpr int mostTicks = 5;
constexpr double negligible = 1e-3;  // fraction of the largest value; the sign of smaller values is not shown
constexpr double shareOutside = 0.02;  // fraction of the rock's area that is clipped at either end
constexpr double leastStrain = 1e-9, leastStress = 100.0;  // [–] and [Pa]; a stress below both limits counts as zero

void gather(const SectionRequest& request, const Frame& frame, std::vector<Weighed>& blocks,
            std::vector<Weighed>& bolts) {
    if (request.blocks)
        for (const BlockState& block : frame.blocks)
            if (const double value = request.blocks->value(block) * request.blocks->display.factor;
                block.area > 0.0 && canBeShown(value))
                blocks.push_back({value, block.area});
    if (request.bolts)
        for (const BoltFrame& bolt : frame.bolts)
            for (std::size_t i = 0; i + 1 < bolt.nodes.size(); ++i)
                if (const double value = request.bolts->value(bolt.nodes[i]) * request.bolts->display.factor;
                    canBeShown(value))
                    bolts.push_back({value, 1.0});
}

/// Bolts are coloured by magnitude, on a scale that starts at 0.
std::vector<Weighed> magnitudes(std::vector<Weighed> values) {
    for (Weighed& value : values) value.value = std::abs(value.value);
    if (!values.empty()) values.push_back({0.0, 1.0});
    return values;
}

ValueRange extent(const std::vector<Weighed>& values) { return rangeWithout(values, 0.0); }

void reach(const std::vector<Weighed>& values, std::optional<ValueRange>& reached) {
    if (values.empty()) return;
    const ValueRange range = extent(values);
    reached = reached ? ValueRange{std::min(reached->low, range.low), std::max(reached->high, range.high)} : range;
}

/// Adds a note on the values of this frame, with one more digit than the bar's ticks.
void noteNow(const std::vector<Weighed>& values, const QuantityDisplay& display, LegendBar& bar) {
    if (values.empty()) return;
    const ValueRange now = extent(values);
    bar.now = now;
    const std::string low = numberText(now.low, bar.ticks.decimals + 1);
    const std::string high = numberText(now.high, bar.ticks.decimals + 1);
    bar.notes.push_back("this frame: " + low + (low == high ? "" : " to " + high) + (display.unit.empty() ? "" : " ") +
                        std::string(display.unit));
}

/// Sets the range of a bar, rounded if requested, and marks the ends that values exceed.
void takeRange(const ValueRange& range, bool rounded, LegendBar& bar) {
    const bool isSymmetric = bar.map == &tide;
    bar.range = !rounded ? range : isSymmetric ? roundedSymmetric(range, mostTicks) : roundedRange(range, mostTicks);
    bar.ticks = roundTicks(bar.range, mostTicks);
    bar.goesBelow = bar.reach.low < bar.range.low;
    bar.goesAbove = bar.reach.high > bar.range.high;
}

/// Sets the range of one frame, or the range typed by the user.
void takeScale(const ScaleChoice& choice, const std::vector<Weighed>& values, LegendBar& bar) {
    bar.scale = choice;
    if (choice.of == ScaleOf::Own && choice.own.low < choice.own.high) takeRange(choice.own, false, bar);
    if (choice.of == ScaleOf::ThisFrame && !values.empty())
        takeRange(rangeWithout(values, choice.clips ? shareOutside : 0.0), true, bar);
    if (bar.clips()) bar.notes.emplace_back("extreme 2 % of the area clipped");
    if (choice.of == ScaleOf::ThisFrame) bar.notes.emplace_back("scale of this frame");
    if (choice.of == ScaleOf::Own) bar.notes.emplace_back("range set manually");
}

/// Removes the limits that are outside the range.
void keepLimitsWithin(LegendBar& bar) {
    std::erase_if(bar.limits,
                  [&](const auto& limit) { return limit.first > bar.range.high || limit.first < bar.range.low; });
}

LegendBar barOf(std::string_view quantity, const QuantityDisplay& display) {
    LegendBar bar;
    bar.quantity = quantity;
    bar.title = display.title;
    bar.unit = display.unit;
    bar.notes.emplace_back(display.convention);
    bar.convention = display.convention;
    return bar;
}

/// Round-off level of a block quantity, in the unit shown.
double roundOff(const QuantityDisplay& display, const Scene& scene) {
    double stiffest = 0.0;
    for (const auto& [name, rock] : scene.materials) stiffest = std::max(stiffest, rock.youngsModulus);
    const double stress = std::min(leastStress, leastStrain * stiffest);
    return display.unit == "MPa" ? stress * std::abs(display.factor) : 0.0;
}

/// \param whole full range of the quantity's values
std::optional<LegendBar> blockLegend(const FrameQuantity<BlockState>& quantity, std::vector<Weighed> all,
                                     ValueRange whole, double nothing, bool clips) {
    if (all.empty()) return std::nullopt;
    LegendBar bar = barOf(quantity.name, quantity.display);
    bar.map = quantity.display.isSigned ? &tide : &slate;
    for (Weighed& value : all)
        if (std::abs(value.value) <= nothing) value.value = 0.0;
    for (double* end : {&whole.low, &whole.high})
        if (std::abs(*end) <= nothing) *end = 0.0;
    bar.reach = whole;
    ValueRange range = clips ? rangeWithout(all, shareOutside) : whole;
    if (range.low > 0.0) range.low = 0.0;
    takeRange(range, true, bar);
    return bar;
}

/// Bolts are coloured by magnitude, because only one end of the colour map Ember contrasts with the background.
std::optional<LegendBar> boltLegend(const FrameQuantity<BoltNodeFrame>& quantity, const std::vector<Weighed>& all,
                                    const ValueRange& whole,
                                    const std::vector<std::pair<double, std::string>>& limits) {
    if (all.empty()) return std::nullopt;
    const QuantityDisplay& display = quantity.display;
    LegendBar bar = barOf(quantity.name, display);
    if (display.isSigned)
        bar.notes.front() += bar.notes.front().empty() ? "coloured by magnitude" : ", coloured by magnitude";
    bar.unit += display.unit.find('N') != std::string_view::npos ? " per bolt" : "";
    bar.map = &ember;
    double high = std::max(std::abs(whole.low), std::abs(whole.high));
    for (const auto& [limit, name] : limits)
        if (limit > high && limit < 1.5 * high) high = limit;
    bar.reach = {0.0, std::max(std::abs(whole.low), std::abs(whole.high))};
    if (display.isSigned && whole.low < -negligible * bar.reach.high) {
        bar.dashed = rowOf(quantity).quantity == BoltQuantity::AxialForce ? "compression" : "negative";
        bar.notes.push_back("dashed: " + bar.dashed);
    }
    bar.limits = limits;
    takeRange({0.0, high}, true, bar);
    return bar;
}

/// Limits of all bolt types used in the scene, without duplicates.
std::vector<std::pair<double, std::string>> limitsOfAll(const Scene& scene, const SectionRequest& request) {
    std::vector<std::pair<double, std::string>> all;
    if (!request.bolts) return all;
    for (const Bolt& bolt : scene.bolts)
        for (const auto& limit : limitsOf(scene, bolt, *request.bolts))
            if (std::find(all.begin(), all.end(), limit) == all.end()) all.push_back(limit);
    return all;
}

/// Side of a square with the average area of the solved blocks [m].
double spacingOf(const Scene& scene) {
    const auto corners = cornersBefore(solvedBlocks(scene));
    double area = 0.0;
    for (const auto& outline : corners) area += std::abs(signedArea(outline));
    return corners.empty() ? 0.0 : std::sqrt(area / static_cast<double>(corners.size()));
}

}  // namespace

std::vector<std::pair<double, std::string>> limitsOf(const Scene& scene, const Bolt& bolt,
                                                     const FrameQuantity<BoltNodeFrame>& quantity) {
    const BoltType* type = findBoltType(scene, bolt.type);
    if (!type || rowOf(quantity).quantity != BoltQuantity::AxialForce) return {};
    std::vector<std::pair<double, std::string>> limits;
    const BoltSteel steel = boltSteel(*type);
    if (steel.yield) limits.emplace_back(*steel.yield * quantity.display.factor, "yield");
    if (steel.tensile && steel.tensile != steel.yield)
        limits.emplace_back(*steel.tensile * quantity.display.factor, "ultimate");
    return limits;
}

SectionRanges::SectionRanges(const Scene& scene, const SectionRequest& request)
    : blockQuantity_(request.blocks), boltQuantity_(request.bolts), contacts_(request.contacts) {
    if (request.contacts) scale_.spacing = spacingOf(scene);
    if (request.blocks) roundOff_ = roundOff(request.blocks->display, scene);
    limits_ = limitsOfAll(scene, request);
}

void SectionRanges::add(const Frame& frame) {
    SectionRequest request;
    request.blocks = blockQuantity_;
    request.bolts = boltQuantity_;
    Values values;
    gather(request, frame, values.blocks, values.bolts);
    if (contacts_) widen(scale_, frame, values.forces);
    reach(values.blocks, blockReach_);
    reach(blockPeaks(frame), blockReach_);
    reach(values.bolts, boltReach_);
    reach(peaks(frame), boltReach_);
    frames_.push_back(std::move(values));
}

/// Extreme values of bolts up to this frame, including those between frames.
std::vector<Weighed> SectionRanges::peaks(const Frame& frame) const {
    std::vector<Weighed> found;
    if (!boltQuantity_) return found;
    for (const BoltExtremes& bolt : frame.extremes)
        if (const BoltPeak* peak = peakOf(bolt, boltQuantity_->name))
            found.push_back({peak->value * boltQuantity_->display.factor, 1.0});
    return found;
}

/// Extreme values of blocks up to this frame, including those between frames.
std::vector<Weighed> SectionRanges::blockPeaks(const Frame& frame) const {
    std::vector<Weighed> found;
    if (!blockQuantity_) return found;
    for (const BlockExtremes& block : frame.blockExtremes)
        if (const BlockPeak* peak = peakOf(block, blockQuantity_->name))
            found.push_back({peak->value * blockQuantity_->display.factor, 1.0});
    return found;
}

void SectionRanges::dropEverySecond() {
    std::size_t kept = 0;
    for (std::size_t i = 0; i < frames_.size(); i += 2) frames_[kept++] = std::move(frames_[i]);
    frames_.resize(kept);
}

SectionLegends SectionRanges::legends(const ScaleChoices& scales) const {
    std::vector<Weighed> blocks, bolts;
    std::vector<double> forces;
    for (const Values& frame : frames_) {
        blocks.insert(blocks.end(), frame.blocks.begin(), frame.blocks.end());
        bolts.insert(bolts.end(), frame.bolts.begin(), frame.bolts.end());
        forces.insert(forces.end(), frame.forces.begin(), frame.forces.end());
    }
    SectionLegends legends;
    if (contacts_) {
        legends.contacts = scale_;
        legends.contacts->longest = longestOf(std::move(forces));
    }
    if (blockQuantity_)
        legends.blocks = blockLegend(*blockQuantity_, std::move(blocks), blockReach_.value_or(ValueRange{}), roundOff_,
                                     scaleOf(scales, blockQuantity_->name).clips);
    if (boltQuantity_) legends.bolts = boltLegend(*boltQuantity_, bolts, boltReach_.value_or(ValueRange{}), limits_);
    return legends;
}

SectionLegends sectionLegends(const RunSource& run, const SectionRequest& request) {
    SectionRanges ranges(run.scene(), request);
    for (std::size_t i = 0; i < run.frames().size(); ++i) ranges.add(run.frame(i));
    return ranges.legends(request.scales);
}

SectionLegends withNow(SectionLegends legends, const SectionRequest& request, const Frame& frame) {
    std::vector<Weighed> blocks, bolts;
    gather(request, frame, blocks, bolts);
    if (legends.blocks) {
        noteNow(blocks, request.blocks->display, *legends.blocks);
        takeScale(scaleOf(request.scales, request.blocks->name), blocks, *legends.blocks);
    }
    if (legends.bolts) {
        noteNow(bolts, request.bolts->display, *legends.bolts);
        takeScale(scaleOf(request.scales, request.bolts->name), magnitudes(bolts), *legends.bolts);
        keepLimitsWithin(*legends.bolts);
    }
    return legends;
}

}  // namespace keyblock
