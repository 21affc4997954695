// SPDX-FileCopyrightText: The Keyblock contributors
// SPDX-License-Identifier: GPL-3.0-or-later
//
// The one table of event kinds: files, answers, the timeline, lists and figures take
// their words, groups, marks and severities from here. A new kind is an enumerator and
// a row, and the code that reports it. The table belongs to the scene because a scene
// requests numbers at events: `first debonding opening`.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

namespace keyblock {

enum class EventKind {
    JointSlip, JointOpen, Debonding, Restick, Yield, Hinge, TensileRupture, ShearRupture,
    PlateLoss, BoltLoss, PulledOut, BlockFalls, Collapse
};

/// Kinds that users count, show and hide as one.
enum class EventGroup { Slip, Debonding, Restick, Yield, Rupture, Plate, PulledOut, Falls };

/// The symbol of an event: its shape and colour.
enum class EventMark { Slip, Opening, Debonding, Restick, Yield, Rupture, Plate, PulledOut, Falls };

struct EventGroupRow {
    EventGroup group;
    std::string_view title;  // as users read it
    EventMark mark;
};

// Severities that code compares with.
inline constexpr int minorSeverity = 0;  // no support is lost; occurs by the thousand, so it is counted, not listed
inline constexpr int graveSeverity = 3;  // support is lost or rock falls, from here on: a picture must show it

struct EventKindRow {
    EventKind kind;
    std::string_view key;  // in files, tables, JSON and requests
    std::string_view title, plural;  // as users read it; the plural after a number
    EventGroup group;
    EventMark mark;
    int severity;  // where there is no room for all events, the most severe are shown
    std::string_view once, more;  // after the name of the bolt or block; `more` after a number. Not of minor events
    bool isOfShear = false;  // the force to show is the shear force, otherwise the axial or normal force
};

/// In the order of `EventGroup`.
inline constexpr std::array eventGroups{
    EventGroupRow{EventGroup::Slip, "slip", EventMark::Slip},
    EventGroupRow{EventGroup::Debonding, "debonding", EventMark::Debonding},
    EventGroupRow{EventGroup::Restick, "re-stick", EventMark::Restick},
    EventGroupRow{EventGroup::Yield, "yield", EventMark::Yield},
    EventGroupRow{EventGroup::Rupture, "rupture", EventMark::Rupture},
    EventGroupRow{EventGroup::Plate, "plate", EventMark::Plate},
    EventGroupRow{EventGroup::PulledOut, "pull-out", EventMark::PulledOut},
    EventGroupRow{EventGroup::Falls, "block falls", EventMark::Falls}};

/// In the order of `EventKind`.
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

/// The row of a kind. A kind without a row ends the program: the table is incomplete.
constexpr const EventKindRow& rowOf(EventKind kind) { return eventKinds.at(static_cast<std::size_t>(kind)); }
constexpr const EventGroupRow& rowOf(EventGroup group) { return eventGroups.at(static_cast<std::size_t>(group)); }

constexpr bool isMinor(EventKind kind) { return rowOf(kind).severity == minorSeverity; }
constexpr bool isGrave(EventKind kind) { return rowOf(kind).severity >= graveSeverity; }

}  // namespace keyblock
