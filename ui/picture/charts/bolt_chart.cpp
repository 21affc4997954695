// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/picture/charts/bolt_chart.h"

#include "solver/results/bolt_use.h"
#include "solver/results/frame_quantities.h"
#include "solver/results/result_names.h"
#include "solver/scene/bolt_steel.h"
#include "solver/scene/lookup.h"
#include "ui/picture/captions.h"
#include "ui/picture/event_list.h"
#include "ui/picture/section/section_ranges.h"
#include "ui/picture/section/shown_numbers.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace keyblock {

namespace {

constexpr int envelopePlaces = 400;
constexpr double noBoltForce = 1e-3;  // fraction of the largest value; smaller values are not shown

using NodeQuantity = FrameQuantity<BoltNodeFrame>;

/// Whether the value at a node applies to the element that starts there.
bool isOfElement(const NodeQuantity& quantity) {
    return rowOf(quantity).part == BoltPart::Element;
}

double largest(const BoltFrame& bolt, const NodeQuantity& quantity) {
    double size = 0.0;
    for (std::size_t i = 0; i + 1 < bolt.nodes.size(); ++i)
        size = std::max(size, std::abs(quantity.value(bolt.nodes[i])));
    return size;
}

ChartCurve curveOf(const BoltFrame& bolt, const NodeQuantity& quantity) {
    ChartCurve curve;
    const bool stepped = isOfElement(quantity);
    for (std::size_t i = 0; i < bolt.nodes.size(); ++i) {
        const double value = quantity.value(bolt.nodes[i]) * quantity.display.factor;
        if (stepped && i + 1 == bolt.nodes.size()) break;  // the value at the head is that of the face plate
        curve.x.push_back(bolt.nodes[i].s);
        curve.y.push_back(value);
        if (stepped) {
            curve.x.push_back(bolt.nodes[i + 1].s);
            curve.y.push_back(value);
        }
    }
    return curve;
}

/// Minimum and maximum at the bonded nodes; the range always includes zero.
ValueRange reachOf(const BoltFrame& bolt, const NodeQuantity& quantity) {
    ValueRange reach{0.0, 0.0};
    for (const BoltNodeFrame& node : bolt.nodes)
        if (node.real)
            reach = {std::min(reach.low, quantity.value(node)), std::max(reach.high, quantity.value(node))};
    return reach;
}

ChartCurve stemsOf(const BoltFrame& bolt, const NodeQuantity& quantity) {
    ChartCurve curve{"", CurveStyle::Stems, {}, {}};
    for (const BoltNodeFrame& node : bolt.nodes)
        if (node.real) {
            curve.x.push_back(node.s);
            curve.y.push_back(quantity.value(node) * quantity.display.factor);
        }
    return curve;
}

/// The value at a position along the bolt: that of the element there, or interpolated between nodes.
double valueAt(const BoltFrame& bolt, const NodeQuantity& quantity, double s) {
    const auto& nodes = bolt.nodes;
    std::size_t i = 0;
    while (i + 2 < nodes.size() && nodes[i + 1].s <= s) ++i;
    const double first = quantity.value(nodes[i]);
    if (isOfElement(quantity)) return first;
    const double length = nodes[i + 1].s - nodes[i].s;
    const double share = length > 0.0 ? std::clamp((s - nodes[i].s) / length, 0.0, 1.0) : 0.0;
    return first + share * (quantity.value(nodes[i + 1]) - first);
}

/// Adds a limit of the bonds on both sides of zero, as a stepped line with its steps midway between nodes.
void addSteps(const BoltFrame& bolt, const std::vector<double>& values, const ChartLimit& limit, ChartPanel& panel) {
    const auto& nodes = bolt.nodes;
    for (std::size_t first = 0; first < nodes.size(); ++first) {
        if (values[first] <= 0.0) continue;
        ChartLimit steps = limit;
        std::size_t i = first;
        for (; i < nodes.size() && values[i] > 0.0; ++i) {
            steps.x.push_back(i == 0 ? nodes[i].s : 0.5 * (nodes[i - 1].s + nodes[i].s));
            steps.x.push_back(i + 1 == nodes.size() ? nodes[i].s : 0.5 * (nodes[i].s + nodes[i + 1].s));
            steps.y.insert(steps.y.end(), {values[i], values[i]});
            steps.value = std::max(steps.value, values[i]);
        }
        panel.limits.push_back(steps);
        steps.value = -steps.value;
        for (double& y : steps.y) y = -y;
        panel.limits.push_back(std::move(steps));
        first = i;
    }
}

/// Adds the bond strength of each node at its current embedment, and the residual strength where that is lower.
void addBondLimits(const BoltFrame& bolt, double factor, ChartPanel& panel) {
    std::vector<double> peaks, residuals;
    for (const BoltNodeFrame& node : bolt.nodes) {
        const bool falls = node.bondResidual < node.bondStrength * (1.0 - 1e-9);
        peaks.push_back(node.bondStrength * factor);
        residuals.push_back(falls ? node.bondResidual * factor : 0.0);
    }
    const bool any = std::any_of(residuals.begin(), residuals.end(), [](double value) { return value > 0.0; });
    addSteps(bolt, peaks, {any ? "peak" : "limit", 0.0, true}, panel);
    addSteps(bolt, residuals, {"residual", 0.0, false}, panel);
}

}  // namespace

void BoltReach::add(const Frame& frame) {
    const BoltFrame& bolt = frame.bolts[bolt_];
    if (bolt.nodes.size() < 2) return;
    for (const NodeQuantity& quantity : boltQuantities()) {
        ValueRange& reached = reached_[quantity.column];
        const ValueRange reach = reachOf(bolt, quantity);
        reached = {std::min(reached.low, reach.low), std::max(reached.high, reach.high)};
        double& most = largest_[quantity.column];
        most = std::max(most, keyblock::largest(bolt, quantity));
    }
    largestForce_ = std::max(largestForce_, keyblock::largest(bolt, *findQuantity(BoltQuantity::AxialForce)));
    addPeaks(frame);
}

/// Includes the largest values that occurred between frames.
void BoltReach::addPeaks(const Frame& frame) {
    if (static_cast<std::size_t>(bolt_) >= frame.extremes.size()) return;
    for (const NodeQuantity& quantity : boltQuantities()) {
        const BoltPeak* peak = peakOf(frame.extremes[bolt_], quantity.name);
        if (!peak) continue;
        ValueRange& reached = reached_[quantity.column];
        reached = {std::min(reached.low, peak->value), std::max(reached.high, peak->value)};
        double& most = largest_[quantity.column];
        most = std::max(most, std::abs(peak->value));
        if (rowOf(quantity).quantity == BoltQuantity::AxialForce) largestForce_ = std::max(largestForce_, std::abs(peak->value));
    }
}

ValueRange BoltReach::reached(std::string_view column) const {
    const auto found = reached_.find(column);
    return found == reached_.end() ? ValueRange{} : found->second;
}

double BoltReach::largest(std::string_view column) const {
    const auto found = largest_.find(column);
    return found == largest_.end() ? 0.0 : found->second;
}

namespace {

class BoltChartBuilder {
public:
    BoltChartBuilder(const RunSource& run, std::size_t index, int bolt, const BoltReach* known)
        : run_(run), index_(index), bolt_(bolt), frame_(run.frame(index)), known_(known), reach_(bolt) {}

    BoltChart build() {
        assert(0 <= bolt_ && bolt_ < static_cast<int>(frame_.bolts.size()) && !now().nodes.empty());
        const Bolt& bolt = run_.scene().bolts[bolt_];
        chart_.length = (bolt.head - bolt.farEnd).norm();
        chart_.title = titleText(bolt);
        chart_.chart.xTitle = "distance from the far end (m)";
        chart_.chart.x = {0.0, chart_.length};
        addBand(bolt);
        if (known_) {
            reach_ = *known_;
            reach_.add(frame_);
        } else {
            gatherEnvelopes();
        }
        chart_.subtitle = subtitleText(bolt);
        addPanels(bolt);
        addZones();
        addDividers();
        return std::move(chart_);
    }

private:
    const BoltFrame& now() const { return frame_.bolts[bolt_]; }

    std::string titleText(const Bolt& bolt) const {
        const std::string title = titleOf(run_, index_);
        return "Bolt " + bolt.name + ": " + title;
    }

    std::string subtitleText(const Bolt& bolt) const {
        std::string text = bolt.type + ", " + numberText(chart_.length) + " m";
        const BoltType* type = findBoltType(run_.scene(), bolt.type);
        const BoltSteel steel = type ? boltSteel(*type) : BoltSteel{};
        if (steel.yield) text += "; yields at " + forceText(*steel.yield, {});
        if (steel.tensile) text += ", breaks at " + forceText(*steel.tensile, {});
        if (now().lost) text += "; lost";
        const NodeQuantity& axial = *findQuantity(BoltQuantity::AxialForce);
        const double force = largest(now(), axial);
        return text + "; largest axial force in this frame " +
               forceText(force > noBoltForce * reach_.largestForce() ? force : 0.0, {}) + usedText() + ".";
    }

    /// The bolt's utilisation in the run so far.
    std::string usedText() const {
        const std::size_t bolt = bolt_;
        if (bolt >= frame_.extremes.size()) return {};
        const std::string text = useText(boltUse(bolt_, frame_.extremes[bolt]));
        return text.empty() ? "" : "; to date " + text;
    }

    /// Whether only bonded nodes have the quantity: bond force, and slip if some nodes have no bond.
    bool isOfRealNodes(const NodeQuantity& quantity) const {
        const bool all = std::all_of(now().nodes.begin(), now().nodes.end(),
                                     [](const BoltNodeFrame& node) { return node.real; });
        const BoltQuantityRow& row = rowOf(quantity);
        return row.part == BoltPart::Anchor && (row.quantity == BoltQuantity::AnchorForce || !all);
    }

    void addBand(const Bolt& bolt) {
        std::vector<Point> straight;
        for (const BoltNodeFrame& node : now().nodes) straight.emplace_back(node.s, 0.0);
        const std::vector<Event> events = eventsUntil(run_.events(), run_.frames()[index_]);
        chart_.band = marksOf(bolt, bolt_, now(), straight, events);
    }

    /// Shear force and moment are shown if the bolt ever had any, because they are zero in a bar that has since
    /// ruptured.
    bool isShown(const NodeQuantity& quantity) const {
        const BoltQuantity of = rowOf(quantity).quantity;
        const bool beside = of == BoltQuantity::ShearForce || of == BoltQuantity::Moment;
        return !beside || reach_.largest(quantity.column) > std::max(1.0, noBoltForce * reach_.largestForce());
    }

    void gatherEnvelopes() {
        for (const NodeQuantity& quantity : boltQuantities()) {
            if (isOfRealNodes(quantity)) continue;  // values at bonded nodes are drawn as stems
            Envelope envelope{std::string(quantity.column), {}, {}, {}};
            for (int i = 0; i <= envelopePlaces; ++i) envelope.s.push_back(chart_.length * i / envelopePlaces);
            envelope.low.assign(envelope.s.size(), 0.0);
            envelope.high = envelope.low;
            chart_.envelopes.push_back(std::move(envelope));
        }
        for (std::size_t f = 0; f <= index_; ++f) {
            const Frame frame = run_.frame(f);
            const BoltFrame& bolt = frame.bolts[bolt_];
            if (bolt.nodes.size() < 2) continue;
            reach_.add(frame);
            for (Envelope& envelope : chart_.envelopes) widen(envelope, bolt);
        }
        std::erase_if(chart_.envelopes, [&](const Envelope& envelope) { return !isShown(quantityOf(envelope)); });
    }

    static const NodeQuantity& quantityOf(const Envelope& envelope) {
        const auto rows = boltQuantities();
        return *std::find_if(rows.begin(), rows.end(),
                             [&](const NodeQuantity& row) { return row.column == envelope.quantity; });
    }

    static void widen(Envelope& envelope, const BoltFrame& bolt) {
        const NodeQuantity& quantity = quantityOf(envelope);
        for (std::size_t i = 0; i < envelope.s.size(); ++i) {
            const double value = valueAt(bolt, quantity, envelope.s[i]);
            envelope.low[i] = std::min(envelope.low[i], value);
            envelope.high[i] = std::max(envelope.high[i], value);
        }
    }

    void addPanels(const Bolt& bolt) {
        for (const NodeQuantity& quantity : boltQuantities()) {
            if (!isShown(quantity)) continue;
            ChartPanel panel;
            panel.title = std::string(quantity.display.title) + " (" + std::string(quantity.display.unit) + ")";
            panel.bolts = rowOf(quantity).quantity;
            for (const Envelope& envelope : chart_.envelopes)
                if (envelope.quantity == quantity.column) addEnvelope(envelope, quantity.display.factor, panel);
            panel.note = quantity.display.convention;
            panel.curves.push_back(isOfRealNodes(quantity) ? stemsOf(now(), quantity) : curveOf(now(), quantity));
            for (const auto& [limit, name] : limitsOf(run_.scene(), bolt, quantity))
                panel.limits.push_back({name, limit, name == "ultimate"});
            if (panel.bolts == BoltQuantity::AnchorForce) addBondLimits(now(), quantity.display.factor, panel);
            const ValueRange reached = reach_.reached(quantity.column);
            panel.reached = {reached.low * quantity.display.factor, reached.high * quantity.display.factor};
            reachForCapacity(panel);
            fitRange(panel);
            chart_.chart.panels.push_back(std::move(panel));
        }
    }

    /// Extends the range to the lowest capacity that was not exceeded, even if it is far above the values.
    static void reachForCapacity(ChartPanel& panel) {
        if (panel.bolts != BoltQuantity::AxialForce) return;
        const ChartLimit* next = nullptr;
        for (const ChartLimit& limit : panel.limits)
            if (limit.value >= panel.reached.high && (!next || limit.value < next->value)) next = &limit;
        if (next) panel.reached.high = next->value;
    }

    static void addEnvelope(const Envelope& envelope, double factor, ChartPanel& panel) {
        for (const auto* side : {&envelope.low, &envelope.high}) {
            const auto size = [](const std::vector<double>& values) {
                double most = 0.0;
                for (const double value : values) most = std::max(most, std::abs(value));
                return most;
            };
            if (size(*side) <= noBoltForce * std::max(size(envelope.low), size(envelope.high))) continue;
            ChartCurve curve{"", CurveStyle::Envelope, envelope.s, *side};
            for (double& value : curve.y) value *= factor;
            panel.curves.push_back(std::move(curve));
        }
    }

    /// Adds a zone for each series of slipping nodes, from the midpoint before its first node to the midpoint after its
    /// last.
    void addZones() {
        std::vector<const BoltNodeFrame*> real;
        for (const BoltNodeFrame& node : now().nodes)
            if (node.real) real.push_back(&node);
        for (std::size_t i = 0; i < real.size(); ++i) {
            if (real[i]->state != NodeState::Slipping) continue;
            const double from = i == 0 ? real[i]->s : 0.5 * (real[i - 1]->s + real[i]->s);
            const double to = i + 1 == real.size() ? real[i]->s : 0.5 * (real[i]->s + real[i + 1]->s);
            auto& zones = chart_.chart.zones;
            if (!zones.empty() && zones.back().to == from) zones.back().to = to;
            else zones.push_back({from, to});
        }
    }

    /// Adds a divider where the bolt passes from one block to another. A gap between blocks gets one divider.
    void addDividers() {
        int block = -1;
        double left = 0.0;
        for (const BoltNodeFrame& node : now().nodes) {
            if (node.block < 0) continue;
            if (block >= 0 && node.block != block) chart_.chart.dividers.push_back(0.5 * (left + node.s));
            block = node.block;
            left = node.s;
        }
    }

    const RunSource& run_;
    std::size_t index_;
    int bolt_;
    Frame frame_;
    const BoltReach* known_;  // null: gathered from all frames up to this one
    BoltReach reach_;
    BoltChart chart_;
};

}  // namespace

BoltChart boltChart(const RunSource& run, std::size_t frame, int bolt) {
    return BoltChartBuilder(run, frame, bolt, nullptr).build();
}

BoltChart boltChart(const RunSource& run, std::size_t frame, const BoltReach& reach) {
    return BoltChartBuilder(run, frame, reach.bolt(), &reach).build();
}

namespace {

/// Largest axial force of a bolt in the run up to the frame; −1 if it was never installed. A damaged run file may hold a
/// peak that is not a number; it counts as none.
double loadOf(const Frame& frame, std::size_t bolt) {
    const double stored = bolt < frame.extremes.size() ? std::abs(frame.extremes[bolt].axialForce.value) : 0.0;
    const double peak = std::isnan(stored) ? 0.0 : stored;
    const bool isThere = frame.bolts[bolt].nodes.size() > 1;
    if (!isThere) return peak > 0.0 ? peak : -1.0;
    return std::max(peak, largest(frame.bolts[bolt], *findQuantity(BoltQuantity::AxialForce)));
}

}  // namespace

int mostLoadedBolt(const Frame& frame, int held) {
    constexpr double more = 1.5;  // another bolt must carry this many times the force of the current one
    int found = held >= 0 && static_cast<std::size_t>(held) < frame.bolts.size() ? held : -1;
    double most = found >= 0 ? more * loadOf(frame, static_cast<std::size_t>(found)) : -1.0;
    for (std::size_t b = 0; b < frame.bolts.size(); ++b)
        if (const double load = loadOf(frame, b); load > most) {
            most = load;
            found = static_cast<int>(b);
        }
    return found;
}

}  // namespace keyblock
