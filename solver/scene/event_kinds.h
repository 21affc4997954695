// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The only table of event kinds: files, JSON output, the timeline, lists and figures
// take their words, groups, marks and severities from it. A new kind needs an
// enumerator, a row and the code that reports it. The table belongs to the scene because
// a scene can request values at events, e.g. `first debonding opening`.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace keyblock {

enum class EventKind {
    JointSlip, JointOpen, Debonding, Restick, Yield, Hinge, TensileRupture, ShearRupture,
    PlateLoss, BoltLoss, PulledOut, BlockFalls, Collapse
};

/// Groups of kinds that are counted, shown and hidden together.
enum class EventGroup { Slip, Debonding, Restick, Yield, Rupture, Plate, PulledOut, Falls };

/// Symbols for events; each symbol has a shape and a colour.
enum class EventMark { Slip, Opening, Debonding, Restick, Yield, Rupture, Plate, PulledOut, Falls };

struct EventGroupRow {
    EventGroup group;
    std::string_view title;  // as shown to the user
    EventMark mark;
};

// Severities with a special meaning.
inline constexpr int minorSeverity = 0;  // no support is lost; occurs thousands of times, so is only counted
inline constexpr int graveSeverity = 3;  // from here on support is lost or rock falls; every picture must show it

struct EventKindRow {
    EventKind kind;
    std::string_view key;  // in files, tables, JSON and scene quantities
    std::string_view title, plural;  // as shown to the user; the plural follows a number
    EventGroup group;
    EventMark mark;
    int severity;  // if there is no room for all events, the most severe are shown
    std::string_view once, more;  // follows the bolt or block name, or a number; not for minor events
    bool isOfShear = false;  // true: the shear force is shown; false: the axial or normal force
};

/// All groups, in the order of `EventGroup`.
inline constexpr std::array eventGroups{
    EventGroupRow{EventGroup::Slip, "slip", EventMark::Slip},
    EventGroupRow{EventGroup::Debonding, "debonding", EventMark::Debonding},
    EventGroupRow{EventGroup::Restick, "re-stick", EventMark::Restick},
    EventGroupRow{EventGroup::Yield, "yield", EventMark::Yield},
    EventGroupRow{EventGroup::Rupture, "rupture", EventMark::Rupture},
    EventGroupRow{EventGroup::Plate, "plate", EventMark::Plate},
    EventGroupRow{EventGroup::PulledOut, "pull-out", EventMark::PulledOut},
    EventGroupRow{EventGroup::Falls, "block falls", EventMark::Falls}};

/// All kinds, in the order of `EventKind`.
inline constexpr std::array eventKinds{
    EventKindRow{EventKind::JointSlip, "joint-slip", "joint slip", "joint slips", EventGroup::Slip, EventMark::Slip,
                 minorSeverity, "", "", true},
    EventKindRow{EventKind::JointOpen, "joint-open", "joint opening", "joint openings", EventGroup::Slip,
                 EventMark::Opening, minorSeverity, "", ""},
    EventKindRow{EventKind::Debonding, "debonding", "debonding", "debondings", EventGroup::Debonding,
                 EventMark::Debonding, 1, "debonds at one node", "nodes debond"},
    EventKindRow{EventKind::Restick, "restick", "bond re-stick", "bond re-sticks", EventGroup::Restick,
                 EventMark::Restick, minorSeverity, "", ""},
    EventKindRow{EventKind::Yield, "yield", "yield", "yields", EventGroup::Yield, EventMark::Yield, 2, "yields",
                 "elements yield"},
    EventKindRow{EventKind::Hinge, "hinge", "plastic hinge", "plastic hinges", EventGroup::Yield, EventMark::Yield, 2,
                 "forms a plastic hinge", "plastic hinges"},
    EventKindRow{EventKind::TensileRupture, "tensile-rupture", "tensile rupture", "tensile ruptures",
                 EventGroup::Rupture, EventMark::Rupture, 5, "ruptures (tension)", "ruptures (tension)"},
    EventKindRow{EventKind::ShearRupture, "shear-rupture", "shear rupture", "shear ruptures", EventGroup::Rupture,
                 EventMark::Rupture, 5, "ruptures (shear)", "ruptures (shear)", true},
    EventKindRow{EventKind::PlateLoss, "plate-loss", "plate loss", "plate losses", EventGroup::Plate, EventMark::Plate,
                 graveSeverity, "loses its face plate", "losses of its face plate"},
    EventKindRow{EventKind::BoltLoss, "bolt-loss", "bolt loss", "bolt losses", EventGroup::Rupture, EventMark::Rupture,
                 5, "is lost", "losses"},
    EventKindRow{EventKind::PulledOut, "pulled-out", "pull-out", "pull-outs", EventGroup::PulledOut,
                 EventMark::PulledOut, 4, "has one node pulled out", "nodes pulled out"},
    EventKindRow{EventKind::BlockFalls, "block-falls", "block fall", "block falls", EventGroup::Falls, EventMark::Falls,
                 6, "falls", "falls"},
    EventKindRow{EventKind::Collapse, "collapse", "collapse", "collapses", EventGroup::Falls, EventMark::Falls, 6,
                 "collapse", "collapses"}};

/// The row of a kind or group. Throws if it has no row, i.e. if the table is incomplete.
constexpr const EventKindRow& rowOf(EventKind kind) { return eventKinds.at(static_cast<std::size_t>(kind)); }
constexpr const EventGroupRow& rowOf(EventGroup group) { return eventGroups.at(static_cast<std::size_t>(group)); }

constexpr bool isMinor(EventKind kind) { return rowOf(kind).severity == minorSeverity; }
constexpr bool isGrave(EventKind kind) { return rowOf(kind).severity >= graveSeverity; }

}  // namespace keyblock
